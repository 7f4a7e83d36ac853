#include "core/evolution/object_boundary.h"

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

constexpr int kLength = 97;  // voxels
constexpr double kRadius = 9, kObject = 40, kBackground = 120;
const Vec3 kCentre((kLength - 1) / 2.0, 16, 16);

Grid grid() {
  Grid g = cubicGrid(33);
  g.size = {kLength, 33, 33};
  return g;
}

//! From `lowest` at the left end to 2 - `lowest` at the right one.
double gain(double x, double lowest) { return lowest + (2 - 2 * lowest) * x / (kLength - 1); }

//! A rod along x from x = 8 to 8 before the end, with an edge of one voxel; times a gain that is linear along
//! it. `sign` +1 is dark on bright, -1 the reverse of every intensity.
Volume rod(double lowest, double sign) {
  return volumeByIndex(grid(), [=](int i, int j, int k) {
    const double aside = std::hypot(j - 16, k - 16) - kRadius, along = std::abs(i - kCentre[0]) - 40;
    const double t = std::clamp(std::max(aside, along) + 0.5, 0.0, 1.0);
    return sign * gain(i, lowest) * (kObject + t * (kBackground - kObject));
  });
}

double halfWay(double x, double lowest) { return gain(x, lowest) * (kObject + kBackground) / 2; }

ObjectBoundary boundaryOf(const SmoothedVolume& volume, double sign) {
  const double voxels = 81 * 3.14159 * kRadius * kRadius;
  const LevelField halfWay(volume.grid(), sign * (kObject + kBackground) / 2);
  return findBoundary({volume, {kCentre}, sign, sign * kObject, halfWay, voxels});
}

void expectHalfWay(const ObjectBoundary& boundary, double lowest, double sign, double part) {
  for (double x : {14.0, 48.0, 82.0}) {
    CAPTURE(x);
    const double step = gain(x, lowest) * (kBackground - kObject);
    for (const Vec3& p : {Vec3(x, 16 + kRadius, 16), Vec3(x, 16, 16 - kRadius)})
      CHECK(sign * boundary.levels.at(p) == Approx(halfWay(x, lowest)).margin(part * step));
  }
}

//! A ball of 8 mm and one of 20 mm, both of value 40, joined by a bar of 3 mm radius and value `bar`, in a
//! background of 120.
constexpr double kSmallRadius = 8;
const Vec3 kSmall(14, 24, 24), kLarge(56, 24, 24);

Volume joinedBalls(double bar) {
  Grid g = cubicGrid(48);
  g.size = {80, 48, 48};
  return volumeByIndex(g, [=](int i, int j, int k) {
    const Vec3 p(i, j, k);
    if ((p - kSmall).norm() < kSmallRadius || (p - kLarge).norm() < 20) return kObject;
    return i > kSmall[0] && i < kLarge[0] && std::hypot(j - 24, k - 24) < 3 ? bar : kBackground;
  });
}

ObjectSearch searchFromSmall(const SmoothedVolume& volume) {
  return {volume, {kSmall}, 1, kObject, LevelField(volume.grid(), 80), 4.18879 * std::pow(kSmallRadius, 3)};
}

}  // namespace

TEST_CASE("without a gain the boundary's levels are half-way everywhere") {
  for (double sign : {1.0, -1.0}) {
    CAPTURE(sign);
    const SmoothedVolume volume(rod(1, sign), 0);
    const ObjectBoundary boundary = boundaryOf(volume, sign);
    CHECK_FALSE(boundary.neck);
    expectHalfWay(boundary, 1, sign, 0.03);
  }
}

TEST_CASE("where a gain changes along a rod its boundary's levels are half-way up its edge at both ends") {
  constexpr double kLowest = 0.6;  // 2.3 to 1 from end to end
  for (double sign : {1.0, -1.0}) {
    CAPTURE(sign);
    const SmoothedVolume volume(rod(kLowest, sign), 0);
    const ObjectBoundary boundary = boundaryOf(volume, sign);
    CHECK_FALSE(boundary.neck);
    expectHalfWay(boundary, kLowest, sign, 0.1);
    CHECK(boundary.levels.highest() - boundary.levels.lowest() > 40);  // one level would not do
  }
}

