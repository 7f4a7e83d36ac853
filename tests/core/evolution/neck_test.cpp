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

//! Two chambers apart by a wall of 2 mm from x = 39 to 41, with a square hole; the right one ends at x = 40 +
//! `length`.
const Vec3 kLeft(20, 24, 24), kRight(56, 24, 24);

double chambers(const Vec3& p, double holeWidth, double length = 32) {
  const double across = std::max(std::abs(p[1] - 24), std::abs(p[2] - 24));
  const double left = std::max({across - 18, 8 - p[0], p[0] - 39});
  const double right = std::max({across - 18, 41 - p[0], p[0] - 40 - length});
  const double hole = std::max(across - holeWidth / 2, std::abs(p[0] - 40) - 3);
  return std::min({left, right, hole});
}

//! Two equal balls, as far apart as `middles` says, joined by a bar along x.
double equalBalls(const Vec3& p, double middles, double barRadius) {
  const Vec3 a(40 - middles / 2, 24, 24), b(40 + middles / 2, 24, 24);
  const double aside = std::hypot(p[1] - 24, p[2] - 24) - barRadius;
  return std::min({ball(p, a, 16), ball(p, b, 16), std::max(aside, std::abs(p[0] - 40) - middles / 2)});
}

std::optional<NeckCut> holeIn(const ObjectRegion& region, const std::vector<Vec3>& seeds) {
  return findNeck(grid(), region, seeds, Passages::holes);
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

TEST_CASE("a region that leaks through a hole in a wall is cut at the wall, whichever side the seed is on") {
  for (const double width : {1.0, 2.0, 3.0, 4.0, 6.0})
    for (const Vec3& seed : {kLeft, kRight}) {
      CAPTURE(width, seed.transpose());
      const ObjectRegion region = regionOf([=](const Vec3& p) { return chambers(p, width); }, seed);
      const auto cut = holeIn(region, {seed});
      REQUIRE(cut);
      CHECK(cut->hole);
      CHECK(cut->neckRadius == Approx(width / 2).margin(0.6));
      for (std::size_t i = 0; i < region.voxels.size(); ++i) {
        const double beyondWall = (region.voxels[i][0] - 40) * (seed[0] < 40 ? 1 : -1);
        if (beyondWall < -1) REQUIRE(cut->kept[i] == 1);
        if (beyondWall > 1 + width / 2) REQUIRE(cut->kept[i] == 0);
      }
    }
}

TEST_CASE("two holes in a wall are closed at once") {
  const auto twoHoles = [](const Vec3& p) {
    return std::min(chambers(p + Vec3(0, 7, 0), 3), std::max(chambers(p, 3), std::abs(p[1] - 24) - 18));
  };
  const ObjectRegion region = regionOf(twoHoles, kLeft);
  const auto cut = holeIn(region, {kLeft});
  REQUIRE(cut);
  for (std::size_t i = 0; i < region.voxels.size(); ++i)
    if (region.voxels[i][0] > 43) REQUIRE(cut->kept[i] == 0);
}

TEST_CASE("a seed on either side of a hole keeps the whole region") {
  const auto region = regionOf([](const Vec3& p) { return chambers(p, 3); }, kLeft);
  CHECK_FALSE(holeIn(region, {kLeft, kRight}));
}

TEST_CASE("a small pocket behind a hole is no leak") {
  const auto region = regionOf([](const Vec3& p) { return chambers(p, 2, 6); }, kLeft);
  CHECK_FALSE(holeIn(region, {kLeft}));
}

TEST_CASE("an opening that takes up most of the wall is no hole") {
  const auto region = regionOf([](const Vec3& p) { return chambers(p, 16); }, kLeft);
  CHECK_FALSE(holeIn(region, {kLeft}));
}

TEST_CASE("a bar between two balls is no hole") {
  for (const double bar : {1.5, 2.5, 4.0}) {
    CAPTURE(bar);
    const auto region = regionOf([=](const Vec3& p) { return equalBalls(p, 46, bar); }, Vec3(17, 24, 24));
    CHECK_FALSE(holeIn(region, {Vec3(17, 24, 24)}));
  }
}

TEST_CASE("a tube that is narrower in one place has no hole there") {
  const auto narrowed = [](const Vec3& p) {
    const double radius = 8 - 6 * std::exp(-0.5 * std::pow((p[0] - 40) / 6, 2));
    return std::max(std::hypot(p[1] - 24, p[2] - 24) - radius, std::abs(p[0] - 40) - 36);
  };
  const ObjectRegion region = regionOf(narrowed, kLeft);
  REQUIRE(region.voxels.size() > 10'000);  // it passes the narrow place
  CHECK_FALSE(holeIn(region, {kLeft}));
}

TEST_CASE("an empty region has no neck") { CHECK_FALSE(findNeck(grid(), ObjectRegion{}, {kSmall})); }
