#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/cli/over_time.h"
#include "app/cli/progress.h"
#include "app/cli/run_objects.h"
#include "app/cli/session_warnings.h"
#include "core/errors.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/voxel_fingerprint.h"
#include "core/version.h"

namespace handlebody::cli {

namespace {

struct ReplayOptions {
  std::string path;
  InputPaths inputs;
  std::optional<std::string> series;
  std::optional<CoordinateSpace> space;
  RunOutputs outputs;
  OverTimeOptions overTime;
};

//! Several objects keep the names of their session: an option could mean any of them.
void requireNoLabel(const std::string& path, const ObjectOptions& o) {
  if (o.name || o.term || o.colour || o.value)
    throw UsageError(path +
                     " holds several objects, which keep their names, terms, colours and label values.");
}

std::vector<ObjectLabel> labelsOf(const std::string& path, const std::vector<Session>& sessions,
                                  const ObjectOptions& options) {
  if (sessions.size() == 1) return {chosenLabel(options, sessions[0].label)};
  requireNoLabel(path, options);
  std::vector<ObjectLabel> labels;
  for (const Session& session : sessions) labels.push_back(session.label);
  try {
    requireDistinct(labels);
  } catch (const UsageError& error) {
    throw InputError(path + ": " + error.what());
  }
  return labels;
}

int replay(ReplayOptions o) {
  const PhaseLine line(o.outputs.quiet);
  std::vector<Session> sessions = readSessions(o.path, o.inputs);
  tellWarnings(leaveOutUnseeded(sessions));
  std::vector<std::string> inputs{o.path};
  const std::string version = sessions[0].version;
  for (Session& session : sessions) {
    if (o.series) session.volume.selection.series = o.series;
    if (o.space) session.space = *o.space;
    if (o.outputs.polish) session.polish = *o.outputs.polish;
    session.version = HANDLEBODY_VERSION;
    for (std::string& path : inputsOf(session)) inputs.push_back(std::move(path));
  }
  assignResults(o.outputs, labelsOf(o.path, sessions, o.outputs.object));
  if (o.outputs.content.anonymous) hideFileNames(sessions);
  if (sessions[0].overTime) {
    chooseFrame(sessions[0]);
    findSeries(sessions[0].volume);
    checkOverTime(sessions[0], o.outputs, o.overTime, inputs);
  } else {
    if (!o.overTime.curves.empty()) throw UsageError("--curve needs a session that was made with --frames.");
    checkOutputs(o.outputs, inputs);
  }
  checkSpace(o.space, o.outputs.results, o.outputs.session);
  checkEffect(o.outputs.content, o.outputs.mesherSeconds, o.outputs.results);
  tellWarnings(warningsOfVersion(o.path, version));

  try {
    LoadedSession first = load(std::move(sessions[0]), o.outputs.content.anonymous);
    if (first.session.overTime) return runOverTime(std::move(first), o.outputs, o.overTime);
    if (sessions.size() == 1) return run(std::move(first), o.outputs);
    sessions.erase(sessions.begin());
    for (Session& session : sessions) session.volume = first.session.volume;
    return runObjects(std::move(first), std::move(sessions), o.outputs);
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
      ->add_option("--volume", options->inputs.volume,
                   "Its volume, if the session does not say where that is now")
      ->type_name("PATH");
  addMovedFiles(*command, options->inputs);
  command->add_option("--series", options->series, "The DICOM series of that volume")->type_name("UID");
  addRunOutputs(*command, options->outputs);
  addObjectOptions(*command, options->outputs.object);
  addSpace(*command, options->space);
  addCurve(*command, options->overTime);
  command->callback([&action, options] { action = [options] { return replay(*options); }; });
}

}  // namespace handlebody::cli
