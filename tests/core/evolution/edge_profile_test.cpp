#include "core/evolution/edge_profile.h"

#include <cmath>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByDistance;

namespace {

constexpr double kObject = 40, kBackground = 140, kHalfWay = 90, kContrast = kBackground - kObject;
const Vec3 kMiddle(20, 20, 20);

using Read = std::optional<ImageEdge> (EdgeReader::*)(const ObjectRegion::Voxel&,
                                                      const ObjectRegion::Face&) const;

//! Weighted mean of the signed levels over the whole boundary of the region around `seed` (voxels).
double meanLevel(const SmoothedVolume& volume, double sign, Read read, const Vec3& seed = kMiddle) {
  const LevelField level(volume.grid(), sign * kHalfWay);
  const ObjectRegion region = floodObject(volume, {seed}, sign, level, 1'000'000);
  const EdgeReader reader(volume, sign);
  double sum = 0, weight = 0;
  for (const ObjectRegion::Face& face : region.faces)
    if (const auto edge = (reader.*read)(region.voxels[face.voxel], face)) {
      sum += edge->weight * edge->level;
      weight += edge->weight;
    }
  REQUIRE(weight > 0);
  return sum / weight;
}

double ball(const Vec3& p, double radius) { return (p - kMiddle).norm() - radius; }
double tube(const Vec3& p, double radius) { return std::hypot(p[1] - 20, p[2] - 20) - radius; }

//! What the boundary of a ball becomes when it is smoothed, in contrasts above the half-way level. Exact for
//! a sharp ball of radius R (its profile is a difference of error functions): sigma/(R sqrt(2 pi)) where R is
//! several sigma; half of that for a tube. The ramp of a voxel counts as a Gaussian of the same variance.
double riseOfBall(double radius, double sigma) {
  const double all = std::sqrt(sigma * sigma + 1.0 / 12);
  return all / (radius * std::sqrt(2 * std::numbers::pi));
}

}  // namespace

TEST_CASE("the level of a smoothed ball's boundary is what the smoothing has made of it") {
  for (const double radius : {5.0, 7.0, 10.0})
    for (const double sigma : {0.5, 1.0}) {
      CAPTURE(radius, sigma);
      const SmoothedVolume volume(volumeByDistance(cubicGrid(41), kObject, kBackground,
                                                   [=](const Vec3& p) { return ball(p, radius); }),
                                  sigma);
      const double rise = kContrast * riseOfBall(radius, sigma);
      CHECK(meanLevel(volume, 1, &EdgeReader::ofShape) == Approx(kHalfWay + rise).margin(0.02 * kContrast));
      const double second = kContrast * sigma * sigma / (radius * radius);  // order that is left out
      CHECK(meanLevel(volume, 1, &EdgeReader::halfWayAlong) ==
            Approx(kHalfWay).margin(0.01 * kContrast + second));
    }
}

TEST_CASE("the level of a smoothed tube's boundary is half as far from the half-way level as a ball's") {
  for (const double radius : {3.0, 4.0, 6.0}) {
    CAPTURE(radius);
    const SmoothedVolume volume(
        volumeByDistance(cubicGrid(41), kObject, kBackground, [=](const Vec3& p) { return tube(p, radius); }),
        0.7);
    const double rise = kContrast * riseOfBall(radius, 0.7) / 2;
    CHECK(meanLevel(volume, 1, &EdgeReader::ofShape) == Approx(kHalfWay + rise).margin(0.02 * kContrast));
  }
}

TEST_CASE("around a smoothed bright ball in the object the level is as far below the half-way level") {
  const SmoothedVolume volume(
      volumeByDistance(cubicGrid(41), kObject, kBackground, [](const Vec3& p) { return -ball(p, 6); }), 1);
  const double level = meanLevel(volume, 1, &EdgeReader::ofShape, Vec3(2, 2, 2));
  CHECK(level == Approx(kHalfWay - kContrast * riseOfBall(6, 1)).margin(0.02 * kContrast));
}

TEST_CASE("a bright object has the levels of a dark one with all intensities reversed") {
  const auto shape = [](const Vec3& p) { return ball(p, 6); };
  const SmoothedVolume dark(volumeByDistance(cubicGrid(41), kObject, kBackground, shape), 1);
  const SmoothedVolume bright(volumeByDistance(cubicGrid(41), -kObject, -kBackground, shape), 1);
  CHECK(meanLevel(bright, -1, &EdgeReader::ofShape) == meanLevel(dark, 1, &EdgeReader::ofShape));
}

TEST_CASE(
    "on planes at any slant the boundary's level is the half-way one, on the mean over where they lie") {
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 0.4, 0.7), Vec3(1, 1, 1)}) {
    CAPTURE(direction.transpose());
    constexpr int kOffsets = 10;
    double mean = 0;
    for (int i = 0; i < kOffsets; ++i) {
      // Over one voxel along x, so that the planes meet the grid in all ways.
      const auto plane = [&](const Vec3& p) {
        return (p - kMiddle).dot(direction.normalized()) -
               (3 + (i + 0.5) / kOffsets) * direction.normalized()[0];
      };
      const SmoothedVolume volume(volumeByDistance(cubicGrid(41), kObject, kBackground, plane), 0.7);
      mean += meanLevel(volume, 1, &EdgeReader::ofShape) / kOffsets;
    }
    CHECK(mean == Approx(kHalfWay).margin(0.01 * kContrast));
  }
}

TEST_CASE("voxels that are not cubes do not change the level of a ball's boundary") {
  Grid grid = cubicGrid(41);
  grid.size = {41, 41, 27};
  grid.spacing = Vec3(1, 1, 1.5);
  const SmoothedVolume volume(
      volumeByDistance(grid, kObject, kBackground, [](const Vec3& p) { return ball(p, 8); }), 1);
  const double level = meanLevel(volume, 1, &EdgeReader::ofShape, Vec3(20, 20, 20 / 1.5));
  CHECK(level == Approx(kHalfWay + kContrast * riseOfBall(8, 1)).margin(0.02 * kContrast));
}

TEST_CASE("where nothing rises there is no edge") {
  const SmoothedVolume flat(volumeByDistance(cubicGrid(9), 50, 50, [](const Vec3&) { return 1.0; }), 0);
  const EdgeReader reader(flat, 1);
  const ObjectRegion::Face face{0, 0, 1};
  CHECK_FALSE(reader.halfWay({4, 4, 4}, face));
  CHECK_FALSE(reader.halfWayAlong({4, 4, 4}, face));
  CHECK_FALSE(reader.ofShape({4, 4, 4}, face));
}
