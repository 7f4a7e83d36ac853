#include "core/measure/wall_thickness.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/pieces.h"
#include "core/mesh/topology.h"
#include "core/phase.h"

namespace handlebody {

namespace {
constexpr std::size_t kSamples = 200'000;  // on both surfaces together
}

WallThickness wallThickness(const TriangleSoup& first, const TriangleSoup& second, int threads) {
  const Phase phase("wall thickness");
  WallThickness t;
  // Pieces whose longest edge is at most h have some h²/8 of area each.
  t.sampling = std::sqrt(8 * (areaOf(first) + areaOf(second)) / static_cast<double>(kSamples));
  const std::size_t most = 8 * kSamples + 2 * (first.triangles.size() + second.triangles.size());
  while (countSamples(first, t.sampling, most) + countSamples(second, t.sampling, most) > most)
    t.sampling *= 2;
  t.fromFirst = directedDistances(first, second, t.sampling, threads);
  t.fromSecond = directedDistances(second, first, t.sampling, threads);
  return t;
}

std::array<TriangleSoup, 2> outerAndInner(const TriangleSoup& mesh) {
  const Mesh structure(mesh);
  const Components parts = findComponents(structure);
  std::array<TriangleSoup, 2> surfaces;
  for (TriangleSoup& s : surfaces) s.points = mesh.points;
  for (const Triangle& t : mesh.triangles) {
    const int part = parts.ofVertex[t[0]];
    surfaces[parts.volume[part] < 0 ? 1 : 0].triangles.push_back(t);
  }
  for (TriangleSoup& s : surfaces) s = withoutLoosePoints(s);
  return surfaces;
}

}  // namespace handlebody
