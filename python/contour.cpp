#include "python/contour.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/errors.h"
#include "core/io/report/label_file.h"
#include "core/io/report/option_effects.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/wall_map.h"
#include "core/version.h"

namespace handlebody::python {

namespace {

//! With the label maps of its walls.
RunReport begun(const PythonVolume& volume, Session asked) {
  RunReport report;
  asked.version = HANDLEBODY_VERSION;
  DecoderSettings decoder = std::move(asked.volume.selection.decoder);
  asked.volume = volume.reference;
  asked.volume.selection.decoder = std::move(decoder);
  if (auto& start = asked.constraints.start) {
    findByName(*start);
    asked.label = asInItsFile(start->path, start->label, false, asked.label);
  }
  loadWalls(asked, volume.loaded.volume.grid);
  loadStarts(asked);
  requireGivenHolds(asked.constraints, volume.loaded.volume.grid);
  report.session = std::move(asked);
  report.volume = volume.loaded.info;
  return report;
}

}  // namespace

Contour::Contour(std::shared_ptr<const PythonVolume> volume, Session asked)
    : volume_(std::move(volume)),
      told_(begun(*volume_, std::move(asked))),
      active_(volume_->loaded.volume, told_.session.seeds, told_.session.requested,
              told_.session.constraints) {
  told_.session.polish = true;
  tellBeginning(active_, told_);
  tellCandidates(active_, false, told_);
  tellIteration();
}

Contour::Contour(const Contour& other)
    : volume_(other.volume_),
      told_(other.told_),
      active_(other.active_),
      surface_(other.surface_),
      mesh_(other.mesh_),
      polish_(other.polish_) {
  tellIteration();
}

std::unique_lock<std::mutex> Contour::hold() const {
  std::unique_lock<std::mutex> lock(busy_, std::try_to_lock);
  if (!lock) throw std::runtime_error("The contour is at work in another thread.");
  return lock;
}

void Contour::tellIteration() {
  iteration_ = active_.iteration();
  stopReason_ = active_.stopReason();
}

StepReport Contour::step() {
  if (stopReason_ != StopReason::running)
    throw UsageError(std::string("The growth has ended (") + stopReasonName(stopReason_) +
                     "): there is no further step.");
  StepReport step = active_.step();
  surface_.reset();
  mesh_.reset();
  told_.events.insert(told_.events.end(), step.events.begin(), step.events.end());
  for (const Leak& leak : step.leaks) told_.leaks.push_back({leak, LeakAnswer::goOn});
  told_.questions.insert(told_.questions.end(), step.questions.begin(), step.questions.end());
  tellIteration();
  return step;
}

void Contour::run(std::optional<int> most, bool untilLeak) {
  for (int left = most.value_or(std::numeric_limits<int>::max());
       left > 0 && stopReason_ == StopReason::running; --left)
    if (!step().leaks.empty() && untilLeak) return;
  requireNothingWaiting(active_);
}

void Contour::change(ParameterChange what) {
  auto& changes = told_.session.changes;
  what.iteration = active_.iteration();
  // A replay makes the changes of an iteration at once.
  if (!changes.empty() && changes.back().iteration == what.iteration)
    throw UsageError("The contour was changed at iteration " + std::to_string(what.iteration) +
                     " already; give all options in one call, or step before.");
  Session walls;
  walls.volume = told_.session.volume;
  walls.constraints = std::move(*what.constraints);
  loadWalls(walls, active_.grid());
  loadStarts(walls);
  what.constraints = std::move(walls.constraints);
  if (what.seeds) {
    std::vector<Seed> all = active_.requestedSeeds();
    all.insert(all.end(), what.seeds->begin(), what.seeds->end());
    std::stable_partition(all.begin(), all.end(), [](const Seed& seed) { return !seed.background; });
    what.seeds = std::move(all);
  }
  active_.change(changed(active_.request(), what));
  if (what.seeds && active_.correction())
    told_.corrections.push_back({what.iteration, *active_.correction()});
  changes.push_back(std::move(what));
  told_.session.resolved = active_.parameters();
  surface_.reset();
  mesh_.reset();
  tellIteration();
}

std::shared_ptr<const TriangleSoup> Contour::surface() const {
  if (!surface_) surface_ = std::make_shared<const TriangleSoup>(active_.mesh().compact());
  return surface_;
}

const PythonMesh& Contour::mesh() const {
  if (!mesh_) {
    CertifiedMesh made = grownMesh(active_);
    if (isPolished(told_.session)) polish_ = polish(made, polishOptions(active_, made.mesh));
    mesh_.emplace(std::move(made));
  }
  return *mesh_;
}

RunReport Contour::report(bool isComplete) const {
  RunReport report = told_;
  tellState(active_, report);
  report.mesh = mesh().certificate();
  const TriangleSoup& soup = *mesh().soup();
  if (isComplete) {
    report.measures = objectMeasures(soup, &volume_->loaded.volume);
    report.tunnels = findTunnelsQuickly(soup, report.mesh);
  }
  report.polish = polish_;
  if (polish_)
    if (Finding warning = polishWarning(*polish_); warning.any())
      report.warnings.push_back(std::move(warning));
  addWarnings(active_, soup, report);
  return report;
}

void Contour::writeSession(const std::string& path) const {
  if (volume_->reference.path.empty())
    throw UsageError(path + ": a session names the file of its volume, and this one was made from an array.");
  for (const std::string& input : inputsOf(told_.session)) requireOther(path, input);
  Session session = told_.session;
  if (active_.stopReason() == StopReason::running) session.stopAt = active_.iteration();
  handlebody::writeSession(session, path);
}

}  // namespace handlebody::python
