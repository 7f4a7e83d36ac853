// Edits by hand as steps.

#include "core/evolution/edit_step.h"
#include "core/evolution/step_transaction.h"
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

Attempt StepTransaction::attemptEdit(Mesh& mesh, const MeshEdit& edit, const StepScene& scene,
                                     const TopologyLimits& limits) const {
  EditOutcome done = makeEdit(mesh, edit);
  Attempt a;
  a.events = std::move(done.events);
  for (Event& e : a.events) e.iteration = edit.iteration;
  a.touched.assign(mesh.vertexSlots(), 0);
  for (const int v : done.touched)
    if (v < mesh.vertexSlots()) a.touched[v] = 1;
  if (const auto place = scene.walls.brokenAnywhere(mesh))
    a.conflicts.push_back({*place, 0, FindingKind::editIntoWall});
  else if (const auto pinned = scene.locked.pins.broken(before(), mesh))
    a.conflicts.push_back({*pinned, 0, FindingKind::editOfPinned});
  else if (const FindingKind broken = limitBroken(limits, scene.topology, a.events.back().after);
           broken != FindingKind::none)
    a.conflicts.push_back({edit.place, 0, broken});
  return a;
}

Attempt StepTransaction::edit(Mesh& mesh, const MeshEdit& edit, const StepScene& scene,
                              const TopologyLimits& limits) {
  const auto anything = [](const Attempt&) { return std::vector<HeldChange>(); };
  Attempt made = transaction_.runOnce({mesh,
                                       scene.topology,
                                       scene.limits.longest,
                                       scene.longest(),
                                       [&] { return attemptEdit(mesh, edit, scene, limits); },
                                       anything,
                                       {}});
  if (!made.isKept())
    throw Told<UsageError>(
        Finding(FindingKind::editRefused, {{"iteration", edit.iteration}}, made.conflicts[0].reason));
  collapsed_.forget();
  return made;
}

}  // namespace handlebody
