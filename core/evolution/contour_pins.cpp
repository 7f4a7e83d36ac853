// What pins keep from happening in a step.

#include "core/evolution/contour_state.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kFlat = 0.01;  // cubes of the edge length: a component of less volume has been pressed flat

}  // namespace

//! A cavity over a pinned part, or a body under one, cannot go: what would press it flat stops.
void ActiveContour::State::stopBeforeFlat(Attempt& a) const {
  const TopologyNumbers& now = a.events.empty() ? topology : a.events.back().after;
  if (!pins.any() || now.components < 2) return;
  const Components parts = findComponents(mesh);
  const double least = kFlat * std::pow(parameters.edgeLength, 3);
  std::vector<unsigned char> isPinned(idx(parts.count()), 0);
  std::vector<int> moving(idx(parts.count()), -1);  // a vertex
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const int c = parts.ofVertex[idx(v)];
    if (c < 0) continue;
    if (pins.holds(v))
      isPinned[idx(c)] = 1;
    else if (idx(v) < a.touched.size() && a.touched[idx(v)] != 0)
      moving[idx(c)] = v;
  }
  for (int c = 0; c < parts.count(); ++c) {
    const bool isFlat = std::abs(parts.volume[idx(c)]) < least;
    if (!isFlat || isPinned[idx(c)] == 0 || moving[idx(c)] < 0) continue;
    a.troubles.push_back(
        {mesh.position(moving[idx(c)]), parts.extent[idx(c)], FindingKind::closesOverPinned});
    a.troubles.back().atPin = true;
  }
}

//! What no look ahead has kept from changing what is pinned, is taken back.
void ActiveContour::State::lookAtPins(Attempt& a) const {
  const auto place = pins.broken(transaction.before(), mesh);
  if (!place) return;
  constexpr FindingKind kReason = FindingKind::pinnedWouldChange;
  a.troubles.push_back({*place, 2 * limits.longest, kReason});
  for (const Event& e : a.events) a.troubles.push_back({e.location, 2 * limits.longest, kReason});
}

void ActiveContour::State::takePins() {
  pins.take(mesh, iteration);
  chooseForbidden();
}

}  // namespace handlebody
