#include "app/cli/segment.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <memory>

#include "app/cli/clicks.h"
#include "app/cli/command.h"
#include "app/cli/object_groups.h"
#include "app/cli/parse.h"
#include "app/cli/run_objects.h"
#include "core/errors.h"
#include "core/io/parameter_names.h"

namespace handlebody::cli {

namespace {

constexpr int kAnyCount = std::numeric_limits<int>::max();
constexpr int kMostCandidates = 5;  // ActiveContour::candidates()
constexpr int kMostThreads =
    256;  // far above what helps; keeps a slip of the hand from exhausting the system

struct SegmentOptions {
  Session session;
  ClickTexts clicks;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
};

using Text = const std::string&;

double positive(Text option, Text text) {
  const double value = parseNumber(option, text);
  if (!(value > 0) || value == std::numeric_limits<double>::infinity())
    throw UsageError(option + ": '" + text + "' is not above 0.");
  return value;
}

double notNegative(Text option, Text text) {
  const double value = parseNumber(option, text);
  if (!(value >= 0) || value == std::numeric_limits<double>::infinity())
    throw UsageError(option + ": '" + text + "' is below 0 or infinite.");
  return value;
}

void setObject(Parameters& p, Text text) {
  const auto kind = objectKindFromName(text);
  if (!kind) throw UsageError("--object: '" + text + "' is not auto, dark or bright.");
  p.object = *kind;
}

void setDirection(Parameters& p, Text text) {
  const auto direction = directionFromName(text);
  if (!direction) throw UsageError("--direction: '" + text + "' is not outward or both.");
  p.direction = *direction;
}

void setBroadPhase(Parameters& p, Text text) {
  const auto phase = broadPhaseFromName(text);
  if (!phase) throw UsageError("--broad-phase: '" + text + "' is not hashing or sorted.");
  p.broadPhase = *phase;
}

void setSmoothing(Parameters& p, Text text) {
  if (text == "auto")
    p.smoothing.reset();
  else
    p.smoothing = notNegative("--smoothing", text);
}

void addInput(CLI::App& command, VolumeReference& volume) {
  command.add_option("VOLUME", volume.path, "A file, or a folder with a DICOM series")->required();
  addSelection(command, volume.selection);
}

void addClicks(CLI::App& command, ClickTexts& clicks) {
  const auto add = [&command](Text name, std::vector<std::string>& texts, Text type, Text help) {
    command.add_option(name, texts, help)->type_name(type)->expected(1)->take_all()->allow_extra_args(false);
  };
  add("--seed", clicks.seeds, "X,Y,Z[,R]",
      "A ball inside the object, LPS millimetres; may be given several times");
  add("--seed-ijk", clicks.voxelSeeds, "I,J,K[,R]", "The same in voxels; the radius in voxels of mean size");
  add("--background", clicks.background, "X,Y,Z[,R]",
      "A ball outside of the object, LPS millimetres: the surface may not go there; may be given several "
      "times");
  add("--background-ijk", clicks.voxelBackground, "I,J,K[,R]",
      "The same in voxels; the radius in voxels of mean size");
}

void addParameters(CLI::App& command, Parameters& p) {
  const auto add = [&command, &p](Text name, Text type, Text help, void (*set)(Parameters&, Text)) {
    command
        .add_option_function<std::string>(
            name, [&p, set](Text t) { set(p, t); }, help)
        ->type_name(type);
  };
  add("--object", "auto|dark|bright", "Against its surroundings", setObject);
  add("--range", "LO,HI", "Intensities of the object; inf and -inf are allowed",
      [](Parameters& q, Text t) { q.range = parseRange("--range", t); });
  add("--candidate", "N",
      "Which of the objects that the clicks may mean, 1 = the likeliest (default); the report lists them",
      [](Parameters& q, Text t) { q.candidate = parseInteger("--candidate", t, 1, kMostCandidates); });
  add("--smoothing", "auto|SIGMA", "Gaussian smoothing of the image, mm", setSmoothing);
  add("--edge-length", "MM", "Target edge length of the mesh",
      [](Parameters& q, Text t) { q.edgeLength = positive("--edge-length", t); });
  add("--direction", "outward|both", "Whether the surface may also shrink", setDirection);
  add("--balloon", "W", "Weight of the balloon force (default 1)",
      [](Parameters& q, Text t) { q.balloon = positive("--balloon", t); });
  add("--curvature", "W", "Weight of the curvature term (default 0.2)",
      [](Parameters& q, Text t) { q.curvature = notNegative("--curvature", t); });
  add("--max-iterations", "N", "Stop after so many (exit code 5)",
      [](Parameters& q, Text t) { q.maxIterations = parseInteger("--max-iterations", t, 1, kAnyCount); });
  add("--threads", "N", "The mesh does not depend on it (default 1)",
      [](Parameters& q, Text t) { q.threads = parseInteger("--threads", t, 1, kMostThreads); });
  add("--broad-phase", "hashing|sorted",
      "How near vertices are found: the paper's eight hash functions, or one sorted table (default); the "
      "mesh "
      "does not depend on it",
      setBroadPhase);
}

//! Given as often as one likes.
void addConstraint(CLI::App& command, Text name, Text type, Text help, std::function<void(Text)> add) {
  const auto addAll = [add](const std::vector<std::string>& texts) {
    for (Text text : texts) add(text);
  };
  command.add_option_function<std::vector<std::string>>(name, addAll, help)
      ->type_name(type)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void addConstraints(CLI::App& command, Constraints& c) {
  addConstraint(command, "--wall", "X,Y,Z,R",
                "A ball that the surface may not enter, LPS millimetres; may be given several times",
                [&c](Text t) { c.walls.balls.push_back(parseWall("--wall", t)); });
  addConstraint(command, "--wall-disc", "X,Y,Z,NX,NY,NZ,R",
                "A flat disc, by its middle (LPS millimetres), normal and radius, that the surface may not "
                "pass; may be given several times",
                [&c](Text t) { c.walls.discs.push_back(parseWallDisc("--wall-disc", t)); });
  command
      .add_option_function<std::string>(
          "--walls",
          [&c](Text path) {
            c.walls.map = WallMap{path, {}, nullptr};
          },
          "A label map on the volume's grid: the surface may not enter voxels that are not 0")
      ->type_name("LABELMAP");
  addConstraint(
      command, "--veto", "ITERATION:X,Y,Z",
      "The change of topology nearest to there in that step does not happen: the fronts rest; may be "
      "given several times",
      [&c](Text t) { c.vetoes.push_back(parseVeto("--veto", t)); });
  addConstraint(
      command, "--pin", "X,Y,Z,R@ITERATION",
      "What of the surface lies in that ball (LPS millimetres) at that iteration stays as it is from "
      "then on; may be given several times",
      [&c](Text t) { c.pins.push_back(parsePin("--pin", t)); });
  addConstraint(
      command, "--edit", "ITERATION:KIND:X,Y,Z",
      "That step is an edit in place of motion: close-tunnel (fill-tunnel, cut-handle: by which of its "
      "loops), remove-component, keep-component or fill-cavity, of what is nearest to there; smooth:X,Y,Z,R, "
      "pull:X,Y,Z,X2,Y2,Z2,R or cut:X,Y,Z,NX,NY,NZ[,R][,SIDE], as in `edit`; may be given several times",
      [&c](Text t) { c.edits.push_back(parseMeshEdit("--edit", t)); });
  const auto addLimit = [&command](Text name, int least, std::optional<int>& limit, Text help) {
    const auto set = [&limit, name, least](Text t) { limit = parseInteger(name, t, least, kAnyCount); };
    command.add_option_function<std::string>(name, set, help)->type_name("N");
  };
  addLimit("--components", 1, c.topology.components,
           "Never more components than this: changes that would make more are held");
  addLimit("--genus", 0, c.topology.genus, "Never more tunnels than this (of all components together)");
  addConstraint(
      command, "--allow", "X,Y,Z",
      "A change of topology there may break these limits, LPS millimetres (the report lists what was "
      "held, and where); may be given several times",
      [&c](Text t) { c.topology.allowed.push_back(parseVector("--allow", t)); });
}

int segment(SegmentOptions o) {
  Session& session = o.session;
  session.version = HANDLEBODY_VERSION;
  session.space = o.space.value_or(CoordinateSpace::lps);
  const Clicks clicks = parseClicks(o.clicks);
  assignResults(o.outputs, {chosenLabel(o.outputs.object, session.label)});
  checkOutputs(o.outputs, inputsOf(session));

  LoadedSession loaded = load(std::move(session));
  loaded.session.seeds = seedsInWorld(clicks, loaded.volume.grid);
  return run(std::move(loaded), o.outputs);
}

//! What concerns the whole run.
void addRunOptions(CLI::App& command, SegmentOptions& options) {
  addInput(command, options.session.volume);
  addRunOutputs(command, options.outputs);
  addSpace(command, options.space);
  addOnLeak(command, options.outputs.onLeak);
}

//! What each of several objects has of its own.
void addOwnOptions(CLI::App& command, SegmentOptions& options) {
  addClicks(command, options.clicks);
  addParameters(command, options.session.requested);
  addConstraints(command, options.session.constraints);
  addObjectOptions(command, options.outputs.object);
}

void addOptions(CLI::App& command, SegmentOptions& options) {
  addRunOptions(command, options);
  addOwnOptions(command, options);
}

void parse(CLI::App& command, const std::vector<std::string>& arguments) try {
  command.parse(
      std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes them from the back
} catch (const CLI::ParseError& error) {
  throw UsageError(error.what());
}

OptionKind kindOf(const CLI::App& command, Text name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  if (!option) return OptionKind::unknown;
  return option->get_items_expected_max() == 0 ? OptionKind::flag : OptionKind::value;
}

void prepend(std::vector<std::string>& texts, const std::vector<std::string>& before) {
  texts.insert(texts.begin(), before.begin(), before.end());
}

//! The options of one object, whose own ones stand against the common ones or are added to them.
SegmentOptions parseOwn(const std::vector<std::string>& arguments, const SegmentOptions& common) {
  SegmentOptions options = common;
  options.clicks = {};
  CLI::App command;
  addOwnOptions(command, options);
  parse(command, arguments);
  prepend(options.clicks.background, common.clicks.background);
  prepend(options.clicks.voxelBackground, common.clicks.voxelBackground);
  return options;
}

//! Label values that are not given are the smallest that are free.
std::vector<ObjectLabel> labelsOf(const std::vector<SegmentOptions>& objects) {
  std::vector<ObjectLabel> labels;
  std::vector<int> taken;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    ObjectLabel label;
    label.colour = distinctColours()[i % distinctColours().size()];
    label.value = 0;
    labels.push_back(chosenLabel(objects[i].outputs.object, label));
    taken.push_back(labels.back().value);
  }
  for (ObjectLabel& label : labels)
    if (label.value == 0) taken.push_back(label.value = freeLabelValue(taken));
  requireDistinct(labels);
  return labels;
}

//! Several objects as they were asked for.
struct SeveralObjects {
  SegmentOptions run;
  std::vector<Session> sessions;  //!< without seeds
  std::vector<Clicks> clicks;
};

SeveralObjects parseSeveral(const std::vector<std::string>& arguments) {
  SeveralObjects all;
  CLI::App known, command;
  SegmentOptions unused;
  addOwnOptions(known, unused);
  const ObjectGroups groups = groupArguments(arguments, [&](Text name) { return kindOf(known, name); });
  addRunOptions(command, all.run);
  parse(command, groups.run);
  const SegmentOptions common = parseOwn(groups.common, {});
  if (!common.clicks.seeds.empty() || !common.clicks.voxelSeeds.empty())
    throw UsageError("A seed before the first --object-name belongs to no object.");
  std::vector<SegmentOptions> objects;
  for (const auto& group : groups.objects) objects.push_back(parseOwn(group, common));
  const std::vector<ObjectLabel> labels = labelsOf(objects);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Session session = objects[i].session;
    session.version = HANDLEBODY_VERSION;
    session.space = all.run.space.value_or(CoordinateSpace::lps);
    session.volume = all.run.session.volume;
    session.label = labels[i];
    all.sessions.push_back(std::move(session));
    try {
      all.clicks.push_back(parseClicks(objects[i].clicks));
    } catch (const UsageError& error) {
      throw UsageError("object '" + labels[i].name + "': " + error.what());
    }
  }
  assignResults(all.run.outputs, labels);
  return all;
}

int segmentSeveral(SeveralObjects all) {
  std::vector<std::string> inputs;
  for (const Session& session : all.sessions)
    for (const std::string& path : inputsOf(session)) inputs.push_back(path);
  checkOutputs(all.run.outputs, inputs);
  LoadedSession first = load(std::move(all.sessions[0]));
  first.session.seeds = seedsInWorld(all.clicks[0], first.volume.grid);
  std::vector<Session> others;
  for (std::size_t i = 1; i < all.sessions.size(); ++i) {
    all.sessions[i].volume = first.session.volume;
    all.sessions[i].seeds = seedsInWorld(all.clicks[i], first.volume.grid);
    others.push_back(std::move(all.sessions[i]));
  }
  return runObjects(std::move(first), std::move(others), all.run.outputs);
}

}  // namespace

std::vector<SegmentOption> segmentOptions() {
  CLI::App command;
  SegmentOptions values;
  addOptions(command, values);
  std::vector<SegmentOption> options;
  for (const CLI::Option* option : command.get_options())
    if (const auto& names = option->get_lnames(); !names.empty() && names[0] != "help")
      options.push_back({names[0], option->get_type_name(), option->get_items_expected_max() == 0,
                         option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll});
  return options;
}

void checkSegmentArguments(const std::vector<std::string>& arguments) {
  CLI::App command;
  SegmentOptions options;
  addOptions(command, options);
  parse(command, arguments);
  parseClicks(options.clicks);
  for (const std::string& path : options.outputs.results) checkResultExtension({"--output", path});
}

Action segmentSeveralObjects(const std::vector<std::string>& arguments) {
  return [all = parseSeveral(arguments)] { return segmentSeveral(all); };
}

void addSegment(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "segment", "Grow a surface from seeds in a volume");
  auto options = std::make_shared<SegmentOptions>();
  addOptions(*command, *options);
  command->callback([&action, options] { action = [options] { return segment(*options); }; });
}

}  // namespace handlebody::cli
