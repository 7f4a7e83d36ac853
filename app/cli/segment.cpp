#include "app/cli/segment.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/cli/frame_files.h"
#include "app/cli/object_groups.h"
#include "app/cli/over_time.h"
#include "app/cli/progress.h"
#include "app/cli/run_objects.h"
#include "core/errors.h"
#include "core/io/report/clicks.h"
#include "core/io/report/growth_options.h"
#include "core/io/report/label_file.h"
#include "core/io/report/option_effects.h"
#include "core/io/report/option_error.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/wall_map.h"
#include "core/version.h"

namespace handlebody::cli {

namespace {

struct SegmentOptions {
  Session session;
  ClickTexts clicks;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
  OverTimeOptions overTime;
  std::vector<std::string> given{};  //!< the long options that stand on the command line: "--edge-length"
};

using Text = const std::string&;

//! Throws UsageError; a surface to begin with is as good as a seed.
std::vector<Click> clicksOf(const SegmentOptions& o) {
  const auto& start = o.session.constraints.start;
  if (start && start->path.empty())
    throw UsageError(
        "--start-label says which voxels of a label map are meant, --start-smooth, --start-keep-largest and "
        "--start-genus how they become a surface: give that map with --start or --given.");
  if (hasNoSeed(o.clicks) && !start) throw UsageError("segment needs a --seed or --seed-ijk.");
  return parseClicks(o.clicks);
}

void addInput(CLI::App& command, VolumeReference& volume) {
  command.add_option("VOLUME", volume.path, "A file, or a folder with a DICOM series")->required();
  addSelection(command, volume.selection);
}

void addClicks(CLI::App& command, ClickTexts& clicks) {
  // Called for each as it stands on the command line: the options share one list, which keeps that order.
  const auto add = [&](const std::string& name, Text type, Text help) {
    const auto append = [&clicks, name](const std::vector<std::string>& texts) {
      for (Text text : texts) clicks.push_back({name, text});
    };
    command.add_option_function<std::vector<std::string>>(name, append, help)
        ->type_name(type)
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false)
        ->trigger_on_parse();
  };
  add("--seed", "X,Y,Z[,R]", "A ball inside the object, LPS millimetres; may be given several times");
  add("--seed-ijk", "I,J,K[,R]", "The same in voxels; the radius in voxels of mean size");
  add("--background", "X,Y,Z[,R]",
      "A ball outside of the object, LPS millimetres: the surface may not go there; may be given several "
      "times");
  add("--background-ijk", "I,J,K[,R]", "The same in voxels; the radius in voxels of mean size");
}

//! One of those that Python has, too.
void addGrowthOption(CLI::App& command, const GrowthOption& option, Session& session) {
  const auto set = [&](Text text) { option.set(session.requested, session.constraints, text); };
  if (!option.isRepeated) {
    command.add_option_function<std::string>(option.name, set, option.help)->type_name(option.type);
    return;
  }
  const auto setAll = [set](const std::vector<std::string>& texts) {
    for (Text text : texts) set(text);
  };
  command.add_option_function<std::vector<std::string>>(option.name, setAll, option.help)
      ->type_name(option.type)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

[[noreturn]] void refuseToAsk() {
  throw UsageError("--on-held has no limit to hold: give --components or --genus.");
}

//! Of the whole run, if nothing grows in it.
void requireEffectOnGiven(const SegmentOptions& o) {
  for (const char* name : {"--on-leak", "--on-held", "--list-candidates"})
    if (std::find(o.given.begin(), o.given.end(), name) != o.given.end())
      throw OptionError(name, FindingKind::noEffectOnGiven, " ");
}

int segment(SegmentOptions o) {
  const PhaseLine line(o.outputs.quiet);
  requireEffect(o.given, o.session.constraints);
  if (isGiven(o.session)) requireEffectOnGiven(o);
  Session& session = o.session;
  if (!letAsk(o.outputs.onHeld, session.constraints) && o.outputs.onHeld != OnHeld::hold) refuseToAsk();
  session.version = HANDLEBODY_VERSION;
  session.space = o.space.value_or(CoordinateSpace::lps);
  session.polish = o.outputs.polish.value_or(true);
  const std::vector<Click> clicks = clicksOf(o);
  if (auto& start = session.constraints.start) {
    findByName(*start);
    session.label = asInItsFile(start->path, start->label, o.outputs.content.anonymous, session.label);
  }
  assignResults(o.outputs, {chosenLabel(o.outputs.object, session.label)});
  session.overTime = requestOf(o.overTime);
  if (session.overTime && o.outputs.onHeld != OnHeld::hold)
    throw UsageError("--on-held pause and stop are for a single frame: --frames asks nobody.");
  if (session.overTime) {
    if (session.constraints.start)
      throw UsageError("--frames carries what has grown from seeds, not a surface of --start or --given.");
    chooseFrame(session);
    checkOverTime(session, o.outputs, o.overTime, inputsOf(session));
  } else {
    checkOutputs(o.outputs, inputsOf(session));
  }
  checkSpace(o.space, o.outputs.results, o.outputs.session);
  checkEffect(o.outputs.content, o.outputs.mesherSeconds, o.outputs.results);

  LoadedSession loaded = load(std::move(session), o.outputs.content.anonymous);
  loaded.session.seeds = seedsInWorld(clicks, loaded.volume.grid);
  if (loaded.session.overTime) return runOverTime(std::move(loaded), o.outputs, o.overTime);
  loadStarts(loaded.session);
  requireGivenHolds(loaded.session.constraints, loaded.volume.grid);
  return run(std::move(loaded), o.outputs);
}

//! What concerns the whole run.
void addRunOptions(CLI::App& command, SegmentOptions& options) {
  addInput(command, options.session.volume);
  addRunOutputs(command, options.outputs);
  addSpace(command, options.space);
  addOnLeak(command, options.outputs.onLeak);
  addOnHeld(command, options.outputs.onHeld);
  addOverTime(command, options.overTime);
}

//! What each of several objects has of its own.
void addOwnOptions(CLI::App& command, SegmentOptions& options) {
  addClicks(command, options.clicks);
  for (const auto* known : {&parameterOptions(), &constraintOptions()})
    for (const GrowthOption& option : *known) addGrowthOption(command, option, options.session);
  addObjectOptions(command, options.outputs.object);
}

void addOptions(CLI::App& command, SegmentOptions& options) {
  addRunOptions(command, options);
  addOwnOptions(command, options);
}

void parse(CLI::App& command, const std::vector<std::string>& arguments) try {
  checkPaths(command);
  command.parse(
      std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes them from the back
} catch (const CLI::ParseError& error) {
  throw UsageError(error.what());
}

//! The long names of what has been parsed.
std::vector<std::string> givenIn(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && !option->get_lnames().empty()) names.push_back("--" + option->get_lnames()[0]);
  return names;
}

OptionKind kindOf(const CLI::App& command, Text name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  if (!option) return OptionKind::unknown;
  return option->get_items_expected_max() == 0 ? OptionKind::flag : OptionKind::value;
}

//! The options of one object, whose own ones stand against the common ones or are added to them.
SegmentOptions parseOwn(const std::vector<std::string>& arguments, const SegmentOptions& common) {
  SegmentOptions options = common;
  options.clicks = {};
  CLI::App command;
  addOwnOptions(command, options);
  parse(command, arguments);
  options.given = givenIn(command);
  options.clicks.insert(options.clicks.begin(), common.clicks.begin(), common.clicks.end());
  return options;
}

//! Label values that are not given are the smallest that are free.
std::vector<ObjectLabel> labelsOf(std::vector<SegmentOptions>& objects) {
  std::vector<ObjectLabel> labels;
  std::vector<int> taken;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    ObjectLabel label;
    label.colour = distinctColours()[i % distinctColours().size()];
    label.value = 0;
    if (auto& start = objects[i].session.constraints.start) {
      findByName(*start);
      label = asInItsFile(start->path, start->label, false, label);  // each has a name that was given
    }
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
  std::vector<std::vector<Click>> clicks;
  std::vector<Constraints> own;  //!< those that are certainly meant for the object
};

//! Does the work for one object, whose name then stands before what is wrong.
template <typename F>
void naming(Text name, F&& work) try {
  work();
} catch (const UsageError& error) {
  throw UsageError("object '" + name + "': " + error.what());
}

//! What stands before the first name may be meant for other objects, unless there are none but given ones.
//! Throws UsageError for what can have no effect.
Constraints ownOf(const SegmentOptions& object, const std::vector<std::string>& group,
                  const SegmentOptions& common, bool areAllGiven) {
  Constraints own = object.session.constraints;
  std::vector<std::string> names = object.given;
  if (areAllGiven) {
    names.insert(names.end(), common.given.begin(), common.given.end());
  } else {
    own = parseOwn(group, {}).session.constraints;
    own.start = object.session.constraints.start;
    own.edits = object.session.constraints.edits;
    if (!isGiven(object.session) && common.session.requested.range) names.emplace_back("--range");
  }
  requireEffect(names, own);
  return own;
}

SeveralObjects parseSeveral(const std::vector<std::string>& arguments) {
  SeveralObjects all;
  CLI::App known, command;
  SegmentOptions unused;
  addOwnOptions(known, unused);
  const ObjectGroups groups = groupArguments(arguments, [&](Text name) { return kindOf(known, name); });
  addRunOptions(command, all.run);
  parse(command, groups.run);
  all.run.given = givenIn(command);
  if (requestOf(all.run.overTime))
    throw UsageError("--frames carries a single object; grow the others one by one.");
  const SegmentOptions common = parseOwn(groups.common, {});
  if (!hasNoSeed(common.clicks))
    throw UsageError("A seed before the first --object-name belongs to no object.");
  if (common.session.constraints.start && !common.session.constraints.start->called.empty())
    throw UsageError("--start-label before the first --object-name belongs to no object.");
  std::vector<SegmentOptions> objects;
  for (const auto& group : groups.objects) objects.push_back(parseOwn(group, common));
  const std::vector<ObjectLabel> labels = labelsOf(objects);
  requireEffect(common.given, {});
  const bool areAllGiven =
      std::all_of(objects.begin(), objects.end(), [](const auto& o) { return isGiven(o.session); });
  if (areAllGiven) requireEffectOnGiven(all.run);
  bool isAsking = all.run.outputs.onHeld == OnHeld::hold;
  for (SegmentOptions& o : objects)
    if (letAsk(all.run.outputs.onHeld, o.session.constraints)) isAsking = true;
  if (!isAsking) refuseToAsk();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Session session = objects[i].session;
    session.version = HANDLEBODY_VERSION;
    session.space = all.run.space.value_or(CoordinateSpace::lps);
    session.polish = all.run.outputs.polish.value_or(true);
    session.volume = all.run.session.volume;
    session.label = labels[i];
    all.sessions.push_back(std::move(session));
    naming(labels[i].name, [&] {
      all.clicks.push_back(clicksOf(objects[i]));
      all.own.push_back(ownOf(objects[i], groups.objects[i], common, areAllGiven));
    });
  }
  assignResults(all.run.outputs, labels);
  return all;
}

//! Of given objects and what is certainly meant for them.
void requireGivenHold(SeveralObjects& all, LoadedSession& first) {
  std::vector<Session*> sessions{&first.session};
  for (std::size_t i = 1; i < all.sessions.size(); ++i) sessions.push_back(&all.sessions[i]);
  loadStarts(sessions);
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (!isGiven(*sessions[i])) continue;
    Session own;
    own.volume = first.session.volume;
    own.constraints = all.own[i];
    own.constraints.start = sessions[i]->constraints.start;
    loadWalls(own, first.volume.grid);
    naming(sessions[i]->label.name, [&] { requireGivenHolds(own.constraints, first.volume.grid); });
  }
}

