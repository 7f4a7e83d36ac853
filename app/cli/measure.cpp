#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "app/cli/over_time.h"
#include "app/cli/progress.h"
#include "app/cli/run_objects.h"
#include "app/cli/session_warnings.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/measured.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {

struct MeasureOptions {
  std::string path, other;
  InputPaths inputs;  // of a mesh the volume alone
  VolumeSelection selection;
  std::vector<Vec3> between;
  std::vector<std::string> wallObjects;  // names; none: the mesh and --to, or its cavities
  bool wall = false, quiet = false, isAnonymous = false, saysUneven = false;
  std::string csv, json, sections;
};

//! A mesh that bounds a body. Throws InputError.
TriangleSoup readBody(const std::string& path, Certificate& certificate) {
  TriangleSoup mesh = readMesh(path);
  certificate = certify(mesh);
  if (!certificate.passes())
    throw InputError(path +
                     ": the mesh does not pass its certificate, and has no inside to measure; see `check`.");
  if (!certificate.boundsBody())
    throw InputError(path + ": components of the mesh lie where a body's cannot; see `check`.");
  return mesh;
}

void measureMesh(const MeasureOptions& o, Measured& m) {
  MeasuredObject& object = m.objects.emplace_back();
  object.name = o.path;
  object.mesh = readBody(o.path, object.certificate);
  std::optional<LoadedVolume> loaded;
  if (!o.inputs.volume.empty()) {
    loaded = loadVolume(o.inputs.volume, o.selection);
    for (const Finding& w : loaded->info.warnings)
      m.warnings.push_back({FindingKind::ofFile, {{"file", o.inputs.volume}}, w});
  }
  m.volume = o.inputs.volume;
  object.measures = objectMeasures(object.mesh, loaded ? &loaded->volume : nullptr);
}

std::vector<OutputFile> outputsOf(const MeasureOptions& o) {
  std::vector<OutputFile> files;
  if (!o.csv.empty()) files.push_back({"--csv", o.csv});
  if (!o.json.empty()) files.push_back({"--json", o.json});
  if (!o.sections.empty()) files.push_back({"--sections", o.sections});
  return files;
}

//! Two objects, by index.
using ObjectPair = std::optional<std::array<int, 2>>;

std::string quotedNames(const std::vector<Session>& sessions) {
  std::string names;
  for (const Session& session : sessions) names += (names.empty() ? "'" : ", '") + session.label.name + "'";
  return names;
}

//! The two whose wall is measured; none if that is no wall between objects. Throws OptionError.
ObjectPair pairOfWall(const MeasureOptions& o, const std::vector<Session>& sessions) {
  if (!o.wall) return std::nullopt;
  if (o.wallObjects.empty() && sessions.size() > 1)
    throw OptionError("--wall-thickness", o.path + " holds several objects; name two, OUTER and INNER, of " +
                                              quotedNames(sessions) + ".");
  if (o.wallObjects.empty()) return std::nullopt;
  const auto find = [&](const std::string& name) {
    for (int i = 0; i < static_cast<int>(sessions.size()); ++i)
      if (sessions[i].label.name == name) return i;
    throw OptionError("--wall-thickness", "no object of " + o.path + " has the name '" + name +
                                              "'; there is " + quotedNames(sessions) + ".");
  };
  return std::array{find(o.wallObjects[0]), find(o.wallObjects[1])};
}

//! Those of `replay`, whose objects and frame are taken: what it leaves out is left out.
std::vector<Finding> warningsOf(const MeasureOptions& o, std::vector<Session>& sessions) {
  const std::string version = sessions[0].version;
  std::vector<Finding> warnings = leaveOutUnseeded(sessions);
  for (Finding& other : warningsOfVersion(o.isAnonymous ? "SESSION" : o.path, version))
    warnings.push_back(std::move(other));
  if (!sessions[0].overTime) return warnings;
  chooseFrame(sessions[0]);
  warnings.push_back({FindingKind::oneFrameOfSeveral, {{"frame", *sessions[0].volume.selection.frame}}});
  return warnings;
}

