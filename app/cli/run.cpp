#include "app/cli/run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/picture/picture.h"
#include "core/cancellation.h"
#include "core/errors.h"
#include "core/evolution/active_contour.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/label_map.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/growth_report.h"
#include "core/io/report/option_error.h"
#include "core/io/report/result.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/voxel_fingerprint.h"
#include "core/io/report/wall_map.h"

namespace handlebody::cli {

void addRunOutputs(CLI::App& command, RunOutputs& outputs) {
  command
      .add_option(
          "-o,--output", outputs.results,
          "What to write, by extension: .stl .vtp .ply .obj .3mf .gltf = the mesh; .nii.gz .nii .nrrd .mha = "
          "its "
          "label map on the input grid; .seg.nrrd = the same as 3D Slicer's segmentation; for a volume read "
          "from DICOM, too: .seg.dcm = a DICOM Segmentation, .stl.dcm = the mesh as DICOM Encapsulated STL; "
          "where gmsh or TetGen is installed: .msh .vtu .inp = tetrahedra for a solver; "
          "NAME=FILE: of several objects that one alone; may be given several times")
      ->type_name("OUT")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false)
      ->required();
  command.add_option("--report", outputs.report, "Report of the run (JSON)")->type_name("F.json");
  command.add_option("--session", outputs.session, "Session for `replay` (JSON)")->type_name("F.json");
  command.add_option("--trace", outputs.trace, "Stages of every change of topology (JSON)")
      ->type_name("F.json");
  command.add_option("--picture", outputs.picture, "Three slices with the outline, and the surface (PNG)")
      ->type_name("F.png");
  command
      .add_option("--label-description", outputs.labelDescription,
                  "Names and colours of the labels for ITK-SNAP (text)")
      ->type_name("F.txt");
  addContent(command, outputs.content);
  addSensitivity(command, outputs.sensitivity);
  addPolish(command, outputs.polish);
  addMesherSeconds(command, outputs.mesherSeconds);
  command.add_flag(
      "--list-candidates", outputs.listsCandidates,
      "The report lists what the clicks may mean also where a seed's radius or --object is given "
      "and a boundary is beyond doubt; takes about as long as a growth");
  command.add_flag("--quiet", outputs.quiet, "No progress and no summary");
}

void addSpace(CLI::App& command, std::optional<CoordinateSpace>& space) {
  const auto set = [&space](const std::string& text) {
    if (text != "LPS" && text != "RAS") throw OptionError("--space", "'" + text + "' is not LPS or RAS.");
    space = text == "RAS" ? CoordinateSpace::ras : CoordinateSpace::lps;
  };
  command
      .add_option_function<std::string>("--space", set, "Coordinates of the mesh files: LPS (default) or RAS")
      ->type_name("LPS|RAS");
}

namespace {

std::string quotedNames(const std::vector<ObjectLabel>& objects) {
  std::string names;
  for (const ObjectLabel& o : objects) names += (names.empty() ? "'" : ", '") + o.name + "'";
  return names;
}

//! The object whose name stands before an equals sign, the longest if one name begins with another; -1 if
//! there is none.
int namedIn(const std::string& text, const std::vector<ObjectLabel>& objects) {
  int found = -1;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (text.rfind(objects[i].name + "=", 0) == 0 &&
        (found < 0 || objects[i].name.size() > objects[found].name.size()))
      found = static_cast<int>(i);
  return found;
}

}  // namespace

void assignResults(RunOutputs& outputs, const std::vector<ObjectLabel>& objects) {
  outputs.files.clear();
  for (const std::string& text : outputs.results) {
    const int object = namedIn(text, objects);
    if (object >= 0) {
      outputs.files.push_back({text.substr(objects[object].name.size() + 1), object});
      continue;
    }
    const std::string before = text.substr(0, text.find('='));
    if (objects.size() > 1 && before.size() < text.size() && before.find('/') == std::string::npos)
      throw UsageError("-o " + text + ": no object has the name '" + before + "'; there are " +
                       quotedNames(objects) + ".");
    outputs.files.push_back({text, -1});
  }
}

