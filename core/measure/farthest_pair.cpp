#include "core/measure/farthest_pair.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cancellation.h"
#include "core/collision/box_tree.h"

namespace handlebody {

namespace {

constexpr int kWalks = 4;  // from the farthest to the farthest: nearly always the best pair already

struct Best {
  double squared = 0;
  Vec3 from, to;
  bool offer(const Vec3& a, const Vec3& b) {
    const double d = (a - b).squaredNorm();
    if (!(d > squared)) return false;
    squared = d;
    from = a;
    to = b;
    return true;
  }
};

Best goodPair(std::span<const Vec3> points) {
  Best best{0, points[0], points[0]};
  Vec3 at = points[0];
  for (int walk = 0; walk < kWalks; ++walk) {
    const Vec3 start = at;
    bool found = false;
    for (const Vec3& p : points) found |= best.offer(start, p);
    if (!found) break;
    at = best.to;
  }
  return best;
}

//! Points that may be an end of a pair longer than `best`, as seen from the middle of the box around all.
std::vector<Vec3> candidates(std::span<const Vec3> points, double best) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 centre = (low + high) / 2;
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, (p - centre).norm());
  const double least = (best - farthest) * (1 - 1e-12);  // rounding
  std::vector<Vec3> kept;
  for (const Vec3& p : points)
    if ((p - centre).norm() >= least) kept.push_back(p);
  return kept;
}

double farthestOf(const Box& a, const Box& b) {
  return (a.high - b.low).cwiseAbs().cwiseMax((b.high - a.low).cwiseAbs()).squaredNorm();
}

}  // namespace

FarthestPair farthestPair(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Best best = goodPair(points);
  const std::vector<Vec3> kept = candidates(points, std::sqrt(best.squared));
  std::vector<Box> boxes;
  boxes.reserve(kept.size());
  for (const Vec3& p : kept) boxes.push_back({p, p});
  const BoxTree tree(boxes);
  tree.forEachHopeful(
      tree, farthestOf,
      [&](double bound) {
        giveUpIfCancelled();
        return bound > best.squared;
      },
      [&](int i, int j) { best.offer(kept[i], kept[j]); });
  return {std::sqrt(best.squared), best.from, best.to};
}

}  // namespace handlebody
