#include "core/evolution/collapsed_components.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/nesting.h"
#include "core/surgery/predicted_change.h"

namespace handlebody {

namespace {

// Lengths as parts of the target edge length.
constexpr double kCollapsed = 1.0;  // a component of less extent than this is gone
constexpr double kShrinks = 4;      // more than a component loses of its extent in one step

double extentOf(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) box.extend(mesh.position(v));
  return box.sizes().maxCoeff();
}

//! The first vertex of each component.
std::vector<int> firstVertices(const Mesh& mesh, const Components& parts) {
  std::vector<int> first(parts.vertices.size(), -1);
  for (int v = mesh.vertexSlots() - 1; v >= 0; --v)
    if (mesh.isVertex(v)) first[parts.ofVertex[v]] = v;
  return first;
}

bool holdsPinned(const Mesh& mesh, const Components& parts, int component, const CollapsingStep& step) {
  if (!step.isPinned) return false;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && parts.ofVertex[v] == component && step.isPinned(v)) return true;
  return false;
}

//! None of that extent can have collapsed before.
int iterationAfter(double extent, const CollapsingStep& step) {
  return step.iteration + static_cast<int>(extent / (kShrinks * step.edgeLength));
}

}  // namespace

//! None is known to be safe without a look after surgery. Else all are until the smallest may have collapsed
//! by growing smaller; or the largest is, and nothing has come near the others.
bool CollapsedComponents::mustLook(const CollapsingStep& step) const {
  if (step.hasSurgery || step.isPinned) return true;
  const bool areAllLarge = !step.hasEvents && !step.mayShrink && step.iteration < lookAt_;
  const bool areAllFar = smaller_.areKnown() && step.iteration < lookAtLargest_;
  return !areAllLarge && !areAllFar;
}

//! Of a surface that is a single component: far quicker than to find that component.
bool CollapsedComponents::isWhole(const Mesh& mesh, const CollapsingStep& step) {
  const double extent = extentOf(mesh);
  if (extent < kCollapsed * step.edgeLength || !(signedVolume(mesh) > 0)) return false;
  lookAt_ = lookAtLargest_ = iterationAfter(extent, step);
  smaller_.know({});
  cavities_ = 0;
  return true;
}

void CollapsedComponents::know(const Components& parts, const CollapsingStep& step) {
  lookAt_ = lookAtLargest_ = step.iteration;
  if (parts.count() == 0) return;
  const auto [smallest, largest] = std::minmax_element(parts.extent.begin(), parts.extent.end());
  lookAt_ = iterationAfter(*smallest, step);
  lookAtLargest_ = iterationAfter(*largest, step);
  smaller_.know(parts);
}

bool CollapsedComponents::mayHaveTurned(const Components& parts, const CollapsingStep& step) {
  const auto cavities =
      std::count_if(parts.volume.begin(), parts.volume.end(), [](double v) { return v < 0; });
  const bool isOther = cavities_ != cavities;
  cavities_ = cavities;
  return isOther || step.isPinned || (step.mayShrink && step.hasEvents);
}

ErasedComponents CollapsedComponents::erase(Mesh& mesh, const CollapsingStep& step) {
  smaller_.follow(step.motion);
  if (!mustLook(step)) return {};
  if (step.topology.components == 1 && isWhole(mesh, step)) return {};
  const auto found = std::make_shared<const Components>(findComponents(mesh));
  const Components& parts = *found;
  know(parts, step);
  const bool looksForTurned = mayHaveTurned(parts, step);
  const std::vector<int> first = firstVertices(mesh, parts);
  std::vector<Event> events;
  TopologyNumbers now = step.topology;
  // One look at every face for all of them, and another when one is gone.
  std::vector<int> turned;
  const auto lookForTurned = [&] {
    if (looksForTurned) turned = misplacedComponents(labelled(mesh, parts));
  };
  lookForTurned();
  for (int c = 0; c < parts.count(); ++c) {
    const Vec3 place = mesh.position(first[c]);
    const bool isTurned = std::binary_search(turned.begin(), turned.end(), c);
    const bool hasCollapsed = parts.extent[c] < kCollapsed * step.edgeLength;
    const bool isGone = hasCollapsed && !step.isKept(place) && !holdsPinned(mesh, parts, c, step);
    if (hasCollapsed && !isGone) smaller_.forget();  // it may go without moving
    if (!isTurned && !isGone) continue;
    Event event;
    event.kind = EventKind::componentDeleted;
    event.iteration = step.iteration;
    event.location = place;
    event.before = now;
    event.after = now = predictDeletion(now, parts, c);
    deleteComponent(mesh, first[c]);
    lookForTurned();
    events.push_back(std::move(event));
  }
  if (!events.empty()) return {std::move(events), nullptr};
  return {{}, found};
}

}  // namespace handlebody