//! Grows the objects of a session again. Returns the two of the wall.
ObjectPair measureSession(const MeasureOptions& o, Measured& m) {
  std::vector<Session> sessions = readSessions(o.path, o.inputs);
  m.warnings = warningsOf(o, sessions);
  const ObjectPair ofWall = pairOfWall(o, sessions);  // by the names that the session has
  if (o.isAnonymous) hideFileNames(sessions);
  if (o.selection.series) sessions[0].volume.selection.series = o.selection.series;
  m.volume = sessions[0].volume.path;
  m.placed = sessions[0].measurements;  // of the volume: each object has them
  for (const Session& session : sessions) checkWritable(outputsOf(o), inputsOf(session));
  LoadedSession first = load(std::move(sessions[0]));
  sessions.erase(sessions.begin());
  for (Session& session : sessions) session.volume = first.session.volume;
  const Volume volume = first.volume;
  RunOutputs none;
  none.quiet = o.quiet;
  for (GrownObject& grown : growObjects(std::move(first), std::move(sessions), none)) {
    MeasuredObject& object = m.objects.emplace_back();
    object.name = grown.report.session.label.name;
    object.mesh = std::move(grown.mesh);
    object.certificate = grown.report.mesh;
    object.measures = objectMeasures(object.mesh, &volume);
  }
  return ofWall;
}

void addGaps(const MeasureOptions& o, const TriangleSoup& other, Measured& m) {
  for (std::size_t j = 0; j < m.objects.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i)
      m.gaps.push_back(
          {m.objects[i].name, m.objects[j].name, surfaceGap(m.objects[i].mesh, m.objects[j].mesh)});
    if (!o.other.empty())
      m.gaps.push_back({m.objects[j].name, o.other, surfaceGap(m.objects[j].mesh, other)});
  }
}

void addWall(const MeasureOptions& o, const ObjectPair& pair, const TriangleSoup& other, Measured& m) {
  if (pair) {
    const MeasuredObject &outer = m.objects[(*pair)[0]], &inner = m.objects[(*pair)[1]];
    m.wall = MeasuredWall{outer.name, inner.name, wallThickness(outer.mesh, inner.mesh)};
    return;
  }
  const MeasuredObject& object = m.objects[0];
  if (!o.other.empty()) {
    m.wall = MeasuredWall{object.name, o.other, wallThickness(object.mesh, other)};
    return;
  }
  const auto [outer, inner] = outerAndInner(object.mesh);
  if (inner.triangles.empty())
    throw OptionError("--wall-thickness", o.path + " has no cavity; the second surface is given with --to.");
  m.wall = MeasuredWall{"the outer surface", "the cavities", wallThickness(outer, inner)};
}

//! In the object that holds the first point.
void addLine(const MeasureOptions& o, Measured& m) {
  CentreLineFault fault = CentreLineFault::firstOutside;
  for (const MeasuredObject& object : m.objects) {
    CentreLine line = centreLine(object.mesh, o.between[0], o.between[1]);
    if (!line.points.empty()) {
      m.line = MeasuredLine{object.name, std::move(line)};
      return;
    }
    if (fault == CentreLineFault::firstOutside) fault = line.fault;
  }
  throw UsageError(std::string("--between: ") + centreLineFaultText(fault) + ".");
}

void checkWallObjects(const MeasureOptions& o) {
  const std::vector<std::string>& names = o.wallObjects;
  if (names.empty()) return;
  const auto refuse = [](const std::string& reason) { throw OptionError("--wall-thickness", reason); };
  if (isMeshInputPath(o.path))
    refuse("names are of the objects of a session; the second surface of a mesh is given with --to.");
  if (names.size() < 2) refuse("'" + names[0] + "' is one name; give those of two objects, OUTER and INNER.");
  if (names.size() > 2) refuse("these are the names of more than two objects; give OUTER and INNER.");
  if (names[0] == names[1]) refuse("OUTER and INNER are both '" + names[0] + "'; give two objects.");
  if (!o.other.empty()) refuse("give the names of two objects or --to, not both.");
}

void check(const MeasureOptions& o) {
  std::vector<std::string> inputs{o.path};
  if (!o.inputs.volume.empty()) inputs.push_back(o.inputs.volume);
  if (!o.other.empty()) inputs.push_back(o.other);
  for (const auto* moved : {&o.inputs.walls, &o.inputs.starts})
    inputs.insert(inputs.end(), moved->begin(), moved->end());
  checkWritable(outputsOf(o), inputs);
  if (!o.sections.empty() && o.between.empty()) throw UsageError("--sections needs --between.");
  const bool isMesh = isMeshInputPath(o.path);
  if (isMesh && o.inputs.volume.empty() &&
      (o.selection.series || o.selection.frame || o.selection.spacing || o.saysUneven))
    throw UsageError("--series, --frame, --spacing and --uneven need --volume.");
  if (isMesh && !(o.inputs.walls.empty() && o.inputs.starts.empty()))
    throw UsageError("--walls and --start: a mesh has none; they are files of a session.");
  if (!isMesh && (o.selection.frame || o.selection.spacing || o.saysUneven))
    throw UsageError("--frame, --spacing and --uneven: a session says these itself.");
  checkWallObjects(o);
}

