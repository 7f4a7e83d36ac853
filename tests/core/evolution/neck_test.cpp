#include "core/evolution/neck.h"

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByDistance;

namespace {

const Vec3 kSmall(14, 24, 24), kLarge(56, 24, 24);
constexpr double kSmallRadius = 8, kLargeRadius = 20, kBarRadius = 3;

Grid grid() {
  Grid g = cubicGrid(48);
  g.size = {80, 48, 48};
  return g;
}

double ball(const Vec3& p, const Vec3& centre, double radius) { return (p - centre).norm() - radius; }

//! A small ball and a large one, joined by a bar along x.
double joinedBalls(const Vec3& p, double barRadius) {
  const double aside = std::hypot(p[1] - kSmall[1], p[2] - kSmall[2]) - barRadius;
  const double bar = std::max({aside, kSmall[0] - p[0], p[0] - kLarge[0]});
  return std::min({ball(p, kSmall, kSmallRadius), ball(p, kLarge, kLargeRadius), bar});
}

double ballVolume(double radius) { return 4.18879 * radius * radius * radius; }

template <typename F>
ObjectRegion regionOf(F&& distance, const Vec3& seed) {
  const SmoothedVolume volume(volumeByDistance(grid(), 0, 100, distance), 0);
  return floodObject(volume, {seed}, 1, LevelField(grid(), 50), 1'000'000);
}

ObjectRegion joined(double barRadius, const Vec3& seed) {
  return regionOf([=](const Vec3& p) { return joinedBalls(p, barRadius); }, seed);
}

}  // namespace

TEST_CASE("a small ball that leaks through a bar into a larger one is cut at the bar") {
  const ObjectRegion region = joined(kBarRadius, kSmall);
  const auto cut = findNeck(grid(), region, {kSmall});
  REQUIRE(cut);
  CHECK(cut->neckRadius == Approx(kBarRadius).margin(0.8));
  CHECK(cut->structureRadius == Approx(kSmallRadius).margin(1));
  CHECK(cut->widestBehind == Approx(kLargeRadius).epsilon(0.1));
  CHECK(cut->keptVolume > 0.95 * ballVolume(kSmallRadius));
  CHECK(cut->keptVolume < 1.3 * ballVolume(kSmallRadius));  // with some of the bar
  CHECK(cut->keptVolume + cut->cutVolume == Approx(static_cast<double>(region.voxels.size())));
}

TEST_CASE("the voxels kept at a neck are the seeded ball's, and the barrier closes what was cut off") {
  const ObjectRegion region = joined(kBarRadius, kSmall);
  const auto cut = findNeck(grid(), region, {kSmall});
  REQUIRE(cut);
  REQUIRE(cut->kept.size() == region.voxels.size());
  for (std::size_t i = 0; i < region.voxels.size(); ++i) {
    const Vec3 p(region.voxels[i][0], region.voxels[i][1], region.voxels[i][2]);
    if (ball(p, kSmall, kSmallRadius) < 0) REQUIRE(cut->kept[i] == 1);
    if (ball(p, kLarge, kLargeRadius) < 0) REQUIRE(cut->kept[i] == 0);
  }
  CHECK(cut->barrier->openness(kSmall) == 1);
  CHECK(cut->barrier->openness(kLarge) == -1);
}

TEST_CASE("a seed behind the neck as well keeps the whole region") {
  CHECK_FALSE(findNeck(grid(), joined(kBarRadius, kSmall), {kSmall, kLarge}));
}

TEST_CASE("the small ball behind a bar is no leak of the large one") {
  CHECK_FALSE(findNeck(grid(), joined(kBarRadius, kLarge), {kLarge}));
}

TEST_CASE("a bar nearly as wide as the seeded ball is no neck") {
  CHECK_FALSE(findNeck(grid(), joined(7, kSmall), {kSmall}));
}

TEST_CASE("a single ball has no neck, wherever the seed lies in it") {
  const auto one = [](const Vec3& p) { return ball(p, kLarge, kLargeRadius); };
  for (const Vec3& seed : {kLarge, Vec3(kLarge + Vec3(-12, 3, 0))}) {
    CAPTURE(seed.transpose());
    CHECK_FALSE(findNeck(grid(), regionOf(one, seed), {seed}));
  }
}

TEST_CASE(
    "a tube that opens with hardly a neck into something of quite another size is cut where it widens") {
  // Blind at x = 8, a little narrower where it is open at x = 40 into half of the volume.
  Grid wide = cubicGrid(80);
  wide.size = {120, 80, 80};
  const double radius = 5, blind = 8, open = 40;
  const auto distance = [&](const Vec3& p) {
    const double here = p[0] < 30 ? radius : radius - 1;
    const double tube = std::max({std::hypot(p[1] - 40, p[2] - 40) - here, blind - p[0], p[0] - open - 1});
    return std::min(tube, open - p[0]);
  };
  const SmoothedVolume volume(volumeByDistance(wide, 0, 100, distance), 0);
  const Vec3 seed(20, 41, 40);
  const ObjectRegion region = floodObject(volume, {seed}, 1, LevelField(wide, 50), 1'000'000);
  const auto cut = findNeck(wide, region, {seed});
  REQUIRE(cut);
  CHECK(cut->widens);
  CHECK(cut->neckRadius == Approx(1.3 * radius).epsilon(0.15));
  const auto tubeUpTo = [&](double x) {
    return 3.14159 * (radius * radius * (30 - blind) + (radius - 1) * (radius - 1) * (x - 30));
  };
  CHECK(cut->keptVolume < tubeUpTo(open));
  for (std::size_t i = 0; i < region.voxels.size(); ++i) {
    const int x = region.voxels[i][0];
    if (x < open - 5) REQUIRE(cut->kept[i] == 1);  // its blind end and the rim beside its wall too
    if (x > open + 6) REQUIRE(cut->kept[i] == 0);
  }
}

TEST_CASE("at a neck the cut is not called a widening") {
  const auto cut = findNeck(grid(), joined(kBarRadius, kSmall), {kSmall});
  REQUIRE(cut);
  CHECK_FALSE(cut->widens);
}

TEST_CASE("an empty region has no neck") { CHECK_FALSE(findNeck(grid(), ObjectRegion{}, {kSmall})); }
