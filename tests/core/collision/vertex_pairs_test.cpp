#include "core/collision/vertex_pairs.h"

#include "core/collision/near_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "core/collision/self_intersection.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

using Pairs = std::vector<std::pair<int, int>>;

std::vector<Vec3> cloud(int n, const Vec3& extent, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const auto c = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    const double x = c(), y = c(), z = c();
    points.push_back(extent.cwiseProduct(Vec3(x, y, z)));
  }
  return points;
}

std::vector<int> allOf(const std::vector<Vec3>& points) {
  std::vector<int> v(points.size());
  std::iota(v.begin(), v.end(), 0);
  return v;
}

Pairs bruteForce(const std::vector<Vec3>& p, double radius) {
  Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      if ((p[i] - p[j]).norm() <= radius) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

//! The paper's Eq. (1), as an integer: floor(a/l + i/2).
int paperBox(double a, double l, int i) { return static_cast<int>(std::floor(a / l + 0.5 * i)); }

}  // namespace

TEST_CASE("every pair within the radius is found exactly once, by either broad phase") {
  const BroadPhase phase = GENERATE(BroadPhase::sorted, BroadPhase::hashing);
  for (const Vec3& extent : {Vec3(20, 20, 20), Vec3(4000, 1, 1), Vec3(90, 90, 0), Vec3(1, 2, 3000)}) {
    const auto points = cloud(1500, extent, 1);
    for (const double radius : {0.8, 1.7}) {
      VertexPairs near;
      near.use(phase);
      const std::vector<int> all = allOf(points);
      REQUIRE(near.build(points, all, radius));
      Pairs found;
      near.forEachPair([&](int u, int v, double d) {
        const double expected = (points[u] - points[v]).squaredNorm();
        REQUIRE(d == expected);
        found.emplace_back(std::min(u, v), std::max(u, v));
      });
      std::sort(found.begin(), found.end());
      const Pairs expected = bruteForce(points, radius);
      CHECK(expected.size() > 10);
      CHECK(found == expected);
    }
  }
}

TEST_CASE("all shares together have each pair once, however many there are") {
  const BroadPhase phase = GENERATE(BroadPhase::sorted, BroadPhase::hashing);
  for (const Vec3& extent : {Vec3(20, 20, 20), Vec3(4000, 1, 1), Vec3(1, 2, 3000)}) {
    const auto points = cloud(1500, extent, 7);
    VertexPairs near;
    near.use(phase);
    const std::vector<int> all = allOf(points);
    REQUIRE(near.build(points, all, 1.7));
    for (const std::size_t parts : {1, 2, 3, 16, 5000}) {
      Pairs found;
      for (std::size_t part = 0; part < parts; ++part)
        near.forEachPair([&](int u, int v, double) { found.emplace_back(std::min(u, v), std::max(u, v)); },
                         {part, parts});
      std::sort(found.begin(), found.end());
      CHECK(found == bruteForce(points, 1.7));
    }
  }
}

TEST_CASE("points near to marked ones are never missed, and few others are taken for near") {
  const auto points = cloud(6000, Vec3(40, 40, 4), 2);
  std::vector<int> marked;
  for (int v = 0; v < 6000; ++v)
    if (points[v].x() > 16) marked.push_back(v);
  NearPoints near;
  for (const double radius : {0.01, 0.9, 100.0}) {
    near.build(points, marked, radius);
    int taken = 0, wrong = 0;
    for (const Vec3& p : points) {
      const bool isNear =
          std::any_of(marked.begin(), marked.end(), [&](int v) { return (points[v] - p).norm() <= radius; });
      const bool found = near.mayBeNear(p);
      REQUIRE((found || !isNear));
      taken += found;
      wrong += found && !isNear;
    }
    CHECK(wrong < 0.2 * static_cast<double>(points.size()));
    CHECK(taken >= static_cast<int>(marked.size()));
  }
}

TEST_CASE("the boxes of the eight hash functions are blocks of half boxes, negative coordinates too") {
  const double l = 0.75;
  for (double a = -10; a < 10; a += 0.0625) {
    const int half = static_cast<int>(std::floor(2 * a / l));
    for (int i = 0; i < 2; ++i) REQUIRE(boxIndex(half, i) == paperBox(a, l, i));
  }
}

TEST_CASE("points closer than half a box share a box of one of the eight functions (Theorem 3)") {
  const double l = 1;
  const auto points = cloud(400, Vec3(3, 3, 3), 3);
  const std::vector<int> all = allOf(points);
  const auto boxes = halfBoxesFor(points, all, l / 2);
  REQUIRE(boxes);
  const auto shareBox = [&](const Vec3& p, const Vec3& q) {
    const auto a = boxes->boxOf(p), b = boxes->boxOf(q);
    bool shared = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      shared = shared &&
               (boxIndex(a[axis], 0) == boxIndex(b[axis], 0) || boxIndex(a[axis], 1) == boxIndex(b[axis], 1));
    return shared;
  };
  int near = 0, apart = 0;
  for (const Vec3& p : points)
    for (const Vec3& q : points) {
      if ((p - q).norm() <= l / 2) {
        REQUIRE(shareBox(p, q));
        ++near;
      } else {
        apart += !shareBox(p, q);
      }
    }
  CHECK(near > 1000);
  CHECK(apart > near);  // a box for all would not do
}

TEST_CASE("any size of the hash table gives the same pairs, a smaller one more to look at") {
  const auto points = cloud(1500, Vec3(20, 20, 20), 5);
  const std::vector<int> all = allOf(points);
  const Pairs expected = bruteForce(points, 0.9);
  std::size_t candidatesBefore = std::numeric_limits<std::size_t>::max();
  for (const double tableSize : {0.0, 0.125, 0.5, 2.0, 8.0}) {
    SpatialHash hash(tableSize);
    const bool isLinear = hash.build(points, all, 0.9);
    CHECK(isLinear == (tableSize > 0));  // with one entry all vertices have the same value
    Pairs found;
    hash.forEachPair([&](int u, int v, double) { found.emplace_back(std::min(u, v), std::max(u, v)); });
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
    const std::size_t candidates = hash.countCandidates();
    CHECK(candidates < candidatesBefore);
    candidatesBefore = candidates;
  }
}

TEST_CASE("both broad phases find the same self-intersections on every mesh of the zoo") {
  for (const TriangleSoup& s : zoo::intersecting()) {
    CAPTURE(s.points.size());
    CollisionDetector sorted, hashing;
    hashing.use(BroadPhase::hashing);
    CHECK(hashing.detectAll(s.points, s.triangles) == sorted.detectAll(s.points, s.triangles));
    std::vector<unsigned char> moved(s.points.size());
    for (std::size_t v = 0; v < moved.size(); v += 3) moved[v] = 1;
    CHECK(hashing.detectMoved(s.points, s.triangles, moved) ==
          sorted.detectMoved(s.points, s.triangles, moved));
  }
}

TEST_CASE("a crowd, a radius of nothing and boxes beyond counting are refused by either broad phase") {
  const BroadPhase phase = GENERATE(BroadPhase::sorted, BroadPhase::hashing);
  VertexPairs near;
  near.use(phase);
  const auto points = cloud(2000, Vec3(10, 10, 10), 4);
  const std::vector<int> all = allOf(points);
  CHECK_FALSE(near.build(points, all, 0));
  CHECK_FALSE(near.build(points, all, 8));
  CHECK_FALSE(near.build(points, all, 1e-9));
  CHECK_FALSE(near.build(points, {}, 1));
  CHECK(near.build(points, all, 0.5));
}
