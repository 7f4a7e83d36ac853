#include "core/collision/spatial_hash.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "tests/support/catch.h"

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

Pairs bruteForce(const std::vector<Vec3>& p, double radius, const std::vector<unsigned char>& active) {
  Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      if ((active[i] | active[j]) != 0 && (p[i] - p[j]).norm() <= radius) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

//! The paper's Eq. (1), as an integer: floor(a/l + i/2).
int paperBox(double a, double l, int i) { return static_cast<int>(std::floor(a / l + 0.5 * i)); }

}  // namespace

TEST_CASE("every pair within the radius is found exactly once") {
  for (const Vec3& extent : {Vec3(20, 20, 20), Vec3(4000, 1, 1), Vec3(90, 90, 0), Vec3(1, 2, 3000)}) {
    const auto points = cloud(1500, extent, 1);
    for (const double radius : {0.8, 1.7}) {
      SpatialHash hash;
      REQUIRE(hash.build(points, allOf(points), radius));
      Pairs found;
      hash.forEachPair([&](const auto& a, const auto& b) {
        found.emplace_back(std::min(a.vertex, b.vertex), std::max(a.vertex, b.vertex));
      });
      std::sort(found.begin(), found.end());
      const Pairs expected = bruteForce(points, radius, std::vector<unsigned char>(points.size(), 1));
      CHECK(expected.size() > 10);
      CHECK(found == expected);
    }
  }
}

TEST_CASE("with active vertices, every pair that has one is found exactly once") {
  const auto points = cloud(1500, Vec3(12, 12, 12), 2);
  std::vector<unsigned char> active(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) active[v] = points[v].x() > 4;
  SpatialHash hash;
  REQUIRE(hash.build(points, allOf(points), 1));
  Pairs found;
  hash.forEachPair(active, [&](const auto& a, const auto& b) {
    found.emplace_back(std::min(a.vertex, b.vertex), std::max(a.vertex, b.vertex));
  });
  std::sort(found.begin(), found.end());
  CHECK(found == bruteForce(points, 1, active));
}

TEST_CASE("the boxes of the eight hash functions are blocks of half boxes, negative coordinates too") {
  const double l = 0.75;
  for (double a = -10; a < 10; a += 0.0625) {
    const int half = static_cast<int>(std::floor(2 * a / l));
    for (int i = 0; i < 2; ++i) REQUIRE(SpatialHash::boxIndex(half, i) == paperBox(a, l, i));
  }
}

TEST_CASE("points closer than half a box share a box of one of the eight functions (Theorem 3)") {
  const double l = 1;
  const auto points = cloud(400, Vec3(3, 3, 3), 3);
  for (const Vec3& p : points) {
    for (const Vec3& q : points) {
      if ((p - q).norm() > l / 2) continue;
      bool shared = true;
      for (int axis = 0; axis < 3; ++axis) {
        shared = shared && (paperBox(p[axis], l, 0) == paperBox(q[axis], l, 0) ||
                            paperBox(p[axis], l, 1) == paperBox(q[axis], l, 1));
      }
      REQUIRE(shared);
    }
  }
}

TEST_CASE("a crowd, a radius of nothing and boxes beyond counting are refused") {
  SpatialHash hash;
  const auto points = cloud(2000, Vec3(10, 10, 10), 4);
  CHECK_FALSE(hash.build(points, allOf(points), 0));
  CHECK_FALSE(hash.build(points, allOf(points), 8));
  CHECK_FALSE(hash.build(points, allOf(points), 1e-9));
  CHECK_FALSE(hash.build(points, {}, 1));
  CHECK(hash.build(points, allOf(points), 0.5));
}
