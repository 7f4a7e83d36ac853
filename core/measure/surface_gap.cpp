#include "core/measure/surface_gap.h"

#include <cmath>
#include <limits>

#include "core/cancellation.h"
#include "core/collision/box_tree.h"
#include "core/geometry/closest_points.h"
#include "core/geometry/triangle_distance.h"
#include "core/phase.h"

namespace handlebody {

namespace {

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const TriangleSoup& mesh, int triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

std::vector<Box> boxesOf(const TriangleSoup& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const auto [a, b, c] = cornersOf(mesh, i);
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  return boxes;
}

double squaredGap(const Box& a, const Box& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

SurfaceGap surfaceGap(const TriangleSoup& a, const TriangleSoup& b) {
  const Phase phase("distance");
  const std::vector<Box> boxesA = boxesOf(a), boxesB = boxesOf(b);
  double least = std::numeric_limits<double>::infinity();
  std::array<int, 2> nearest{0, 0};
  const auto look = [&](int i, int j) {
    if (!(squaredGap(boxesA[i], boxesB[j]) < least)) return;
    const double squared = squaredDistance(cornersOf(a, i), cornersOf(b, j));
    if (!(squared < least)) return;
    least = squared;
    nearest = {i, j};
  };
  BoxTree(boxesA).forEachHopeful(
      BoxTree(boxesB), [](const Box& p, const Box& q) { return -squaredGap(p, q); },
      [&](double bound) {
        giveUpIfCancelled();
        return -bound < least;
      },
      look);
  const auto [onA, onB] = closestPoints(cornersOf(a, nearest[0]), cornersOf(b, nearest[1]));
  const BodyContact contact = bodyContact(a, b);
  return {contact, contact == BodyContact::surfaces ? 0 : std::sqrt(least), onA, onB};
}

std::vector<PairGap> pairGaps(const std::vector<const TriangleSoup*>& bodies) {
  std::vector<PairGap> gaps;
  for (int j = 0; j < static_cast<int>(bodies.size()); ++j)
    for (int i = 0; i < j; ++i) gaps.push_back({i, j, surfaceGap(*bodies[i], *bodies[j])});
  return gaps;
}

}  // namespace handlebody
