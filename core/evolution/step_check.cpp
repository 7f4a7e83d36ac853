#include "core/evolution/step_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/collision/certify.h"
#include "core/evolution/unseen_change.h"
#include "core/mesh/nesting.h"

namespace handlebody {

namespace {

constexpr double kAround = 2;  // longest edges about a fault that are taken back with it

#ifdef HANDLEBODY_CHECK_WHOLE
constexpr bool kChecksWhole = true;
#else
constexpr bool kChecksWhole = false;
#endif

bool has(const Mesh& mesh, int v) { return v >= 0 && v < mesh.vertexSlots() && mesh.isVertex(v); }

Conflict conflictAt(const StepResult& step, const Vec3& place, FindingKind reason) {
  return {place, kAround * step.longest, reason};
}

//! Where the vertex was when all was well, or else where it is.
Conflict conflictAt(const StepResult& step, int vertex, FindingKind reason) {
  if (has(step.before, vertex)) return conflictAt(step, step.before.position(vertex), reason);
  if (has(step.mesh, vertex)) return conflictAt(step, step.mesh.position(vertex), reason);
  int any = 0;
  while (!step.before.isVertex(any)) ++any;  // there is one: what follows from nothing is nothing
  return conflictAt(step, step.before.position(any), reason);
}

//! A fault of the numbers shows nowhere: all that the step has changed on purpose is taken back.
std::vector<Conflict> conflictsAtEvents(const StepResult& step, FindingKind reason) {
  std::vector<Conflict> out;
  for (const Event& e : step.events) {
    Conflict t = conflictAt(step, e.location, reason);
    for (const int size : e.loopSizes) t.radius = std::max(t.radius, size * step.longest / 4);
    out.push_back(t);
  }
  if (out.empty()) out.push_back(conflictAt(step, -1, reason));
  return out;
}

//! The numbers after the events, if each goes on from the one before.
std::optional<TopologyNumbers> predicted(const StepResult& step) {
  TopologyNumbers now = step.topology;
  for (const Event& e : step.events) {
    if (e.before != now) return std::nullopt;
    now = e.after;
  }
  return now;
}

//! Where the components lie, of a surface that intersects nothing.
std::vector<Conflict> nestingFaults(const StepResult& step, const Components& parts) {
  std::vector<Conflict> out;
  for (const int c : misplacedComponents(labelled(step.mesh, parts))) {
    const auto at = std::find(parts.ofVertex.begin(), parts.ofVertex.end(), c);
    const Vec3 place = step.mesh.position(static_cast<int>(at - parts.ofVertex.begin()));
    out.push_back({place, parts.extent[c] + kAround * step.longest,
                   parts.volume[c] < 0 ? FindingKind::cavityOutside : FindingKind::bodyInBody});
  }
  return out;
}

void certifyWhole(const Mesh& mesh) {
  if (mesh.faceCount() == 0) return;
  if (findStructureFault(mesh) || !certify(mesh.compact()).boundsBody())
    throw std::logic_error("A step has passed its check and left an invalid mesh.");
}

}  // namespace

std::vector<Conflict> StepCheck::structureFaults(const StepResult& step) {
  const auto fault = structure_.examineChanges(step.before, step.mesh);
  if (!fault) return {};
  return {conflictAt(step, fault->vertex, fault->what)};
}

//! Precondition: the structure has been examined.
std::vector<Conflict> StepCheck::coverageFaults(const StepResult& step) const {
  std::optional<int> unseen = unseenFace(step.mesh, structure_.newFaces(), step.touched);
  if (!unseen) unseen = unseenMove(step.before, step.mesh, step.touched);
  if (!unseen) return {};
  return {conflictAt(step, *unseen, FindingKind::unseenChange)};
}

//! Without surgery nothing can have joined or parted, and the Euler number is known from the counts.
//! Precondition: the coverage has been examined.
std::vector<Conflict> StepCheck::topologyFaults(const StepResult& step) {
  const std::optional<TopologyNumbers> expected = predicted(step);
  if (!expected) return conflictsAtEvents(step, FindingKind::eventsDisagree);
  const int euler = step.mesh.vertexCount() - step.mesh.faceCount() / 2;  // E = 3F / 2 on a closed mesh
  if (euler != expected->euler) return conflictsAtEvents(step, FindingKind::otherEuler);
  smaller_.follow({step.before, step.mesh, step.touched, step.longestAnywhere});
  const bool areFar = expected->components == 1 || smaller_.areKnown();
  if (step.events.empty() || (!hasSurgery(step.events) && areFar)) return {};
  return componentFaults(step, *expected);
}

//! Counted on the mesh.
std::vector<Conflict> StepCheck::componentFaults(const StepResult& step, const TopologyNumbers& expected) {
  smaller_.forget();
  const bool areSeveral = expected.components > 1;
  const bool areKnown = areSeveral && step.parts != nullptr;
  const Components found = areSeveral && !areKnown ? findComponents(step.mesh) : Components();
  const Components& parts = areKnown ? *step.parts : found;
  const int components = areSeveral ? parts.count() : countComponents(step.mesh);
  if (components != expected.components || expected.genus != (2 * components - expected.euler) / 2)
    return conflictsAtEvents(step, FindingKind::otherComponents);
  std::vector<Conflict> faults;
  if (areSeveral) faults = nestingFaults(step, parts);
  if (faults.empty() && areSeveral) smaller_.know(parts);
  return faults;
}

std::vector<Conflict> StepCheck::faultsOf(const StepResult& step) {
  std::vector<Conflict> faults = structureFaults(step);
  if (faults.empty()) faults = coverageFaults(step);
  if (faults.empty()) faults = topologyFaults(step);
  if (!faults.empty()) return faults;
  volume_ = signedVolume(step.mesh);
  if (step.mesh.faceCount() > 0 && !(std::isfinite(volume_) && volume_ > 0))
    return conflictsAtEvents(step, FindingKind::enclosesNothing);
  if constexpr (kChecksWhole) certifyWhole(step.mesh);
  return {};
}

}  // namespace handlebody