int segmentSeveral(SeveralObjects all) {
  const PhaseLine line(all.run.outputs.quiet);
  std::vector<std::string> inputs;
  for (const Session& session : all.sessions)
    for (const std::string& path : inputsOf(session)) inputs.push_back(path);
  checkOutputs(all.run.outputs, inputs);
  const RunOutputs& outputs = all.run.outputs;
  checkSpace(all.run.space, outputs.results, outputs.session);
  checkEffect(outputs.content, outputs.mesherSeconds, outputs.results);
  LoadedSession first = load(std::move(all.sessions[0]), all.run.outputs.content.anonymous);
  first.session.seeds = seedsInWorld(all.clicks[0], first.volume.grid);
  std::vector<Session> others;
  for (std::size_t i = 1; i < all.sessions.size(); ++i) {
    all.sessions[i].volume = first.session.volume;
    all.sessions[i].seeds = seedsInWorld(all.clicks[i], first.volume.grid);
  }
  requireGivenHold(all, first);
  for (std::size_t i = 1; i < all.sessions.size(); ++i) others.push_back(std::move(all.sessions[i]));
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
  clicksOf(options);
  requireEffect(givenIn(command), options.session.constraints);
  checkEffect(options.outputs.content, options.outputs.mesherSeconds, options.outputs.results);
  const bool isOverTime = requestOf(options.overTime).has_value();
  for (const std::string& path : options.outputs.results)
    if (isOverTime)
      checkFrameFile("--output", path);
    else
      checkResultExtension({"--output", path});
}

Action segmentSeveralObjects(const std::vector<std::string>& arguments) {
  return [all = parseSeveral(arguments)] { return segmentSeveral(all); };
}

void addSegment(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "segment", "Grow a surface from seeds in a volume");
  auto options = std::make_shared<SegmentOptions>();
  addOptions(*command, *options);
  command->callback([&action, options, command] {
    options->given = givenIn(*command);
    action = [options] { return segment(*options); };
  });
}

}  // namespace handlebody::cli
