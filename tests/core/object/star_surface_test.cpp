#include "core/object/star_surface.h"

#include <algorithm>
#include <functional>
#include <random>

#include "core/object/closure.h"
#include "core/object/rays.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

using Pairs = std::vector<std::array<std::size_t, 2>>;

//! The least cost of all sets that hold with each pair's first node its second.
double leastCost(const Pairs& pairs, const std::vector<double>& costs) {
  double best = 0;
  for (std::size_t set = 0; set < (std::size_t{1} << costs.size()); ++set) {
    const auto has = [&](std::size_t i) { return (set >> i & 1) != 0; };
    if (std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) { return has(p[0]) && !has(p[1]); }))
      continue;
    double cost = 0;
    for (std::size_t i = 0; i < costs.size(); ++i) cost += has(i) ? costs[i] : 0;
    best = std::min(best, cost);
  }
  return best;
}

using Inside = std::function<bool(const Vec3&)>;

//! Speckle, as ultrasound has it: the noise grows with the intensity; no voxel tells inside from outside.
Volume speckled(const Grid& grid, const Inside& inside, double in, double out) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  return volumeByIndex(grid, [&](int i, int j, int k) {
    const double mean = inside(grid.toWorld(Vec3(i, j, k))) ? in : out;
    return mean * std::hypot(normal(random), normal(random));
  });
}

struct Scene {
  CellImage image;
  std::vector<float> values;
};
Scene sceneOf(const Volume& volume) {
  const ObjectPolicy policy;
  const CellGrid cells =
      cellsAround(volume.grid, volume.grid.toWorld(Vec3(20, 20, 20)), 100, policy.wideCells);
  Scene s{makeCells(volume, cells, nullptr), {}};
  s.values = smoothed(cells, s.image.values, policy.smoothing);
  return s;
}

double diceOf(const Scene& s, const StarRegion& star, const Inside& truth) {
  const CellGrid& cells = s.image.cells;
  double both = 0, all = 0;
  forBox({{0, 0, 0}, {cells.grid.size[0] - 1, cells.grid.size[1] - 1, cells.grid.size[2] - 1}},
         [&](const std::array<int, 3>& c) {
           const bool has = star.inside[cells.at(c)] != 0,
                      should = truth(cells.grid.toWorld(Vec3(c[0], c[1], c[2])));
           both += has && should, all += has + should;
         });
  return 2 * both / all;
}

CellClick at(const Vec3& place) { return {place, 0, 0}; }

//! Half-axes 13, 10 and 10 mm.
bool inEllipsoid(const Vec3& p) {
  return (p - Vec3(22, 20, 20)).cwiseQuotient(Vec3(13, 10, 10)).squaredNorm() < 1;
}

}  // namespace

TEST_CASE("the cheapest closed set costs as little as the best of all sets") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> cost(-9, 9), node(0, 9);
  for (int round = 0; round < 200; ++round) {
    Pairs pairs;
    for (int k = 0; k < 14; ++k) {
      const auto a = static_cast<std::size_t>(node(random)), b = static_cast<std::size_t>(node(random));
      if (a != b) pairs.push_back({a, b});
    }
    std::vector<double> costs(10);
    for (double& c : costs) c = cost(random);
    const auto in = Closure(costs.size(), pairs).cheapest(costs);
    double found = 0;
    for (std::size_t i = 0; i < costs.size(); ++i) found += in[i] ? costs[i] : 0;
    CHECK(found == leastCost(pairs, costs));
    for (const auto& [a, b] : pairs) CHECK((!in[a] || in[b]));
  }
}

TEST_CASE("a closure can be asked again with other costs") {
  Closure closure(3, {{2, 1}, {1, 0}});
  CHECK(closure.cheapest({1, 1, -3}) == std::vector<std::uint8_t>{1, 1, 1});
  CHECK(closure.cheapest({-1, 1, -0.5}) == std::vector<std::uint8_t>{1, 0, 0});
  CHECK(closure.cheapest({1, 1, -3}) == std::vector<std::uint8_t>{1, 1, 1});
}

TEST_CASE("rays are evenly spread, and the weights of the nearest sum to one") {
  const Rays rays(ObjectPolicy{}.starRays);
  for (const auto& [a, b] : rays.pairs) CHECK((rays.directions[a] - rays.directions[b]).norm() < 0.34);
  CHECK(rays.pairs.size() == 3 * rays.directions.size() - 6);  // a closed surface of triangles
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 to = Vec3(normal(random), normal(random), normal(random)).normalized();
    const NearestRays near = nearestRays(rays, to);
    REQUIRE(near.weight[0] + near.weight[1] + near.weight[2] == Approx(1));
    std::vector<double> cosines;
    for (const Vec3& d : rays.directions) cosines.push_back(d.dot(to));
    std::sort(cosines.rbegin(), cosines.rend());
    for (std::size_t i = 0; i < 3; ++i) REQUIRE(rays.directions[near.ray[i]].dot(to) == cosines[i]);
  }
}

TEST_CASE("a star-shaped region finds an ellipsoid in speckle, from beside its middle") {
  const Scene s = sceneOf(speckled(cubicGrid(45), inEllipsoid, 40, 80));
  const auto stars = starRegions(s.image, s.values, {at(Vec3(26, 22, 18))}, {}, {}, 1);
  REQUIRE_FALSE(stars.empty());
  const auto best =
      std::max_element(stars.begin(), stars.end(),
                       [](const StarRegion& a, const StarRegion& b) { return a.agreement < b.agreement; });
  CHECK(diceOf(s, *best, inEllipsoid) > 0.9);
  CHECK(best->agreement >= 0.5);
}

TEST_CASE("star-shaped regions do not depend on the number of threads") {
  const Scene s = sceneOf(speckled(cubicGrid(45), inEllipsoid, 80, 40));
  const auto one = starRegions(s.image, s.values, {at(Vec3(22, 20, 20))}, {}, {}, 1);
  const auto three = starRegions(s.image, s.values, {at(Vec3(22, 20, 20))}, {}, {}, 3);
  REQUIRE(one.size() == three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].inside == three[i].inside);
    CHECK(one[i].agreement == three[i].agreement);
  }
}

TEST_CASE("every click lies on its side of a star-shaped region, whatever the image") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(12, 32);
  const Scene s = sceneOf(speckled(cubicGrid(45), inEllipsoid, 60, 60));
  std::size_t found = 0;
  for (int round = 0; round < 10; ++round) {
    std::vector<CellClick> inside, outside;
    for (int k = 0; k < 3; ++k) {
      inside.push_back(at(Vec3(place(random), place(random), place(random))));
      outside.push_back(at(Vec3(place(random), place(random), place(random))));
    }
    for (const StarRegion& star : starRegions(s.image, s.values, inside, outside, {}, 1)) {
      const auto holds = [&](const CellClick& c) {
        return star.inside[s.image.cells.at(s.image.cells.nearest(c.place))] != 0;
      };
      for (const CellClick& c : inside) CHECK(holds(c));
      for (const CellClick& c : outside) CHECK_FALSE(holds(c));
      ++found;
    }
  }
  CHECK(found > 0);
}

TEST_CASE("there is no star-shaped region in a volume without room for a start") {
  const Scene s = sceneOf(speckled(
      cubicGrid(5), [](const Vec3&) { return true; }, 50, 50));
  CHECK(starRegions(s.image, s.values, {at(Vec3(2, 2, 2))}, {}, {}, 1).empty());
}
