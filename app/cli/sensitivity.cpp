#include "app/cli/sensitivity.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/errors.h"
#include "core/io/report/parse.h"
#include "core/phase.h"
#include "core/units.h"

namespace handlebody::cli {

namespace {

constexpr int kMaxRuns = 1000;

}  // namespace

void addSensitivity(CLI::App& command, SensitivityOptions& options) {
  command
      .add_option_function<std::string>(
          "--sensitivity",
          [&options](const std::string& text) {
            options.runs = parseInteger("--sensitivity", text, 2, kMaxRuns);
          },
          "Grow it so many times again with clicks, smoothing and noise a little different, and tell how "
          "much "
          "the volume and the surface change")
      ->type_name("N");
  command
      .add_option("--sensitivity-surface", options.surface,
                  "The mesh with how far each vertex moves from run to run (mm); needs --sensitivity")
      ->type_name("F.vtp");
}

void checkSensitivity(const SensitivityOptions& options, std::vector<OutputFile>& files) {
  if (options.surface.empty()) return;
  if (options.runs == 0) throw UsageError("--sensitivity-surface needs --sensitivity N.");
  if (!options.surface.ends_with(".vtp"))
    throw UsageError("--sensitivity-surface " + options.surface + ": it is written as .vtp.");
  files.push_back({"--sensitivity-surface", options.surface});
}

void requireRepeatable(const Session& session) try {
  handlebody::requireRepeatable(session.constraints);
  for (const ParameterChange& change : session.changes)
    if (change.constraints) handlebody::requireRepeatable(*change.constraints);
} catch (const UsageError& error) {
  throw UsageError(std::string("--sensitivity: ") + error.what());
}

Sensitivity sensitivityOf(const TriangleSoup& mesh, const GrownFrom& from, const SensitivityOptions& options,
                          bool quiet) {
  const auto progress = [&](int ended) {
    if (!quiet) std::fprintf(stderr, "sensitivity: run %d of %d\n", ended, options.runs);
  };
  const PhaseScope noPhases({});  // of the runs: a line is for each
  return handlebody::sensitivityOf(mesh, from, options.runs, from.used.threads, progress);
}

std::string sensitivityText(const Sensitivity& s) {
  char text[300];
  if (s.grown == 0) {
    std::snprintf(text, sizeof text, "sensitivity: none of %zu perturbed runs left a surface", s.runs.size());
    return text;
  }
  std::snprintf(text, sizeof text,
                "sensitivity: %.4g +- %.2g ml (%.4g to %.4g) in %d of %zu perturbed runs, %d with the same "
                "topology; the surface moves by %.2g mm (95 %% of it by less than %.2g)",
                s.mean / kMillilitre, s.deviation / kMillilitre, s.least / kMillilitre, s.most / kMillilitre,
                s.grown, s.runs.size(), s.sameTopology, s.meanSpread, s.spread95);
  return text;
}

}  // namespace handlebody::cli
