#include "core/collision/vertex_levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "core/collision/face_pair.h"
#include "core/collision/self_intersection.h"
#include "tests/support/catch.h"
#include "tests/support/graded_mesh.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

using Pairs = std::vector<std::pair<int, int>>;

//! Points in a cube, each with a size between 1/12 and 1 (mm), the small ones crowded near the origin.
struct Sized {
  std::vector<Vec3> points;
  std::vector<double> squared;
};

Sized sized(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Sized s;
  for (int i = 0; i < n; ++i) {
    const double size = std::pow(12.0, -unit(random));
    const double x = unit(random), y = unit(random), z = unit(random);
    s.points.push_back(20 * size * Vec3(x, y, z));
    s.squared.push_back(size * size);
  }
  return s;
}

double largest(const Sized& s) { return *std::max_element(s.squared.begin(), s.squared.end()); }

Pairs bruteForce(const Sized& s) {
  Pairs pairs;
  for (std::size_t i = 0; i < s.points.size(); ++i)
    for (std::size_t j = i + 1; j < s.points.size(); ++j)
      if ((s.points[i] - s.points[j]).squaredNorm() <= 7.0 / 12 * std::max(s.squared[i], s.squared[j]))
        pairs.emplace_back(i, j);
  return pairs;
}

//! By a look at all pairs of faces.
std::vector<FacePair> everyPair(const TriangleSoup& s) {
  std::vector<FacePair> pairs;
  for (std::size_t f = 0; f < s.triangles.size(); ++f)
    for (std::size_t g = f + 1; g < s.triangles.size(); ++g)
      if (facesIntersect(s.points, s.triangles[f], s.triangles[g])) pairs.emplace_back(f, g);
  return pairs;
}

}  // namespace

TEST_CASE("levels find every pair within the reach of the coarser one exactly once, by either broad phase") {
  const BroadPhase phase = GENERATE(BroadPhase::sorted, BroadPhase::hashing);
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Sized s = sized(1200, seed);
    std::vector<int> all(s.points.size());
    std::iota(all.begin(), all.end(), 0);
    LevelPairs pairs;
    pairs.use(phase);
    REQUIRE(pairs.build(s.points, all, s.squared, largest(s)));
    Pairs found;
    pairs.forEachPair([&](int u, int v, double d) {
      const auto i = static_cast<std::size_t>(std::min(u, v)), j = static_cast<std::size_t>(std::max(u, v));
      REQUIRE(d == (s.points[i] - s.points[j]).squaredNorm());
      found.emplace_back(i, j);
    });
    std::sort(found.begin(), found.end());
    CHECK(std::adjacent_find(found.begin(), found.end()) == found.end());
    const Pairs expected = bruteForce(s);
    CHECK(expected.size() > 100);
    CHECK(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
  }
}

TEST_CASE("points within the reach of marked ones, or whose own reach holds one, are never missed") {
  const Sized s = sized(1500, 4);
  std::vector<int> marked;
  std::vector<double> squared;
  for (std::size_t i = 0; i < s.points.size(); i += 7) {
    marked.push_back(static_cast<int>(i));
    squared.push_back(s.squared[i]);
  }
  NearLevels near;
  near.build(s.points, marked, squared, largest(s));
  int taken = 0, wanted = 0;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const bool isNear = std::any_of(marked.begin(), marked.end(), [&](int m) {
      const auto j = static_cast<std::size_t>(m);
      return (s.points[i] - s.points[j]).squaredNorm() <= 7.0 / 12 * std::max(s.squared[i], s.squared[j]);
    });
    const bool may = near.mayBeNear(s.points[i], s.squared[i]);
    if (isNear) REQUIRE(may);
    wanted += isNear;
    taken += may;
  }
  CHECK(wanted > 230);
  CHECK(taken < 1500);  // the marked ones are near themselves, others are not
}

TEST_CASE("levels are used where sizes differ much, and not on an even mesh") {
  const std::vector<double> even(100, 2.0);
  CHECK_FALSE(VertexLevels::areWorth(even, 2.5));
  std::vector<double> graded(100, 0.1);
  graded[3] = 2.5;
  CHECK(VertexLevels::areWorth(graded, 2.5));
}

TEST_CASE("on a graded mesh all intersections are found, and by what has moved those that it takes part in") {
  // The short edges of the second sphere meet the long ones of the first.
  TriangleSoup s = zoo::graded(zoo::sphere(10));
  const TriangleSoup other = zoo::moved(zoo::graded(zoo::sphere(8)), Vec3(0.15, 0.1, -1.85));
  const int shift = static_cast<int>(s.points.size());
  s.points.insert(s.points.end(), other.points.begin(), other.points.end());
  for (Triangle t : other.triangles) {
    for (int& v : t) v += shift;
    s.triangles.push_back(t);
  }
  CollisionDetector all, some;
  const std::vector<FacePair> expected = everyPair(s);
  CHECK(all.detectAll(s.points, s.triangles) == expected);
  CHECK(expected.size() > 20);
  // The second sphere has moved; then half of it, and nothing else that meets anything.
  std::vector<unsigned char> moved(s.points.size(), 0);
  std::fill(moved.begin() + shift, moved.end(), static_cast<unsigned char>(1));
  CHECK(some.detectMoved(s.points, s.triangles, moved) == expected);
  std::vector<FacePair> ofHalf;
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] = moved[v] != 0 && s.points[v].x() > 0.15;
  const auto hasMoved = [&](int f) {
    const Triangle& t = s.triangles[f];
    return std::any_of(t.begin(), t.end(), [&](int v) { return moved[v] != 0; });
  };
  for (const FacePair& p : expected)
    if (hasMoved(p.first) || hasMoved(p.second)) ofHalf.push_back(p);
  CHECK(ofHalf.size() > 5);
  CHECK(ofHalf.size() < expected.size());
  CHECK(some.detectMoved(s.points, s.triangles, moved) == ofHalf);
}
