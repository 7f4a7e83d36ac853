#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>

#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/cli/label_input.h"
#include "app/cli/object_options.h"
#include "app/cli/outputs.h"
#include "app/cli/progress.h"
#include "core/cancellation.h"
#include "core/errors.h"
#include "core/evolution/parameter_limits.h"
#include "core/io/refuse_input.h"
#include "core/io/report/json.h"
#include "core/io/report/label_file.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/result.h"
#include "core/number_text.h"
#include "core/solid/label_mesh.h"
#include "core/solid/simplify.h"
#include "core/threads.h"

namespace handlebody::cli {

namespace {

struct MeshOptions {
  std::string labels, label;
  std::optional<int> genus, frame;
  std::optional<bool> polish;
  std::optional<double> mesherSeconds;
  bool keepLargest = false, json = false;
  LabelMeshOptions how;
  std::vector<std::string> results;
  CoordinateSpace space = CoordinateSpace::lps;
  ObjectOptions object;
  DicomContent content;
  bool quiet = false;
};

std::string plural(int n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

Mask maskIn(LabelFile& file, const MeshOptions& o, std::optional<int> label) {
  Mask mask = file.mask(label);
  if (mask.inside.empty())
    throw InputError(o.labels + ": " +
                     (label ? "no voxel has the value " + std::to_string(*label) : "all voxels are 0") + ".");
  if (o.keepLargest) mask = largestPart(mask);
  if (!o.genus) return mask;
  const auto simpler = withFewerTunnels(mask, *o.genus);
  if (!simpler)
    throw InputError(o.labels + ": no closing or opening by up to " + std::to_string(kLargestBall) +
                     " voxels leaves " + plural(*o.genus, "tunnel") + " or fewer of its " +
                     std::to_string(countTunnels(mask)) + " (--genus).");
  return *simpler;
}

//! Without a limit a mistyped length fills the memory. A surface has no less area than a ball's of its
//! volume.
void requireManageable(const Mask& mask, const MeshOptions& o) {
  constexpr double kMaxTriangles = 2e6, kFine = 0.25;
  const double edge = o.how.edgeLength;
  if (edge <= 0 || edge >= kFine * mask.grid.spacing.minCoeff()) return;
  const auto voxels = static_cast<double>(std::count(mask.inside.begin(), mask.inside.end(), 1));
  const double area = std::cbrt(36 * std::numbers::pi * std::pow(voxels * mask.grid.voxelVolume(), 2));
  if (area > kMaxTriangles * std::sqrt(3.0) / 4 * edge * edge)
    throw OptionError(
        "--edge-length",
        numberText(edge) + " mm is too short: the surface would have over two million triangles.", " ");
}

void requireSmooth(const Grid& grid, double smoothing) {
  const ParameterLimits limits = limitsFor(grid);
  if (smoothing > limits.smoothing)
    throw OptionError("--smooth",
                      numberText(smoothing) + " mm is too much for a label map whose longest side is " +
                          numberText(limits.longestSide) + " mm: at most " + numberText(limits.smoothing) +
                          " mm.",
                      " ");
}

LabelMesh meshOf(const Mask& mask, const MeshOptions& o) try {
  return handlebody::meshOf(mask, o.how);
} catch (const InputError& error) {
  refuseSurface(o.labels, error);
}

//! It was certified as it was made: what fails then is the rounding.
CertifiedMesh rounded(const TriangleSoup& mesh, const MeshOptions& o) try {
  return certifiedForExport(mesh);
} catch (const std::runtime_error&) {
  throw InputError(o.labels +
                   ": its surface intersects itself in single precision: it lies too far from the origin.");
}

std::optional<PolishReport> polish(CertifiedMesh& made, const Grid& grid, const MeshOptions& o) {
  if (!o.polish.value_or(true)) return std::nullopt;
  PolishOptions options;
  options.bounds.distance = polishDistance(grid);
  const PolishReport report = handlebody::polish(made, options);
  warnOfPolish(report);
  return report;
}

void print(const Certificate& c, const std::optional<PolishReport>& polish, const MeshOptions& o) {
  if (o.json) {
    Json json = certificateToJson(c);
    if (polish) json["polish"] = polishToJson(*polish);
    std::fputs(jsonText(json).c_str(), stdout);
    return;
  }
  if (o.quiet) return;
  int tunnels = 0;
  for (const int g : c.genus) tunnels += g;
  std::printf("%s, %s, genus %d; volume %.6g ml; %d vertices, %d faces; certified\n",
              plural(c.components - c.cavities, "component").c_str(),
              c.cavities == 1 ? "1 cavity" : (std::to_string(c.cavities) + " cavities").c_str(), tunnels,
              c.volume / 1000, c.vertices, c.faces);
  if (polish)
    if (const std::string text = polishText(*polish); !text.empty()) std::printf("%s\n", text.c_str());
}

void warnOfLabels(const std::vector<Finding>& warnings, const MeshOptions& o) {
  for (const Finding& w : warnings)
    std::fprintf(stderr, "handlebody-cli: warning: %s\n",
                 sentence({FindingKind::ofFile, {{"file", o.labels}}, w}).c_str());
}

int mesh(const MeshOptions& o) {
  const PhaseLine line(o.quiet);
  std::vector<OutputFile> files;
  for (const std::string& path : o.results) {
    files.push_back({"-o", path});
    if (!isResultPath(path))
      throw UsageError("-o " + path + ": an output ends in " + std::string(resultEndings()) + ".");
  }
  checkSpace(o.space, o.results);
  checkEffect(o.content, o.mesherSeconds, o.results);
  if (o.how.smoothing == 0 && o.how.edgeLength > 0)
    throw OptionError("--edge-length", "has no effect with --smooth 0, which leaves the voxels' own faces.",
                      " ");
  checkWritable(files, {o.labels});
  const std::optional<int> label = labelOf(o.labels, o.label);
  LabelFile file = openLabels(o.labels, o.frame);
  const VolumeInfo& info = file.info();
  const ExportContext context{info.grid, o.space, info.dicom, o.content,
                              o.mesherSeconds.value_or(kMesherSeconds)};
  for (const std::string& path : o.results) checkResult(path, context);
  requireSmooth(info.grid, o.how.smoothing);
  const Mask mask = maskIn(file, o, label);
  requireManageable(mask, o);
  CertifiedMesh made = rounded(meshOf(mask, o).mesh, o);
  const std::optional<PolishReport> polished = polish(made, info.grid, o);
  {
    const DeferSignals whole;
    const CancelScope scope(DeferSignals::stopToken());
    ObjectLabel said = asInItsFile(o.labels, label, o.content.anonymous, {});
    if (o.content.anonymous) said.source = withoutSite(std::move(said.source));
    writeResults({{chosenLabel(o.object, said), made.mesh}}, context, o.results);
  }
  warnOfLabels(info.warnings, o);
  warnOfLabels(labelMeshWarnings(made.mesh, made.certificate, mask, o.how), o);
  print(made.certificate, polished, o);
  return kDone;
}

double positive(const std::string& option, const std::string& text, bool orZero) {
  const double value = parseNumber(option, text);
  if (!std::isfinite(value) || !(orZero ? value >= 0 : value > 0))
    throw OptionError(option,
                      "'" + text + "' is not a finite number " + (orZero ? "of at least" : "above") + " 0.");
  return value;
}

void addShape(CLI::App& command, MeshOptions& o) {
  o.how.threads = threadCount(0);
  const auto add = [&](const char* name, const char* type, const char* help,
                       const std::function<void(const std::string&)>& set) {
    command.add_option_function<std::string>(name, set, help)->type_name(type);
  };
  addLabelOption(command, "--label", o.label,
                 "The object, by its number or as the file calls it (default: all but 0)");
  command.add_flag("--keep-largest", o.keepLargest, "Only the largest 6-connected part");
  add("--genus", "G", "Close or cut tunnels until no more than G are left", [&o](const std::string& t) {
    o.genus = parseInteger("--genus", t, 0, std::numeric_limits<int>::max());
  });
  add("--smooth", "MM",
      "Smoothing, standard deviation (default: a voxel along each axis; 0: none, steps and all)",
      [&o](const std::string& t) { o.how.smoothing = positive("--smooth", t, true); });
  add("--edge-length", "MM", "Target edge length (default: the mean voxel size)",
      [&o](const std::string& t) { o.how.edgeLength = positive("--edge-length", t, false); });
  add("--threads", "N", "The mesh does not depend on it (default: all of the machine)",
      [&o](const std::string& t) { o.how.threads = parseInteger("--threads", t, 1, kMaxThreads); });
  add("--space", "LPS|RAS", "Coordinates of mesh files (default LPS)", [&o](const std::string& t) {
    if (t != "LPS" && t != "RAS") throw OptionError("--space", "'" + t + "' is not LPS or RAS.");
    if (t == "RAS") o.space = CoordinateSpace::ras;
  });
}

}  // namespace

void addMesh(CLI::App& app, Action& action) {
  CLI::App* command =
      addCommand(app, "mesh", "A smooth, even, certified mesh of a label map, of its topology");
  auto options = std::make_shared<MeshOptions>();
  command->add_option("LABELMAP", options->labels, "Any volume, .seg.nrrd or DICOM Segmentation")->required();
  addLabelFrame(*command, options->frame);
  command->add_option("-o,--output", options->results, "The mesh, by its ending")
      ->type_name("OUT")
      ->required()
      ->allow_extra_args(false);
  addShape(*command, *options);
  addPolish(*command, options->polish);
  addMesherSeconds(*command, options->mesherSeconds);
  command->add_flag("--json", options->json, "Print the certificate as JSON");
  command->add_flag("--quiet", options->quiet, "No progress and no summary");
  addObjectOptions(*command, options->object);
  addContent(*command, options->content);
  command->callback([&action, options] { action = [options] { return mesh(*options); }; });
}

}  // namespace handlebody::cli
