#include "core/object/candidates.h"

#include <algorithm>
#include <limits>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

//! A dark ball of radius 6 with a neck of radius 1 to another of radius 9, in noise.
Volume dumbbell(double noise = 3) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, std::max(noise, std::numeric_limits<double>::min()));
  return volumeByIndex(cubicGrid(48), [&](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const bool first = (p - Vec3(12, 24, 24)).norm() < 6, second = (p - Vec3(33, 24, 24)).norm() < 9;
    const bool neck = i > 12 && i < 33 && std::hypot(j - 24.0, k - 24.0) < 1.8;
    return (first || second || neck ? 40 : 120) + normal(random);
  });
}

ClickSearch search(const Volume& volume, const Vec3& click, int threads = 1) {
  return searchAround(volume, cellsAround(volume.grid, click, 100, 1'000'000), click, nullptr, {}, threads);
}

}  // namespace

TEST_CASE("the level of a region's every cell is no lower than that of its own intensity") {
  const ClickSearch s = search(dumbbell(), Vec3(12, 24, 24));
  REQUIRE(!s.maps.empty());
  const RungImage rungs = rungsOf(s.image, s.values, s.click, s.intensities);
  for (const ArrivalMap& map : s.maps)
    for (std::size_t i = 0; i < map.level.size(); ++i)
      if (map.level[i] < kNever) {
        CHECK(map.level[i] >= rungs.below[i]);
        CHECK(rungs.above[i] <= map.band);
      }
}

TEST_CASE("without an opening a wider band holds at least as much at every rung") {
  const ClickSearch s = search(dumbbell(), Vec3(12, 24, 24));
  for (const ArrivalMap& a : s.maps)
    for (const ArrivalMap& b : s.maps) {
      if (a.band > b.band || a.passes != b.passes || a.passes != 0) continue;
      const int end = std::min(a.end, b.end);
      for (std::size_t i = 0; i < a.level.size(); ++i)
        if (a.level[i] < end) CHECK(b.level[i] <= a.level[i]);
    }
}

TEST_CASE("an opening wider than the neck cuts the other ball off, no opening does not") {
  const ClickSearch s = search(dumbbell(), Vec3(12, 24, 24));
  const std::size_t other = s.image.cells.at(33, 24, 24), own = s.image.cells.at(12, 24, 24);
  bool cut = false, whole = false;
  for (const ArrivalMap& map : s.maps) {
    if (map.band != 17) continue;  // its bound lies half-way between the balls and the background
    if (map.passes == 3) cut = map.level[other] == kNever && map.level[own] < kNever;
    if (map.passes == 0) whole = map.level[other] < kNever;
  }
  CHECK(cut);
  CHECK(whole);
}

TEST_CASE("both balls together and one alone are among the candidates, the first ones") {
  std::vector<std::unique_ptr<ClickSearch>> searches;
  searches.push_back(std::make_unique<ClickSearch>(search(dumbbell(), Vec3(12, 24, 24))));
  std::vector<RankedRegion> ranked = rankRegions(searches, {});
  const std::vector<RankedRegion> best = distinctRegions(ranked, 5, {});
  REQUIRE(best.size() >= 2);
  const auto isAbout = [&](double volume) {
    return std::any_of(best.begin(), best.end(),
                       [&](const RankedRegion& r) { return std::abs(r.volume / volume - 1) < 0.2; });
  };
  CHECK(isAbout(4.19 * 216));
  CHECK(isAbout(4.19 * (216 + 729)));
  for (std::size_t i = 1; i < best.size(); ++i) CHECK(best[i].score <= best[i - 1].score);
}

TEST_CASE("the same candidates with any number of threads") {
  const ClickSearch one = search(dumbbell(), Vec3(12, 24, 24), 1),
                    four = search(dumbbell(), Vec3(12, 24, 24), 4);
  REQUIRE(one.maps.size() == four.maps.size());
  for (std::size_t m = 0; m < one.maps.size(); ++m) CHECK(one.maps[m].level == four.maps[m].level);
}

TEST_CASE("an object brighter than nearly all around it still has rungs down to its surroundings") {
  const Volume spot = volumeByIndex(cubicGrid(64), [](int i, int j, int k) {
    return (Vec3(i, j, k) - Vec3(32, 32, 32)).norm() < 4 ? 1000 : 10 + (i + j + k) % 3;
  });
  const ClickSearch s = search(spot, Vec3(32, 32, 32));
  CHECK(s.intensities.ladder.back() > 0.6 * 990);
}
