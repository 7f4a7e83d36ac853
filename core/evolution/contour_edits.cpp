// Edits by hand as steps.

#include "core/evolution/contour_state.h"
#include "core/indices.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

//! More components or tunnels than there were, and than may be.
FindingKind limitBroken(const TopologyLimits& limits, const TopologyNumbers& before,
                        const TopologyNumbers& after) {
  const auto isBroken = [](const std::optional<int>& limit, int was, int is) {
    return limit && is > *limit && is > was;
  };
  if (isBroken(limits.components, before.components, after.components)) return FindingKind::tooManyComponents;
  if (isBroken(limits.genus, before.genus, after.genus)) return FindingKind::tooManyTunnels;
  return FindingKind::none;
}

}  // namespace

//! Steps from here come to an edit that waits.
bool ActiveContour::State::leadsToEdit() const {
  const std::optional<MeshEdit> next = edits.waiting();
  return next && mesh.faceCount() > 0 &&
         (iteration < parameters.maxIterations || next->iteration == iteration + 1);
}

Attempt ActiveContour::State::editAttempt(const MeshEdit& edit) {
  EditOutcome done = makeEdit(mesh, edit);
  Attempt a;
  a.events = std::move(done.events);
  for (Event& e : a.events) e.iteration = edit.iteration;
  a.touched.assign(idx(mesh.vertexSlots()), 0);
  for (const int v : done.touched)
    if (v < mesh.vertexSlots()) a.touched[idx(v)] = 1;
  if (const auto place = walls.brokenAnywhere(mesh))
    a.troubles.push_back({*place, 0, FindingKind::editIntoWall});
  else if (const auto pinned = pins.broken(transaction.before(), mesh))
    a.troubles.push_back({*pinned, 0, FindingKind::editOfPinned});
  else if (const FindingKind broken = limitBroken(constraints.topology, topology, a.events.back().after);
           broken != FindingKind::none)
    a.troubles.push_back({edit.place, 0, broken});
  return a;
}

//! What an edit made stays as it was made, until something near it moves.
void ActiveContour::State::letSleep(const Attempt& edited) {
  const Mesh& before = transaction.before();
  quiet.resize(idx(mesh.vertexSlots()), 0);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (edited.touched[idx(v)] != 0 &&
        (v >= before.vertexSlots() || !before.isVertex(v) || before.position(v) != mesh.position(v)))
      quiet[idx(v)] = kQuietToSleep;
}

//! All or nothing: what throws has changed nothing.
StepReport ActiveContour::State::editStep(const MeshEdit& edit) {
  const auto anything = [](const Attempt&) { return std::vector<HeldChange>(); };
  Attempt made =
      transaction.runOnce({mesh, topology, limits.longest, [&] { return editAttempt(edit); }, anything, {}});
  if (!made.isKept())
    throw Told<UsageError>(
        Finding(FindingKind::editRefused, {{"iteration", edit.iteration}}, made.troubles[0].reason));
  StepReport report;
  report.iteration = ++iteration;
  edits.setMade(edit);
  letSleep(made);
  topology = made.events.back().after;
  report.events = std::move(made.events);
  collapsed.forget();
  if (walls.isPushing()) {
    walls.release(mesh);
    chooseForbidden();
  }
  report.settledVertices = mesh.vertexCount();
  report.volume = transaction.volume();
  decideStop(report);
  takePins();
  return report;
}

}  // namespace handlebody
