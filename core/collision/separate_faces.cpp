#include "core/collision/separate_faces.h"

#include <bit>
#include <cmath>

#include "core/collision/near_faces.h"

namespace handlebody {

namespace {

constexpr double kRounding = DetectionWorkspace::kRounding;

//! What rejects a face T at its corner: both other vertices are behind, or one is P.
struct SkipBits {
  bool behind, same;
};
constexpr std::size_t kSkipBits = 31;

//! Bit i: corner i is not skipped. Without branches, for nobody could foretell them. In a cycle prev of a
//! corner is next of the following one.
template <typename Skip>
unsigned notSkipped(std::span<const Corner> corners, bool inOrder, Skip&& skip) {
  unsigned behind = 0, same = 0;
  const auto add = [&](int r, std::size_t bit) {
    const SkipBits s = skip(r);
    behind |= static_cast<unsigned>(s.behind) << bit;
    same |= static_cast<unsigned>(s.same) << bit;
  };
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) add(corners[i].next, i);
  if (inOrder) {
    add(corners[n - 1].prev, n);
    behind &= behind >> 1;
    same |= same >> 1;
  } else {
    unsigned prevBehind = 0;
    std::swap(behind, prevBehind);
    for (std::size_t i = 0; i < n; ++i) add(corners[i].prev, i);
    behind &= prevBehind;
  }
  return ~(behind | same) & ((1u << n) - 1);
}

//! False if an earlier vertex of T is as near to v as u is: then T has its turn there.
bool isFirstNear(const DetectionWorkspace& work, int u, const Triangle& t, int v) {
  for (std::size_t i = 0; t[i] != u; ++i) {
    if ((work.points[t[i]] - work.points[v]).squaredNorm() <= work.reachSquared(t[i], v)) return false;
  }
  return true;
}

//! Face f against the faces at v.
void testFan(const DetectionWorkspace& work, int f, int v, std::vector<FacePair>& found) {
  const Triangle& t = work.faces[f];
  const Box box = work.boxOf(f);
  for (const Corner& c : work.stars.corners(v))
    if (work.isWanted(f, c.face) && work.boxOf(c.face).overlaps(box) && !shareVertex(work.faces[c.face], t))
      work.test(f, c.face, found);
}

//! The faces T at u against the faces at P = v.
void testNear(const DetectionWorkspace& work, int u, int v, double distanceSquared,
              std::vector<FacePair>& found) {
  const std::span<const Vec3> points = work.points;
  const double nearSquared = work.sizes[v].longestEdge * (0.25 * kRounding);
  const Vec3& pu = points[u];
  const Vec3 w = points[v] - pu;
  // First a cheap rejection: a face whose corners stay behind `end` along w is too far from v.
  const double end = std::max(0.0, distanceSquared - std::sqrt(distanceSquared * nearSquared) -
                                       (kRounding - 1) * (distanceSquared + work.sizes[u].longestEdge));
  const auto skip = [&](int r) { return SkipBits{end > 0 && w.dot(points[r] - pu) < end, r == v}; };
  const std::span<const Corner> corners = work.stars.corners(u);
  for (std::size_t first = 0; first < corners.size(); first += kSkipBits) {
    const auto some = corners.subspan(first, std::min(kSkipBits, corners.size() - first));
    for (unsigned left = notSkipped(some, work.stars.isCycle(u), skip); left != 0; left &= left - 1) {
      const Corner& c = some[std::countr_zero(left)];
      if (!work.isActive(v) && !work.isWanted(c.face)) continue;
      if (isFarFrom(points[v], pu, points[c.next], points[c.prev], nearSquared)) continue;
      if (isFirstNear(work, u, work.faces[c.face], v)) testFan(work, c.face, v, found);
    }
  }
}

}  // namespace

bool SeparateFaces::test(DetectionWorkspace& work) {
  const auto testAll = [&work](auto& near) {
    work.findInShares([&](const Share& share, std::vector<FacePair>& found) {
      near.forEachPair(
          [&](int u, int v, double distanceSquared) {
            if (!work.isActive(u) && !work.isActive(v)) return;
            if (distanceSquared <= work.reachSquared(u, v)) testNear(work, u, v, distanceSquared, found);
            if (distanceSquared <= work.reachSquared(v, u)) testNear(work, v, u, distanceSquared, found);
          },
          share);
    });
    return true;
  };
  if (work.areLevelsWorth())
    return levelPairs_.build(work.points, work.vertices, work.starSizes, work.longestSquared) &&
           testAll(levelPairs_);
  return nearPairs_.build(work.points, work.vertices, work.reach()) && testAll(nearPairs_);
}

}  // namespace handlebody