void checkOutputs(const RunOutputs& outputs, const std::vector<std::string>& inputs,
                  std::vector<OutputFile> files) {
  for (const ResultFile& file : outputs.files) {
    files.push_back({"-o", file.path});
    checkResultExtension(files.back());
  }
  if (!outputs.report.empty()) files.push_back({"--report", outputs.report});
  if (!outputs.session.empty()) files.push_back({"--session", outputs.session});
  if (!outputs.trace.empty()) files.push_back({"--trace", outputs.trace});
  if (!outputs.labelDescription.empty()) files.push_back({"--label-description", outputs.labelDescription});
  if (!outputs.picture.empty()) {
    files.push_back({"--picture", outputs.picture});
    checkPictureExtension(files.back());
  }
  checkSensitivity(outputs.sensitivity, files);
  checkWritable(files, inputs);
}

void checkNames(const std::vector<ObjectLabel>& objects, const VolumeInfo& info, const RunOutputs& outputs) {
  for (const ResultFile& file : outputs.files) {
    if (!isDicomSegmentationPath(file.path) && !isDicomStlPath(file.path)) continue;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (file.object < 0 || static_cast<int>(i) == file.object) names.push_back(objects[i].name);
    if (info.dicom) requireDicomNames(names, *info.dicom, outputs.content, file.path);
  }
}

bool isGiven(const Session& session) {
  return session.constraints.start && session.constraints.start->isDone;
}

double Stopwatch::lap() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> seconds = now - last_;
  last_ = now;
  return seconds.count();
}

LoadedSession load(Session session, bool isAnonymous) {
  Stopwatch watch;
  VolumeReference& reference = session.volume;
  LoadedSession loaded;
  const PathHash hash = hashOfPath(reference.path);
  if (!reference.sha256.empty() && !hash.is(reference.sha256))
    throw InputError(reference.path +
                     " is not the volume that the session was made from: its SHA-256 differs.");
  reference.sha256 = hash.whole;
  findSeries(reference);
  LoadedVolume read = loadVolume(reference.path, reference.selection);
  verifyVoxels(reference, read.volume);
  if (isAnonymous) keepVoxels(reference, read.volume);
  loaded.volume = std::move(read.volume);
  loaded.info = std::move(read.info);
  for (const std::string& warning : sentences(loaded.info.warnings))
    std::fprintf(stderr, "handlebody-cli: warning: %s\n", warning.c_str());
  loadWalls(session, loaded.volume.grid);
  loaded.session = std::move(session);
  loaded.loadSeconds = watch.lap();
  return loaded;
}

std::vector<std::string> pathsOf(const std::vector<ResultFile>& files) {
  std::vector<std::string> paths;
  for (const ResultFile& file : files) paths.push_back(file.path);
  return paths;
}

int exitCodeOf(const std::vector<RunReport>& reports) {
  const auto any = [&](auto&& is) { return std::any_of(reports.begin(), reports.end(), is); };
  if (any([](const RunReport& r) { return r.isStoppedAtLeak || r.isStoppedToAsk; })) return kLeak;
  const bool isCut = any([](const RunReport& r) { return r.stopped == StopReason::maxIterations; });
  return isCut ? kMaxIterations : kDone;
}

void printSummary(const RunReport& report, const std::string& name) {
  const Certificate& mesh = report.mesh;
  std::string genus;
  for (int g : mesh.genus) genus += (genus.empty() ? "" : "+") + std::to_string(g);
  if (!name.empty()) std::printf("%s: ", name.c_str());
  std::printf("%s after %d iterations (%.2f s): components %d, genus %s, %d vertices, %.4g ml, %.4g cm2\n",
              endName(report), report.iterations, report.seconds.total, mesh.components, genus.c_str(),
              mesh.vertices, mesh.volume / 1000.0, mesh.area / 100.0);
  if (report.polish)
    if (const std::string text = polishText(*report.polish); !text.empty()) std::printf("%s\n", text.c_str());
  for (const HeldPlace& held : report.held)
    std::printf("held by %s since iteration %d: %s at %.4g,%.4g,%.4g\n", held.isVetoed ? "a veto" : "a limit",
                held.iteration, eventKindName(held.kind), held.place.x(), held.place.y(), held.place.z());
  for (const PinnedPart& part : report.pinned)
    std::printf("pinned by %s: %d vertices, fronts stopped %d times\n", written(part.pin).c_str(),
                part.vertices, part.stops);
  if (report.sensitivity) std::printf("%s\n", sensitivityText(*report.sensitivity).c_str());
}

