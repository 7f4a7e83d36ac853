#include "app/cli/sensitivity.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/io/report/parse.h"
#include "core/number_text.h"
#include "core/phase.h"
#include "core/units.h"

namespace handlebody::cli {

namespace {

constexpr int kMaxRuns = 1000, kFinestDecimals = 7;

//! With so many significant digits, or all that stand before the point, and never an exponent; as the window
//! has it.
std::string plainly(double value, int digits) {
  const int magnitude = value > 0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  return fixedText(value, std::clamp(digits - 1 - magnitude, 0, kFinestDecimals));
}

std::string inMillilitres(double cubicMillimetres, int digits) {
  return plainly(cubicMillimetres / kMillilitre, digits);
}

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
  const std::string runs = std::to_string(s.runs.size());
  if (s.grown == 0) return "sensitivity: none of " + runs + " perturbed runs left a surface";
  return "sensitivity: " + inMillilitres(s.mean, 4) + " +- " + inMillilitres(s.deviation, 2) + " ml (" +
         inMillilitres(s.least, 4) + " to " + inMillilitres(s.most, 4) + ") in " + std::to_string(s.grown) +
         " of " + runs + " perturbed runs, " + std::to_string(s.sameTopology) +
         " with the same topology; the surface moves by " + plainly(s.meanSpread, 2) +
         " mm (95 % of it by less than " + plainly(s.spread95, 2) + ")";
}

}  // namespace handlebody::cli
