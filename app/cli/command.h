#pragma once
// What the subcommands share: how they are added, and what the program's exit codes mean.

#include <functional>
#include <string>
#include <vector>

#include "core/io/formats/volume_io.h"
#include "core/io/report/session.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

inline constexpr int kMaxThreads = 1024;  //!< of --threads

//! The contract with callers; see the README.
enum ExitCode : int {
  kDone = 0,
  kInternalError = 1,  //!< also: `check` says no
  kUsage = 2,          //!< also: an output cannot be written
  kInput = 3,
  kSeed = 4,
  kMaxIterations = 5,
  kLeak = 6,  //!< stopped at a leak (--on-leak), or for somebody to decide (--on-held)
  kIncomplete =
      7  //!< `batch`: some cases have no result; `edit`: some tunnels are still open; `--frames`: some failed
};

//! What a parsed command line asks for; returns the exit code and throws the errors of core/errors.h.
using Action = std::function<int()>;

//! Each adds one subcommand, which sets `action` when it is the one that was called.
void addSegment(CLI::App& app, Action& action);
void addInfo(CLI::App& app, Action& action);
void addCheck(CLI::App& app, Action& action);
void addHandles(CLI::App& app, Action& action);
void addPhantom(CLI::App& app, Action& action);
void addEdit(CLI::App& app, Action& action);
void addReplay(CLI::App& app, Action& action);
void addCompare(CLI::App& app, Action& action);
void addMesh(CLI::App& app, Action& action);
void addMeasure(CLI::App& app, Action& action);
void addBatch(CLI::App& app, Action& action);
//! Not for users: see runDicomDecoder.
void addDecode(CLI::App& app, Action& action);

//! `segment` with several objects (nameSeveralObjects), from the arguments behind it: what follows a name is
//! that object's, which no subcommand of CLI11 can say. Throws UsageError.
Action segmentSeveralObjects(const std::vector<std::string>& arguments);

//! A subcommand with the notice under its help.
CLI::App* addCommand(CLI::App& app, const std::string& name, const std::string& description);

//! Each option of the command that takes a path throws OptionError for an empty one, and for what begins like
//! an option or is one: it was meant as that, and the path before it is missing. "./--x" is a path. What
//! stands without an option (VOLUME, SESSION) may not be empty either. To be called when all options have
//! been added.
void checkPaths(CLI::App& command);

//! Adds --anonymous of a command that tells figures.
void addAnonymous(CLI::App& command, bool& isAnonymous);

//! Adds --walls and --start of a command that grows a session again: where its files are now.
void addMovedFiles(CLI::App& command, InputPaths& inputs);

//! Adds --series, --frame, --spacing and --uneven.
void addSelection(CLI::App& command, VolumeSelection& selection);

}  // namespace handlebody::cli