void writeSideFiles(RunReport report, const RunOutputs& outputs) {
  if (outputs.content.anonymous) report = anonymous(std::move(report));
  if (!outputs.session.empty()) writeSession(report.session, outputs.session);
  if (!outputs.trace.empty()) writeTextAtomically(outputs.trace, traceText(report));
  if (!outputs.report.empty()) writeTextAtomically(outputs.report, reportText(report));
}

void writeAll(const std::function<void()>& results, const std::function<void()>& sideFiles) {
  try {
    results();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    try {
      sideFiles();
    } catch (const std::exception&) {  // the same full disk, most likely: the first is told
    }
    throw;
  }
  sideFiles();
}

namespace {

ExportContext contextOf(const RunReport& report, const RunOutputs& outputs) {
  return {report.volume.grid, report.session.space, report.volume.dicom, outputs.content,
          outputs.mesherSeconds.value_or(kMesherSeconds)};
}

}  // namespace

ObjectLabel labelInFiles(const RunReport& report, const RunOutputs& outputs) {
  ObjectLabel label = report.session.label;
  label.source = sourceInFiles(std::move(label.source), report.session.constraints, report.iterations,
                               outputs.content.anonymous);
  return label;
}

void writeObjects(const std::vector<ExportedObject>& objects, const RunReport& report,
                  const RunOutputs& outputs) {
  const CancelScope scope(DeferSignals::stopToken());
  const ExportContext context = contextOf(report, outputs);
  std::vector<std::string> together;
  for (const ResultFile& file : outputs.files)
    if (file.object < 0)
      together.push_back(file.path);
    else
      writeResults({objects[file.object]}, context, {file.path});
  if (!together.empty()) writeResults(objects, context, together);
  if (!outputs.labelDescription.empty())
    writeTextAtomically(outputs.labelDescription, labelDescription(objects));
}

void writeSpread(const TriangleSoup& mesh, const RunReport& report, const RunOutputs& outputs) {
  const std::string& path = outputs.sensitivity.surface;
  if (path.empty() || !report.sensitivity || report.sensitivity->grown == 0) return;
  writeMeshWithValues(mesh, report.sensitivity->spread, "spread_mm", path);
}

namespace {

//! Of the surface as it is written; what takes long, for the report alone.
void tellSurface(const CertifiedMesh& made, const Volume& volume, const RunOutputs& outputs,
                 RunReport& report) {
  Stopwatch watch;
  report.mesh = made.certificate;
  if (!outputs.report.empty()) report.measures = objectMeasures(made.mesh, &volume);
  report.seconds.exported += watch.lap();
  if (!outputs.report.empty())
    report.tunnels = findTunnelsQuickly(made.mesh, made.certificate, report.session.requested.threads);
  report.seconds.tunnels += watch.lap();
}

void warn(const std::vector<Finding>& warnings, const std::string& name) {
  const std::string behind = name.empty() ? name : name + ": ";
  for (const Finding& d : warnings)
    std::fprintf(stderr, "handlebody-cli: warning: %s%s\n", behind.c_str(), sentence(d).c_str());
}

//! Perturbed runs go on until they are at rest, and would be compared with a surface that is not.
bool isAtRest(const RunReport& report) {
  return !report.isStoppedAtLeak && !report.isStoppedToAsk && report.stopped != StopReason::running;
}

std::vector<Finding> warningsOfSensitivity(const RunReport& report) {
  if (report.sensitivity) return sensitivityWarnings(*report.sensitivity);
  return {
      {FindingKind::other,
       {{"text", std::string("The sensitivity is not told: the growth was stopped before the surface came "
                             "to rest, and perturbed runs would go on")}}}};
}

void tellPolish(const PolishReport& polish, RunReport& report) {
  report.polish = polish;
  if (Finding warning = polishWarning(polish); warning.any()) report.warnings.push_back(std::move(warning));
}

}  // namespace

