#include <CLI/CLI.hpp>

#include "app/cli/command.h"

namespace handlebody::cli {

void addDecode(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("decode-dicom", "Internal: the child process that decodes DICOM");
  command->group("");  // not in --help
  command->callback([&action] { action = [] { return runDicomDecoder(); }; });
}

}  // namespace handlebody::cli
