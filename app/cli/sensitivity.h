#pragma once
// --sensitivity: the result grown again with everything a little different (docs/sensitivity.md).

#include <string>
#include <vector>

#include "app/cli/outputs.h"
#include "core/io/report/session.h"
#include "core/sensitivity/sensitivity.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

struct SensitivityOptions {
  int runs = 0;         //!< 0: none
  std::string surface;  //!< .vtp
};

//! Adds --sensitivity and --sensitivity-surface.
void addSensitivity(CLI::App& command, SensitivityOptions& options);

//! Adds what is written to `files`. Throws UsageError if the options do not go together.
void checkSensitivity(const SensitivityOptions& options, std::vector<OutputFile>& files);

//! Throws UsageError where a constraint, or a later change of the constraints, names an iteration, or the
//! object was given as it is.
void requireRepeatable(const Session& session);

//! With progress on standard error unless `quiet`.
Sensitivity sensitivityOf(const TriangleSoup& mesh, const GrownFrom& from, const SensitivityOptions& options,
                          bool quiet);

//! One or two sentences without a full stop.
std::string sensitivityText(const Sensitivity& s);

}  // namespace handlebody::cli
