#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/run.h"
#include "core/errors.h"

namespace handlebody::cli {

namespace {

struct ReplayOptions {
  std::string path, volume, walls;
  std::optional<std::string> series;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
};

int replay(const ReplayOptions& o) {
  Session session = readSession(o.path, o.volume, o.walls);
  if (o.series) session.volume.selection.series = o.series;
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
  command
      ->add_option("--volume", options->volume, "Its volume, if the session does not say where that is now")
      ->type_name("PATH");
  command
      ->add_option("--walls", options->walls,
                   "The label map of its walls, if the session does not say where that is now")
      ->type_name("LABELMAP");
  command->add_option("--series", options->series, "The DICOM series of that volume")->type_name("UID");
  addRunOutputs(*command, options->outputs);
  addSpace(*command, options->space);
  command->callback([&action, options] { action = [options] { return replay(*options); }; });
}

}  // namespace handlebody::cli