void write(const MeasureOptions& o, const Measured& m) {
  const DeferSignals whole;
  if (!o.csv.empty()) writeTextAtomically(o.csv, measuredCsv(m));
  if (!o.json.empty()) writeTextAtomically(o.json, measuredJson(m));
  if (!o.sections.empty()) writeTextAtomically(o.sections, sectionsCsv(m.line->line));
}

int measure(const MeasureOptions& o) {
  check(o);
  const PhaseLine line(o.quiet);
  Measured m;
  m.path = o.path;
  TriangleSoup other;
  Certificate certificate;
  if (!o.other.empty()) other = readBody(o.other, certificate);
  ObjectPair ofWall;
  if (isMeshInputPath(o.path))
    measureMesh(o, m);
  else
    ofWall = measureSession(o, m);
  for (const MeasuredObject& object : m.objects)
    for (const Finding& w : object.measures.warnings)
      m.warnings.push_back(m.objects.size() > 1 ? Finding(FindingKind::ofObject, {{"object", object.name}}, w)
                                                : w);
  addGaps(o, other, m);
  if (o.wall) addWall(o, ofWall, other, m);
  if (!o.between.empty()) addLine(o, m);
  // Meshes are called by their paths.
  if (o.isAnonymous) m = anonymous(std::move(m), {{o.path, "MESH"}, {o.other, "MESH2"}});
  write(o, m);
  std::fputs(measuredText(m).c_str(), stdout);
  return kDone;
}

void addWallThickness(CLI::App& command, CLI::Option* mesh, const std::shared_ptr<MeasureOptions>& options) {
  const auto set = [options, mesh](std::vector<std::string> names) {
    options->wall = true;
    std::erase(names, std::string());  // what the parser puts where there is none
    if (!names.empty() && mesh->count() == 0) {
      // MESH stands behind the option, which took it for a name.
      options->path = names.back();
      mesh->required(false);
      names.pop_back();
    }
    options->wallObjects = std::move(names);
  };
  command
      .add_option_function<std::vector<std::string>>("--wall-thickness", set,
                                                     "Thickness of the wall between the surface and that of "
                                                     "--to, or its own cavities; of a session with "
                                                     "several objects between two of them")
      ->type_name("[OUTER INNER]")
      ->expected(0, 3)  // with MESH
      ->allow_extra_args(false);
}

}  // namespace

void addMeasure(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(
      app, "measure", "Volume, area, diameters, intensities, distances, centre lines and wall thickness");
  auto options = std::make_shared<MeasureOptions>();
  CLI::Option* mesh =
      command
          ->add_option(
              "MESH", options->path,
              "A certified mesh (.stl .vtp .ply .obj .3mf .stl.dcm), or a session or report (JSON), which is "
              "grown again")
          ->required();
  command
      ->add_option("--volume", options->inputs.volume,
                   "The volume whose intensities are measured; of a session, where its volume is now")
      ->type_name("VOLUME");
  addMovedFiles(*command, options->inputs);
  addSelection(*command, options->selection);
  command
      ->add_option_function<std::vector<std::string>>(
          "--between",
          [options](const std::vector<std::string>& points) {
            for (const std::string& p : points) options->between.push_back(parseVector("--between", p));
          },
          "Centre line inside the object between two points (mm LPS), with the sections across it")
      ->type_name("X,Y,Z")
      ->expected(2)
      ->allow_extra_args(false);
  command->add_option("--sections", options->sections, "The sections of --between as a table")
      ->type_name("F.csv");
  command->add_option("--to", options->other, "Another mesh: the least distance to it, and where")
      ->type_name("MESH2");
  addWallThickness(*command, mesh, options);
  command->add_option("--csv", options->csv, "The table, a line per object, ruler and angle")
      ->type_name("F.csv");
  command->add_option("--json", options->json, "Everything as JSON")->type_name("F.json");
  command->add_flag("--quiet", options->quiet, "No progress");
  addAnonymous(*command, options->isAnonymous);
  command->callback([&action, options, command] {
    options->saysUneven = command->count("--uneven") > 0;
    action = [options] { return measure(*options); };
  });
}

}  // namespace handlebody::cli
