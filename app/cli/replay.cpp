#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/run.h"
#include "core/errors.h"

namespace handlebody::cli {

namespace {

struct ReplayOptions {
  std::string path;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
};

int replay(const ReplayOptions& o) {
  Session session = readSession(o.path);
  if (o.space) session.space = *o.space;
  std::vector<std::string> inputs = inputsOf(session);
  inputs.push_back(o.path);
  checkOutputs(o.outputs, inputs);
  if (session.version != HANDLEBODY_VERSION)
    std::cerr << "handlebody-cli: warning: " << o.path << " was made by version " << session.version
              << "; this is " << HANDLEBODY_VERSION << ", and the mesh may differ." << std::endl;
  session.version = HANDLEBODY_VERSION;

  try {
    return run(load(std::move(session)), o.outputs);
  } catch (const UsageError& error) {  // the parameters and the frame came from the file
    throw InputError(o.path + ": " + error.what());
  }
}

}  // namespace

void addReplay(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "replay", "Make the mesh of a session or report again");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("SESSION", options->path, "Session or report (JSON)")->required();
  addRunOutputs(*command, options->outputs);
  addSpace(*command, options->space);
  command->callback([&action, options] { action = [options] { return replay(*options); }; });
}

}  // namespace handlebody::cli
