#pragma once
// --frames: the surface carried through the frames of a 4D volume (docs/time.md).

#include <optional>
#include <string>
#include <vector>

#include "app/cli/run.h"
#include "core/io/report/over_time_request.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! As given.
struct OverTimeOptions {
  std::optional<OverTimeRequest> request{};  //!< none: --frames was not given
  std::string firstOther{};                  //!< the first given of the options that need --frames
  OverTimeRequest others{};                  //!< what they say
  std::vector<std::string> curves{};         //!< --curve
};

//! Adds --frames, --topology, --drift-check, --frame-time and --curve.
void addOverTime(CLI::App& command, OverTimeOptions& options);
//! Adds --curve alone: the rest is in the session.
void addCurve(CLI::App& command, OverTimeOptions& options);

//! What is asked for; none without --frames. Throws UsageError for options that need it.
std::optional<OverTimeRequest> requestOf(const OverTimeOptions& options);

//! Before any work, in place of checkOutputs. The range may still be open: then the frames are those of the
//! volume, whose header is read. No output may be one of `inputs`. Throws UsageError, InputError.
void checkOverTime(const Session& session, const RunOutputs& outputs, const OverTimeOptions& options,
                   const std::vector<std::string>& inputs);

//! The session's volume becomes that of the frame that is grown: the first of the range if none is chosen.
//! Throws UsageError if it is not in the range.
void chooseFrame(Session& session);

//! Grows the surface in the session's frame as `run` does, carries it through the others, and writes
//! everything; returns the exit code, kIncomplete if a frame failed. Throws as run.
int runOverTime(LoadedSession loaded, const RunOutputs& outputs, const OverTimeOptions& options);

}  // namespace handlebody::cli
