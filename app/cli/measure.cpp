#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "app/cli/run_objects.h"
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
  std::string path, volume, other;
  VolumeSelection selection;
  std::vector<Vec3> between;
  bool wall = false, isAnonymous = false;
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
  if (!o.volume.empty()) {
    loaded = loadVolume(o.volume, o.selection);
    for (const Finding& w : loaded->info.warnings)
      m.warnings.push_back({FindingKind::ofFile, {{"file", o.volume}}, w});
  }
  m.volume = o.volume;
  object.measures = objectMeasures(object.mesh, loaded ? &loaded->volume : nullptr);
}

std::vector<OutputFile> outputsOf(const MeasureOptions& o) {
  std::vector<OutputFile> files;
  if (!o.csv.empty()) files.push_back({"--csv", o.csv});
  if (!o.json.empty()) files.push_back({"--json", o.json});
  if (!o.sections.empty()) files.push_back({"--sections", o.sections});
  return files;
}

//! Grows the objects of a session again.
void measureSession(const MeasureOptions& o, Measured& m) {
  std::vector<Session> sessions = readSessions(o.path, {o.volume, {}, {}});
  std::erase_if(sessions, [](const Session& session) { return !isSeeded(session); });
  if (o.isAnonymous) hideFileNames(sessions);
  if (o.selection.series) sessions[0].volume.selection.series = o.selection.series;
  m.volume = sessions[0].volume.path;
  m.placed = sessions[0].measurements;  // of the volume: each object has them
  for (const Session& session : sessions) checkWritable(outputsOf(o), inputsOf(session));
  LoadedSession first = load(std::move(sessions[0]));
  sessions.erase(sessions.begin());
  for (Session& session : sessions) session.volume = first.session.volume;
  const Volume volume = first.volume;
  RunOutputs quiet;
  quiet.quiet = true;
  for (GrownObject& grown : growObjects(std::move(first), std::move(sessions), quiet)) {
    MeasuredObject& object = m.objects.emplace_back();
    object.name = grown.report.session.label.name;
    object.mesh = std::move(grown.mesh);
    object.certificate = grown.report.mesh;
    object.measures = objectMeasures(object.mesh, &volume);
  }
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

void addWall(const MeasureOptions& o, const TriangleSoup& other, Measured& m) {
  if (m.objects.size() > 1)
    throw OptionError("--wall-thickness",
                      o.path + " holds several objects; give two meshes (MESH --to MESH2).");
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

void check(const MeasureOptions& o) {
  std::vector<std::string> inputs{o.path};
  if (!o.volume.empty()) inputs.push_back(o.volume);
  if (!o.other.empty()) inputs.push_back(o.other);
  checkWritable(outputsOf(o), inputs);
  if (!o.sections.empty() && o.between.empty()) throw UsageError("--sections needs --between.");
  const bool isMesh = isMeshInputPath(o.path);
  if (isMesh && o.volume.empty() && (o.selection.series || o.selection.frame || o.selection.spacing))
    throw UsageError("--series, --frame and --spacing need --volume.");
  if (!isMesh && (o.selection.frame || o.selection.spacing))
    throw UsageError("--frame and --spacing: a session says these itself.");
}

void write(const MeasureOptions& o, const Measured& m) {
  const DeferSignals whole;
  if (!o.csv.empty()) writeTextAtomically(o.csv, measuredCsv(m));
  if (!o.json.empty()) writeTextAtomically(o.json, measuredJson(m));
  if (!o.sections.empty()) writeTextAtomically(o.sections, sectionsCsv(m.line->line));
}

int measure(const MeasureOptions& o) {
  check(o);
  Measured m;
  m.path = o.path;
  TriangleSoup other;
  Certificate certificate;
  if (!o.other.empty()) other = readBody(o.other, certificate);
  isMeshInputPath(o.path) ? measureMesh(o, m) : measureSession(o, m);
  for (const MeasuredObject& object : m.objects)
    for (const Finding& w : object.measures.warnings)
      m.warnings.push_back(m.objects.size() > 1 ? Finding(FindingKind::ofObject, {{"object", object.name}}, w)
                                                : w);
  addGaps(o, other, m);
  if (o.wall) addWall(o, other, m);
  if (!o.between.empty()) addLine(o, m);
  // Meshes are called by their paths.
  if (o.isAnonymous) m = anonymous(std::move(m), {{o.path, "MESH"}, {o.other, "MESH2"}});
  write(o, m);
  std::fputs(measuredText(m).c_str(), stdout);
  return kDone;
}

}  // namespace

void addMeasure(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(
      app, "measure", "Volume, area, diameters, intensities, distances, centre lines and wall thickness");
  auto options = std::make_shared<MeasureOptions>();
  command
      ->add_option("MESH", options->path,
                   "A certified mesh (.stl .vtp .ply .obj .stl.dcm), or a session or report (JSON), which is "
                   "grown again")
      ->required();
  command
      ->add_option("--volume", options->volume,
                   "The volume whose intensities are measured; of a session, where its volume is now")
      ->type_name("VOLUME");
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
  command->add_flag("--wall-thickness", options->wall,
                    "Thickness of the wall between the surface and that of --to, or its own cavities");
  command->add_option("--csv", options->csv, "The table, a line per object")->type_name("F.csv");
  command->add_option("--json", options->json, "Everything as JSON")->type_name("F.json");
  addAnonymous(*command, options->isAnonymous);
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

}  // namespace handlebody::cli