void polishAmong(GrownObject& object, const std::vector<const TriangleSoup*>& others, const Volume& volume,
                 const RunOutputs& outputs) {
  RunReport& report = object.report;
  if (!isPolished(report.session)) return;
  Stopwatch watch;
  object.polish.bounds.obstacles = others;
  CertifiedMesh made{std::move(object.mesh), report.mesh};
  const std::size_t told = report.warnings.size();
  tellPolish(polish(made, object.polish), report);
  report.seconds.exported += watch.lap();
  if (report.polish->isChanged()) tellSurface(made, volume, outputs, report);
  warn({report.warnings.begin() + static_cast<std::ptrdiff_t>(told), report.warnings.end()},
       report.session.label.name);
  object.mesh = std::move(made.mesh);
}

GrownObject grow(LoadedSession loaded, const RunOutputs& outputs, Among among, const std::string& name) {
  Stopwatch watch;
  RunReport report;
  report.session = std::move(loaded.session);
  report.volume = std::move(loaded.info);
  report.seconds.load = loaded.loadSeconds;
  for (const ResultFile& file : outputs.files) checkResult(file.path, contextOf(report, outputs));
  // Beside objects that grow one that is given has none, and does not keep them from theirs.
  const bool asksSensitivity =
      outputs.sensitivity.runs > 0 && !(among == Among::others && isGiven(report.session));
  if (asksSensitivity) requireRepeatable(report.session);
  const Volume volume = loaded.volume;  // the contour has the same voxels in memory
  ActiveContour contour(std::move(loaded.volume), report.session.seeds, report.session.requested,
                        report.session.constraints);
  tellBeginning(contour, report);
  tellCandidates(contour, outputs.listsCandidates, report);
  report.seconds.prepare = watch.lap();

  const OnHeld onHeld = report.session.constraints.topology.asks ? outputs.onHeld : OnHeld::hold;
  contour =
      evolve(std::move(contour), report, {outputs.onLeak, onHeld, !outputs.trace.empty(), outputs.quiet});
  report.seconds.evolve = watch.lap();

  CertifiedMesh made = grownMesh(contour), unpolished = made;
  PolishOptions polishing;
  if (isPolished(report.session)) polishing = polishOptions(contour, made.mesh);
  if (isPolished(report.session) && among == Among::none) tellPolish(polish(made, polishing), report);
  report.seconds.exported = watch.lap();
  tellSurface(made, volume, outputs, report);
  watch.lap();
  if (asksSensitivity && isAtRest(report))
    report.sensitivity = sensitivityOf(made.mesh, {volume, contour.request(), contour.parameters()},
                                       outputs.sensitivity, outputs.quiet);
  report.seconds.sensitivity = watch.lap();
  addWarnings(contour, made.mesh, report);
  for (Finding& d : labelMapWarnings(made.mesh, volume.grid, pathsOf(outputs.files)))
    report.warnings.push_back(std::move(d));
  if (asksSensitivity)
    for (Finding& d : warningsOfSensitivity(report)) report.warnings.push_back(std::move(d));
  warn(report.warnings, name);
  report.seconds.exported += watch.lap();
  return {std::move(report), std::move(made.mesh), std::move(polishing), std::move(unpolished)};
}

int run(LoadedSession loaded, const RunOutputs& outputs) {
  std::optional<Volume> shown;  // the voxels are not kept in memory for nothing: a label map needs it
  if (!outputs.picture.empty()) shown = loaded.volume;
  loaded.session.label = chosenLabel(outputs.object, loaded.session.label);
  checkNames({loaded.session.label}, loaded.info, outputs);
  loadStarts(loaded.session);
  GrownObject grown = grow(std::move(loaded), outputs);
  Stopwatch watch;
  {
    DeferSignals whole;
    const auto results = [&, &report = grown.report, &mesh = grown.mesh] {
      writeObjects({{labelInFiles(report, outputs), mesh}}, report, outputs);
      if (shown) writePicture(*shown, mesh, outputs.picture);
      writeSpread(mesh, report, outputs);
    };
    writeAll(results, [&, &report = grown.report] {
      report.seconds.exported += watch.lap();
      const Timings& s = report.seconds;
      report.seconds.total = s.load + s.prepare + s.evolve + s.exported + s.tunnels + s.sensitivity;
      writeSideFiles(report, outputs);
    });
  }
  if (!outputs.quiet) printSummary(grown.report);
  return exitCodeOf({grown.report});
}

}  // namespace handlebody::cli
