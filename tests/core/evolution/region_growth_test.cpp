#include "core/evolution/region_growth.h"

#include <cmath>

#include "core/evolution/growth_level.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

//! Distance from the middle in mm.
double fromMiddle(int i, int j, int k) { return (Vec3(i, j, k) - Vec3(12, 12, 12)).norm(); }

const SmoothedVolume& ramp() {
  static const SmoothedVolume volume(volumeByIndex(cubicGrid(25), fromMiddle), 0);
  return volume;
}

std::size_t countBelow(double limit) {
  std::size_t n = 0;
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i) n += fromMiddle(i, j, k) < limit;
  return n;
}

}  // namespace

TEST_CASE("the region at a level holds the voxels below it") {
  const RegionGrowth g = growRegion(ramp(), {Vec3(12, 12, 12)}, 1, 0, 10);
  REQUIRE(g.voxels.size() == g.edge.size());
  for (std::size_t bin = 0; bin < g.voxels.size(); bin += 7) {
    const double end = g.lowest + g.step * static_cast<double>(bin + 1);
    // A voxel at the end of a bin itself may fall to either side.
    CHECK(g.voxels[bin] >= static_cast<double>(countBelow(end - 1e-5)));
    CHECK(g.voxels[bin] <= static_cast<double>(countBelow(end + 1e-5)));
  }
}

TEST_CASE("a region never shrinks as the level rises") {
  const RegionGrowth g = growRegion(ramp(), {Vec3(3, 12, 12)}, 1, 0, 12);
  for (std::size_t b = 1; b < g.voxels.size(); ++b) REQUIRE(g.voxels[b] >= g.voxels[b - 1]);
}

TEST_CASE("the edge of a region in a linear ramp is the ramp's slope") {
  const RegionGrowth g = growRegion(ramp(), {Vec3(12, 12, 12)}, 1, 0, 10);
  for (std::size_t bin = 80; bin < 190; bin += 10) CHECK(g.edge[bin] == Approx(1).epsilon(0.03));
}

TEST_CASE("a bright object grows as a dark one in the negative image") {
  const SmoothedVolume negative(
      volumeByIndex(cubicGrid(25), [](int i, int j, int k) { return -fromMiddle(i, j, k); }), 0);
  const RegionGrowth dark = growRegion(ramp(), {Vec3(12, 12, 12)}, 1, 0, 10);
  const RegionGrowth bright = growRegion(negative, {Vec3(12, 12, 12)}, -1, 0, 10);
  CHECK(dark.voxels == bright.voxels);
  CHECK(dark.edge == bright.edge);
}

TEST_CASE("two seeds in one region count its voxels once") {
  const RegionGrowth one = growRegion(ramp(), {Vec3(12, 12, 12)}, 1, 0, 10);
  const RegionGrowth two =
      growRegion(ramp(), {Vec3(12, 12, 12), Vec3(12, 12, 12), Vec3(13, 12, 12)}, 1, 0, 10);
  CHECK(one.voxels.back() == two.voxels.back());
}

TEST_CASE("a region does not reach what is separated by a wall above the level") {
  const SmoothedVolume volume(volumeByIndex(cubicGrid(20), [](int i, int, int) { return i == 10 ? 100 : 0; }),
                              0);
  const RegionGrowth g = growRegion(volume, {Vec3(3, 10, 10)}, 1, 0, 99);
  CHECK(g.voxels.back() == 10 * 20 * 20);
}

TEST_CASE("padding is no part of a region and no edge of it") {
  // The object touches the padding, a step of 1000; its true edge is a step of 100.
  const auto image = [](int i, int j, int k) {
    return i < 4 ? -900.0 : (k < 12 ? 0.5 : 100.0) + 0.0001 * (i + 24 * j + 576 * k);
  };
  const Volume volume = volumeByIndex(cubicGrid(24), image);
  const auto view = FieldOfView::find(volume);
  REQUIRE(view);
  REQUIRE(view->isPadding(0));
  const SmoothedVolume smoothed(volume, 0, view, 200);
  const RegionGrowth g = growRegion(smoothed, {Vec3(10, 12, 4)}, 1, 0, 90);
  CHECK(g.voxels.back() == 20 * 24 * 12);
  for (double edge : g.edge) CHECK(edge <= 101);
}

namespace {

//! A region that grows by a tenth from level to level; its edge is strongest in the bin `peak` of ten.
RegionGrowth growthWithPeak(std::size_t peak) {
  RegionGrowth g;
  for (std::size_t b = 0; b < 10; ++b) {
    g.voxels.push_back(1000 * std::pow(1.1, static_cast<double>(b)));
    g.border.push_back(0);
    g.edge.push_back(b == peak ? 5 : 1);
  }
  return g;
}

}  // namespace

TEST_CASE("a growth that was given up while its edge still rose has no level") {
  RegionGrowth rising = growthWithPeak(9), past = growthWithPeak(4);
  CHECK(strongestLevel(rising).has_value());
  rising.whole = past.whole = false;
  CHECK_FALSE(strongestLevel(rising).has_value());
  REQUIRE(strongestLevel(past).has_value());
  CHECK(strongestLevel(past)->level == Approx(past.level(4)));
}
