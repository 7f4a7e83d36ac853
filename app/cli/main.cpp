#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "app/cli/case_failure.h"
#include "app/cli/command.h"
#include "app/cli/heap.h"
#include "app/cli/object_groups.h"
#include "app/cli/slurm.h"
#include "core/cancellation.h"
#include "core/io/report/json.h"
#include "core/told_error.h"
#include "core/version.h"

namespace handlebody::cli {

namespace {

//! What a command ends with: an exit code, and where it fails a line, for the batch as well if this is a
//! case.
class Run {
 public:
  explicit Run(bool isCase) : isCase_(isCase) {}
  int perform(const Action& action) const;
  int fail(const std::string& message, ExitCode code, bool isOutOfMemory = false) const;

 private:
  bool isCase_;
};

// One error, one line: messages of libraries may hold several.
int Run::fail(const std::string& message, ExitCode code, bool isOutOfMemory) const {
  std::string line = message;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, ' ');
  if (line.empty() || line.back() != '.') line += '.';
  std::cerr << "handlebody-cli: " << line << std::endl;
  if (isCase_) tellFailure({line, isOutOfMemory});
  return code;
}

bool isOutOfMemory(const Finding& finding) {
  return finding.kind == FindingKind::notEnoughMemory || finding.kind == FindingKind::noMemoryToUnpack ||
         std::any_of(finding.causes.begin(), finding.causes.end(), isOutOfMemory);
}

int Run::perform(const Action& action) const try {
  const int code = action();
  if (!std::cout.flush()) return fail("standard output cannot be written.", kUsage);
  return code;
} catch (const UsageError& error) {
  return fail(error.what(), kUsage);
} catch (const OutputError& error) {
  return fail(error.what(), kUsage);
} catch (const InputError& error) {
  return fail(error.what(), kInput, isOutOfMemory(findingOf(error)));
} catch (const SeedError& error) {
  return fail(error.what(), kSeed);
} catch (const Cancelled&) {
  return fail("it was interrupted.", kInternalError);
} catch (const std::bad_alloc&) {
  return fail("internal error: there is not enough memory.", kInternalError, true);
} catch (const std::exception& error) {
  return fail(std::string("internal error: ") + error.what(), kInternalError);
}

int parseAndPerform(int argc, char** argv) {
  CLI::App app("From a medical volume and a seed to a certified surface mesh.", "handlebody-cli");
  app.footer(kNotice);
  app.set_version_flag("--version", std::string("handlebody-cli ") + HANDLEBODY_VERSION);
  app.require_subcommand(1);
  Action action;
  for (auto add : {addSegment, addInfo, addCheck, addEdit, addHandles, addPhantom, addReplay, addCompare,
                   addMesh, addMeasure, addBatch, addDecode})
    add(app, action);
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) checkPaths(*command);
  const Started started = startedWith({argv + 1, argv + argc});
  const Run run(started.isCase);
  const std::vector<std::string> arguments = withSlurmOptions(started.arguments);
  try {
    if (!arguments.empty() && arguments[0] == "segment" && nameSeveralObjects(arguments))
      action = segmentSeveralObjects({arguments.begin() + 1, arguments.end()});
    else
      app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // from the back
  } catch (const CLI::Success& help) {                                            // --help and --version
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return run.fail(error.what(), kUsage);
  } catch (const UsageError& error) {  // thrown by the options that parse themselves
    return run.fail(error.what(), kUsage);
  }
  return run.perform(action);
}

}  // namespace
}  // namespace handlebody::cli

int main(int argc, char** argv) try {
  // The decoder's limit of memory is what it takes at rest and so much more.
  const bool isDecoder = argc > 1 && std::string_view(argv[1]) == "decode-dicom";
  handlebody::cli::keepFreedMemory();
  if (!isDecoder) handlebody::cli::reserveHeap();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of writing, told with the file's name
  std::signal(SIGCHLD, SIG_DFL);  // ignored, as some parents hand it down, no end of a process is ever told
  return handlebody::cli::parseAndPerform(argc, argv);
} catch (const std::exception& error) {  // no memory for the options themselves
  std::fprintf(stderr, "handlebody-cli: internal error: %s\n", error.what());
  return handlebody::cli::kInternalError;
}
