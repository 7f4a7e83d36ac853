#include "core/io/report/growth_options.h"

#include <limits>

#include "core/io/report/option_error.h"
#include "core/io/report/parameter_names.h"
#include "core/io/report/parse.h"

namespace handlebody {

namespace {

constexpr int kAnyCount = std::numeric_limits<int>::max();
constexpr int kMaxCandidates = 5;  // ActiveContour::candidates()
constexpr int kMaxThreads = 256;  // far above what helps; keeps a slip of the hand from exhausting the system

using Text = const std::string&;

double positive(Text option, Text text) {
  const double value = parseNumber(option, text);
  if (!(value > 0) || value == std::numeric_limits<double>::infinity())
    throw OptionError(option, "'" + text + "' is not above 0.");
  return value;
}

double notNegative(Text option, Text text) {
  const double value = parseNumber(option, text);
  if (!(value >= 0) || value == std::numeric_limits<double>::infinity())
    throw OptionError(option, "'" + text + "' is below 0 or infinite.");
  return value;
}

void setObject(Parameters& p, Text text) {
  const auto kind = objectKindFromName(text);
  if (!kind) throw OptionError("--object", "'" + text + "' is not auto, dark or bright.");
  p.object = *kind;
}

void setDirection(Parameters& p, Text text) {
  const auto direction = directionFromName(text);
  if (!direction) throw OptionError("--direction", "'" + text + "' is not outward or both.");
  p.direction = *direction;
}

void setBroadPhase(Parameters& p, Text text) {
  const auto phase = broadPhaseFromName(text);
  if (!phase) throw OptionError("--broad-phase", "'" + text + "' is not hashing or sorted.");
  p.broadPhase = *phase;
}

void setResolution(Parameters& p, Text text) {
  const auto resolution = resolutionFromName(text);
  if (!resolution) throw OptionError("--resolution", "'" + text + "' is not auto, adaptive or uniform.");
  p.resolution = *resolution;
}

void setSmoothing(Parameters& p, Text text) {
  if (text == "auto")
    p.smoothing.reset();
  else
    p.smoothing = notNegative("--smoothing", text);
}

GrowthOption parameter(Text name, Text type, Text help, void (*set)(Parameters&, Text)) {
  return {name, type, help, false, [set](Parameters& p, Constraints&, Text t) { set(p, t); }};
}

GrowthOption repeated(Text name, Text type, Text help, void (*add)(Constraints&, Text)) {
  return {name, type, help, true, [add](Parameters&, Constraints& c, Text t) { add(c, t); }};
}

GrowthOption limit(Text name, int least, std::optional<int> TopologyLimits::*which, Text help) {
  return {name, "N", help, false, [=](Parameters&, Constraints& c, Text t) {
            c.topology.*which = parseInteger(name, t, least, kAnyCount);
          }};
}

std::vector<GrowthOption> makeParameterOptions() {
  return {
      parameter("--object", "auto|dark|bright", "Against its surroundings", setObject),
      parameter("--range", "LO,HI", "Intensities of the object; inf and -inf are allowed",
                [](Parameters& p, Text t) { p.range = parseRange("--range", t); }),
      parameter(
          "--candidate", "N",
          "Which of the objects that the clicks may mean, 1 = the likeliest (default); the report lists them",
          [](Parameters& p, Text t) { p.candidate = parseInteger("--candidate", t, 1, kMaxCandidates); }),
      parameter("--smoothing", "auto|SIGMA", "Gaussian smoothing of the image, mm", setSmoothing),
      parameter("--edge-length", "MM", "Target edge length of the mesh",
                [](Parameters& p, Text t) { p.edgeLength = positive("--edge-length", t); }),
      parameter("--direction", "outward|both", "Whether the surface may also shrink", setDirection),
      parameter("--balloon", "W", "Weight of the balloon force (default 1)",
                [](Parameters& p, Text t) { p.balloon = positive("--balloon", t); }),
      parameter("--curvature", "W", "Weight of the curvature term (default 0.2)",
                [](Parameters& p, Text t) { p.curvature = notNegative("--curvature", t); }),
      parameter(
          "--max-iterations", "N", "Stop after so many (exit code 5)",
          [](Parameters& p, Text t) { p.maxIterations = parseInteger("--max-iterations", t, 1, kAnyCount); }),
      parameter("--threads", "N", "The mesh does not depend on it (default: all of the machine)",
                [](Parameters& p, Text t) { p.threads = parseInteger("--threads", t, 1, kMaxThreads); }),
      parameter("--broad-phase", "hashing|sorted",
                "How near vertices are found: the paper's eight hash functions, or one sorted table "
                "(default); the mesh does not depend on it",
                setBroadPhase),
      parameter("--resolution", "auto|adaptive|uniform",
                "adaptive: edges and steps up to four times as long where the image shows no boundary near "
                "by; uniform: the same everywhere; auto (default): adaptive in objects that are wide for "
                "their edges",
                setResolution),
  };
}

std::vector<GrowthOption> wallOptions() {
  return {
      repeated("--wall", "X,Y,Z,R",
               "A ball that the surface may not enter, LPS millimetres; may be given several times",
               [](Constraints& c, Text t) { c.walls.balls.push_back(parseWall("--wall", t)); }),
      repeated("--wall-disc", "X,Y,Z,NX,NY,NZ,R",
               "A flat disc, by its middle (LPS millimetres), normal and radius, that the surface may not "
               "pass; may be given several times",
               [](Constraints& c, Text t) { c.walls.discs.push_back(parseWallDisc("--wall-disc", t)); }),
      {"--walls", "LABELMAP",
       "A label map on the volume's grid: the surface may not enter voxels that are not 0", false,
       [](Parameters&, Constraints& c, Text path) {
         c.walls.map = WallMap{path, {}, nullptr};
       }},
  };
}

StartSurface& startOf(Constraints& c) { return c.start ? *c.start : c.start.emplace(); }

//! --start and --given exclude each other; what says more of them may stand before or behind.
void setStart(Constraints& c, Text option, Text path, bool isDone) {
  if (c.start && !c.start->path.empty() && c.start->isDone != isDone)
    throw OptionError(option, FindingKind::startAndGiven);
  StartSurface start;
  start.path = path;
  start.isDone = isDone;
  if (c.start && !c.start->mesh) {
    start.called = c.start->called;
    start.shape = c.start->shape;
  }
  c.start = std::move(start);
}

std::vector<GrowthOption> startOptions() {
  return {
      {"--start", "MESH|LABELMAP",
       "The surface begins as this one in place of a sphere, and grows onto the image from there; with "
       "--direction both it gives ground, too; needs no --seed",
       false, [](Parameters&, Constraints& c, Text t) { setStart(c, "--start", t, false); }},
      {"--given", "MESH|LABELMAP",
       "The object is this surface as it is: a wall for the objects after it, written with them; needs no "
       "--seed",
       false, [](Parameters&, Constraints& c, Text t) { setStart(c, "--given", t, true); }},
      {"--start-label", "N|NAME",
       "The label of that map that is meant, by its number or as the file calls it (default: all but 0)",
       false,
       [](Parameters&, Constraints& c, Text t) {
         startOf(c).called = parseLabel("--start-label", t, 1, kAnyCount);
       }},
      {"--start-smooth", "MM",
       "Smoothing of the surface of that label (default: a voxel along each axis; 0: none, steps and all)",
       false,
       [](Parameters&, Constraints& c, Text t) {
         startOf(c).shape.smoothing = notNegative("--start-smooth", t);
       }},
      {"--start-keep-largest", "on|off", "Only the largest 6-connected part of that label (default off)",
       false,
       [](Parameters&, Constraints& c, Text t) {
         if (t != "on" && t != "off")
           throw OptionError("--start-keep-largest", "'" + t + "' is not on or off.");
         startOf(c).shape.keepsLargest = t == "on";
       }},
      {"--start-genus", "G", "Close or cut tunnels of that label until no more than G are left", false,
       [](Parameters&, Constraints& c, Text t) {
         startOf(c).shape.genus = parseInteger("--start-genus", t, 0, kAnyCount);
       }},
  };
}

std::vector<GrowthOption> changeOptions() {
  return {
      repeated("--veto", "ITERATION:X,Y,Z",
               "The change of topology nearest to there in that step does not happen: the fronts rest; may "
               "be given several times",
               [](Constraints& c, Text t) { c.vetoes.push_back(parseVeto("--veto", t)); }),
      repeated("--pin", "X,Y,Z,R@ITERATION",
               "What of the surface lies in that ball (LPS millimetres) at that iteration stays as it is "
               "from then on; may be given several times",
               [](Constraints& c, Text t) { c.pins.push_back(parsePin("--pin", t)); }),
      repeated("--edit", "ITERATION:KIND:X,Y,Z",
               "That step is an edit in place of motion: close-tunnel (fill-tunnel, cut-handle: by which of "
               "its loops), remove-component, keep-component or fill-cavity, of what is nearest to there; "
               "smooth:X,Y,Z,R, pull:X,Y,Z,X2,Y2,Z2,R or cut:X,Y,Z,NX,NY,NZ[,R][,SIDE], as in `edit`; may "
               "be given several times",
               [](Constraints& c, Text t) { c.edits.push_back(parseMeshEdit("--edit", t)); }),
      limit("--components", 1, &TopologyLimits::components,
            "Never more components than this: changes that would make more are held"),
      limit("--genus", 0, &TopologyLimits::genus,
            "Never more tunnels than this (of all components together)"),
      repeated("--allow", "X,Y,Z",
               "A change of topology there may break these limits, LPS millimetres (the report lists what "
               "was held, and where); may be given several times",
               [](Constraints& c, Text t) { c.topology.allowed.push_back(parseVector("--allow", t)); }),
      repeated("--hold", "X,Y,Z",
               "What is held there for these limits is held on, and --on-held does not ask about it, LPS "
               "millimetres; may be given several times",
               [](Constraints& c, Text t) { c.topology.kept.push_back(parseVector("--hold", t)); }),
  };
}

std::vector<GrowthOption> makeConstraintOptions() {
  std::vector<GrowthOption> all = wallOptions();
  for (auto* more : {&startOptions, &changeOptions})
    for (GrowthOption& option : more()) all.push_back(std::move(option));
  return all;
}

}  // namespace

const std::vector<GrowthOption>& parameterOptions() {
  static const std::vector<GrowthOption> options = makeParameterOptions();
  return options;
}

const std::vector<GrowthOption>& constraintOptions() {
  static const std::vector<GrowthOption> options = makeConstraintOptions();
  return options;
}

const GrowthOption* findGrowthOption(const std::string& name) {
  for (const auto* options : {&parameterOptions(), &constraintOptions()})
    for (const GrowthOption& option : *options)
      if (option.name == name) return &option;
  return nullptr;
}

}  // namespace handlebody