TEST_CASE("the levels of a small smoothed ball enclose its volume") {
  // At the half-way level it would be sigma²/R = 0.2 mm smaller: 11 %.
  constexpr double kBall = 5;
  const auto ball = [](const Vec3& p) { return (p - Vec3::Constant(16)).norm() - kBall; };
  const SmoothedVolume volume(testing::volumeByDistance(cubicGrid(33), kObject, kBackground, ball), 1);
  const double truth = 4.18879 * std::pow(kBall, 3);
  const ObjectBoundary boundary =
      findBoundary({volume, {Vec3::Constant(16)}, 1, kObject, LevelField(volume.grid(), 80), truth});
  // The radius at which the smoothed image has that level, along an axis and along a diagonal.
  const double level = boundary.levels.at(Vec3::Constant(16));
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(1, 1, 0)}) {
    double radius = 0;
    while (volume.sample(Vec3::Constant(16) + radius * direction.normalized()) < level) radius += 0.01;
    CHECK(radius == Approx(kBall).margin(0.07));
  }
}

TEST_CASE("the boundary's levels are the same bit for bit each time") {
  const SmoothedVolume first(rod(0.6, 1), 0.7), second(rod(0.6, 1), 0.7);
  const ObjectBoundary a = boundaryOf(first, 1), b = boundaryOf(second, 1);
  for (int x = 0; x < kLength; ++x) CHECK(a.levels.at(Vec3(x, 7, 16)) == b.levels.at(Vec3(x, 7, 16)));
}

TEST_CASE("a search whose region leaks through a bar ends at the neck, with the small ball in front of it") {
  const SmoothedVolume volume(joinedBalls(kObject), 0);
  const ObjectBoundary boundary = findBoundary(searchFromSmall(volume));
  REQUIRE(boundary.neck);
  CHECK(boundary.neck->kept.empty());
  CHECK(boundary.neck->neckRadius == Approx(3).margin(0.8));
  CHECK(boundary.neck->barrier->openness(kSmall) == 1);
  CHECK(boundary.neck->barrier->openness(kLarge) == -1);
  CHECK(boundary.levels.at(kSmall + Vec3(0, kSmallRadius, 0)) == Approx(80).margin(4));
}

TEST_CASE("a hole in a wall holds the region, though the first level shows too little of it") {
  // Two chambers apart by a wall of 2 mm, in which a hole is 4 mm wide. Near the object's own level the wall
  // looks thick and the hole narrow.
  Grid g = cubicGrid(48);
  g.size = {80, 48, 48};
  const auto chambers = [](const Vec3& p) {
    const double across = std::max(std::abs(p[1] - 23.5), std::abs(p[2] - 23.5));
    const double both = std::max({across - 18, 8 - p[0], p[0] - 71, 1 - std::abs(p[0] - 39.5)});
    return std::min(both, std::max(across - 2, std::abs(p[0] - 39.5) - 3));
  };
  const SmoothedVolume volume(testing::volumeByDistance(g, kObject, kBackground, chambers), 0.5);
  for (const double level : {kObject + 2, 80.0}) {
    CAPTURE(level);
    const ObjectBoundary boundary =
        findBoundary({volume, {Vec3(20, 23, 23)}, 1, kObject, LevelField(volume.grid(), level), 60'000});
    REQUIRE(boundary.neck);
    CHECK(boundary.neck->hole);
    CHECK(boundary.neck->barrier->openness(Vec3(20, 23, 23)) == 1);
    CHECK(boundary.neck->barrier->openness(Vec3(56, 23, 23)) == -1);
    CHECK(boundary.levels.at(Vec3(20, 23, 23)) == Approx(80).margin(4));
  }
}

TEST_CASE("where the bar is background, there is no neck") {
  const SmoothedVolume volume(joinedBalls(kBackground), 0);
  CHECK_FALSE(findBoundary(searchFromSmall(volume)).neck);
  CHECK_FALSE(findBoundaryAtNeck(searchFromSmall(volume)));
}

TEST_CASE("a region that leaked is cut at its neck with one level for all places") {
  const SmoothedVolume volume(joinedBalls(kObject), 0);
  const auto boundary = findBoundaryAtNeck(searchFromSmall(volume));
  REQUIRE(boundary);
  REQUIRE(boundary->neck);
  CHECK(boundary->neck->barrier->openness(kLarge) == -1);
  CHECK(boundary->levels.lowest() == boundary->levels.highest());
}
