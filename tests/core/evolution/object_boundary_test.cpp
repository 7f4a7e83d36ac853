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
  return findBoundary({volume, {kCentre}, sign, sign * kObject, sign * (kObject + kBackground) / 2, voxels});
}

void expectHalfWay(const ObjectBoundary& boundary, double lowest, double sign, double part) {
  for (double x : {14.0, 48.0, 82.0}) {
    CAPTURE(x);
    const double step = gain(x, lowest) * (kBackground - kObject);
    for (const Vec3& p : {Vec3(x, 16 + kRadius, 16), Vec3(x, 16, 16 - kRadius)})
      CHECK(sign * boundary.levels.at(p) == Approx(halfWay(x, lowest)).margin(part * step));
  }
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

TEST_CASE("the boundary's levels are the same bit for bit each time") {
  const SmoothedVolume first(rod(0.6, 1), 0.7), second(rod(0.6, 1), 0.7);
  const ObjectBoundary a = boundaryOf(first, 1), b = boundaryOf(second, 1);
  for (int x = 0; x < kLength; ++x) CHECK(a.levels.at(Vec3(x, 7, 16)) == b.levels.at(Vec3(x, 7, 16)));
}
