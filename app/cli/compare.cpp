#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/label_input.h"
#include "app/cli/outputs.h"
#include "app/cli/progress.h"
#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/compared_table.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "core/threads.h"

namespace handlebody::cli {

namespace {

struct CompareOptions {
  std::string a, b;
  std::string label, labelA, labelB;
  std::optional<int> frame;
  std::string distances, report, csv;
  ComparisonOptions how;
  bool json = false, quiet = false, isAnonymous = false;
};

void checkOptions(const CompareOptions& o) {
  if (!o.labelA.empty() && isMeshInputPath(o.a)) throw OptionError("--label-a", o.a + " is a mesh.");
  if (!o.labelB.empty() && isMeshInputPath(o.b)) throw OptionError("--label-b", o.b + " is a mesh.");
  if (isMeshInputPath(o.a) && isMeshInputPath(o.b)) {
    if (!o.label.empty()) throw OptionError("--label", "both objects are meshes.");
    if (o.frame) throw OptionError("--frame", "both objects are meshes.");
  }
  std::vector<OutputFile> files;
  if (!o.distances.empty()) files.push_back({"-o", o.distances});
  if (!o.report.empty()) files.push_back({"--report", o.report});
  if (!o.csv.empty()) files.push_back({"--csv", o.csv});
  if (!o.distances.empty() && !o.distances.ends_with(".vtp"))
    throw UsageError("-o " + o.distances + ": a surface with distances is written as .vtp.");
  checkWritable(files, {o.a, o.b});
}

void write(const ComparedPair& pair, const CompareOptions& o) {
  if (!o.distances.empty() && !pair.found.distances)
    throw UsageError("-o " + o.distances + ": there are no distances, as an object is empty.");
  const DeferSignals whole;
  const CancelScope scope(DeferSignals::stopToken());
  const Phase phase("writing");
  if (!o.distances.empty()) writeDistances(pair, distancesFromReference(pair, o.how.threads), o.distances);
  if (!o.report.empty()) writeTextAtomically(o.report, comparisonJson(pair));
  if (!o.csv.empty()) writeTextAtomically(o.csv, comparisonCsv(pair));
}

void compareSampled(ComparedPair& pair, const ComparisonOptions& how) try {
  handlebody::compare(pair, how);
} catch (const TooManySamples& error) {
  throw OptionError("--sampling", error.what());
}

ComparedObject readSide(const std::string& path, const std::string& label, const CompareOptions& o,
                        std::vector<Finding>& warnings) {
  if (isMeshInputPath(path)) return readCompared(path, {}, warnings);
  const std::optional<int> number = labelOf(path, label);
  LabelFile file = openLabels(path, o.frame);
  return comparedLabels(path, file, number, warnings);
}

int compare(const CompareOptions& o) {
  checkOptions(o);
  const PhaseLine line(o.quiet);
  ComparedPair pair;
  const std::string &ofA = o.labelA.empty() ? o.label : o.labelA,
                    &ofB = o.labelB.empty() ? o.label : o.labelB;
  pair.a = readSide(o.a, ofA, o, pair.warnings);
  pair.b = readSide(o.b, ofB, o, pair.warnings);
  compareSampled(pair, o.how);
  if (o.isAnonymous) pair = anonymous(std::move(pair));
  write(pair, o);
  std::fputs((o.json ? comparisonJson(pair) : comparisonText(pair)).c_str(), stdout);
  return kDone;
}

void addMeasures(CLI::App& command, ComparisonOptions& how) {
  how.threads = threadCount(0);
  command
      .add_option_function<std::string>(
          "--sampling",
          [&how](const std::string& text) {
            how.sampling = parseNumber("--sampling", text);
            if (!(how.sampling > 0) || !std::isfinite(how.sampling))
              throw OptionError("--sampling", "'" + text + "' is not a finite number above 0.");
          },
          "Distance between samples of the surfaces, and of the overlap of two meshes (default: about a "
          "million "
          "samples of the surfaces)")
      ->type_name("MM");
  command
      .add_option_function<std::string>(
          "--threads",
          [&how](const std::string& text) { how.threads = parseInteger("--threads", text, 1, kMaxThreads); },
          "The figures do not depend on it (default: all of the machine)")
      ->type_name("N");
}

}  // namespace

void addCompare(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(
      app, "compare", "Two objects against each other: Dice, IoU, volumes, surface distances, topology");
  auto options = std::make_shared<CompareOptions>();
  const char* help =
      "A mesh (.stl .vtp .ply .obj .3mf .stl.dcm) or a label map (any volume, .seg.nrrd, DICOM Segmentation)";
  command->add_option("A", options->a, help)->required();
  command->add_option("B", options->b, std::string(help) + "; the reference")->required();
  addLabelOption(*command, "--label", options->label,
                 "The object in label maps, by its number or as the file calls it (default: all but 0)");
  addLabelOption(*command, "--label-a", options->labelA, "The same for A alone");
  addLabelOption(*command, "--label-b", options->labelB, "The same for B alone");
  addLabelFrame(*command, options->frame);
  command
      ->add_option("-o,--output", options->distances,
                   "The surface of A with its signed distance to B at every vertex, mm, negative inside of B")
      ->type_name("DIST.vtp");
  command->add_option("--report", options->report, "The figures as JSON")->type_name("F.json");
  command->add_option("--csv", options->csv, "The figures as a table of one row")->type_name("F.csv");
  command->add_flag("--json", options->json, "Print JSON instead of text");
  command->add_flag("--quiet", options->quiet, "No progress");
  addAnonymous(*command, options->isAnonymous);
  addMeasures(*command, options->how);
  command->callback([&action, options] { action = [options] { return compare(*options); }; });
}

}  // namespace handlebody::cli
