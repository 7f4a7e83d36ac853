#include "core/evolution/pinned_check.h"

#include <cmath>

#include "core/indices.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

constexpr double kFlat = 0.01;  // cubes of the edge length: a component of less volume has been pressed flat

}  // namespace

std::vector<Conflict> pressedFlat(const Mesh& mesh, const PinnedParts& pins,
                                  std::span<const unsigned char> touched, double edgeLength) {
  std::vector<Conflict> out;
  if (!pins.any()) return out;
  const Components parts = findComponents(mesh);
  const double least = kFlat * std::pow(edgeLength, 3);
  std::vector<unsigned char> isPinned(parts.count(), 0);
  std::vector<int> moving(parts.count(), -1);  // a vertex
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const int c = parts.ofVertex[v];
    if (c < 0) continue;
    if (pins.holds(v))
      isPinned[c] = 1;
    else if (idx(v) < touched.size() && touched[v] != 0)
      moving[c] = v;
  }
  for (int c = 0; c < parts.count(); ++c) {
    const bool isFlat = std::abs(parts.volume[c]) < least;
    if (!isFlat || isPinned[c] == 0 || moving[c] < 0) continue;
    out.push_back({mesh.position(moving[c]), parts.extent[c], FindingKind::closesOverPinned});
    out.back().atPin = true;
  }
  return out;
}

std::vector<Conflict> changesOfPinned(const Mesh& before, const Mesh& mesh, const PinnedParts& pins,
                                      std::span<const Event> events, double radius) {
  std::vector<Conflict> out;
  const auto place = pins.broken(before, mesh);
  if (!place) return out;
  constexpr FindingKind kReason = FindingKind::pinnedWouldChange;
  out.push_back({*place, radius, kReason});
  for (const Event& e : events) out.push_back({e.location, radius, kReason});
  return out;
}

}  // namespace handlebody
