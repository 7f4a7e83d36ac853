#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/run.h"
#include "core/errors.h"
#include "core/io/volume_io.h"

namespace handlebody::cli {

namespace {

struct ReplayOptions {
  std::string path;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
};

// A replay on other voxels would not be one.
void checkSameVolume(const VolumeReference& volume, const std::string& session) {
  if (sha256OfPath(volume.path) == volume.sha256) return;
  throw InputError(volume.path + " is not the volume that " + session +
                   " was made from: its SHA-256 differs.");
}

int replay(const ReplayOptions& o) {
  LoadedSession loaded;
  Session& session = loaded.session;
  session = readSession(o.path);
  if (o.space) session.space = *o.space;
  checkOutputs(o.outputs, {o.path, session.volume.path});
  if (session.version != HANDLEBODY_VERSION)
    std::cerr << "handlebody-cli: warning: " << o.path << " was made by version " << session.version
              << "; this is " << HANDLEBODY_VERSION << ", and the mesh may differ." << std::endl;
  session.version = HANDLEBODY_VERSION;

  Stopwatch watch;
  checkSameVolume(session.volume, o.path);
  loaded.volume = readVolume(session.volume.path, session.volume.selection);
  loaded.loadSeconds = watch.lap();
  try {
    return run(std::move(loaded), o.outputs);
  } catch (const UsageError& error) {  // the parameters came from the file, not from an option
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
