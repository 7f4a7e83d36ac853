#include "core/evolution/region_growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/evolution/region_growth_level.h"
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

TEST_CASE("what rounding puts beyond the last level is no part of the region") {
  // 0.7f is less than 0.7, but not less than the last level's end in single precision.
  const auto image = [](int i, int j, int k) { return i == 4 && j == 4 && k == 4 ? 0.699 : 0.7; };
  const SmoothedVolume volume(volumeByIndex(cubicGrid(9), image), 0);
  CHECK(growRegion(volume, {Vec3(4, 4, 4)}, 1, 0, 0.7).voxels.back() == 1);
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

// Levels and values that are no multiples of them: nothing depends on rounding.
constexpr int kNoisySide = 90, kLevels = 200;
constexpr double kLevelStep = 1.0 / 64, kHighest = kLevels * kLevelStep;

//! White noise between 0 and 1. Where a good 0.31 of the voxels are let in, by face neighbours those of most
//! of the volume join at once (site percolation).
const Volume& noisyVolume() {
  static const Volume volume = [] {
    std::mt19937 random(1);
    return volumeByIndex(cubicGrid(kNoisySide),
                         [&](int, int, int) { return (static_cast<double>(random() >> 22) + 0.5) / 1024; });
  }();
  return volume;
}

//! The same growth without bricks and rows.
struct PlainGrowth {
  std::vector<double> voxels, border;

  PlainGrowth(const SmoothedVolume& volume, int start) : volume_(volume), queue_(kLevels) {
    seen_.resize(volume.grid().voxelCount());
    push(start, 0);
    double taken = 0, onBorder = 0;
    for (int level = 0; level < kLevels; ++level) {
      double sum = 0, squares = 0;
      for (std::size_t q = 0; q < queue_[at(level)].size(); ++q, ++taken) {
        const int voxel = queue_[at(level)][q];
        bool isOnBorder = false;
        double squared = 0;
        for (int axis = 0; axis < 3; ++axis) {
          const int i = along(voxel, axis), stride = kStride[at(axis)];
          const int low = i > 0 ? voxel - stride : voxel, high = i + 1 < kNoisySide ? voxel + stride : voxel;
          push(low, level);
          push(high, level);
          isOnBorder = isOnBorder || low == voxel || high == voxel;
          const double slope = (value(high) - value(low)) / ((high - low) / stride);
          squared += slope * slope;
        }
        onBorder += isOnBorder;
        if (value(voxel) < level * kLevelStep) continue;
        sum += std::sqrt(squared);
        squares += squared;
      }
      voxels.push_back(taken);
      border.push_back(onBorder);
      sums_.push_back(sum);
      squares_.push_back(squares);
    }
  }

  double edgeAt(std::size_t bin, std::size_t bins) const {
    double sum = 0, squares = 0;
    for (std::size_t b = bin < 4 ? 0 : bin - 4; b < std::min(bins, bin + 5); ++b) {
      sum += sums_[b];
      squares += squares_[b];
    }
    return sum > 0 ? squares / sum : 0;
  }

 private:
  static constexpr std::array<int, 3> kStride{1, kNoisySide, kNoisySide* kNoisySide};
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static int along(int voxel, int axis) { return voxel / kStride[at(axis)] % kNoisySide; }
  double value(int v) const { return static_cast<double>(volume_.at(along(v, 0), along(v, 1), along(v, 2))); }
  void push(int voxel, int level) {
    if (seen_[at(voxel)]) return;
    seen_[at(voxel)] = true;
    queue_[at(std::max(level, static_cast<int>(value(voxel) / kLevelStep)))].push_back(voxel);
  }

  const SmoothedVolume& volume_;
  std::vector<std::vector<int>> queue_;
  std::vector<bool> seen_;
  std::vector<double> sums_, squares_;
};

}  // namespace

TEST_CASE("a level that joins most of a volume is taken in as any other") {
  const SmoothedVolume volume(noisyVolume(), 0);
  constexpr int kMiddle = kNoisySide / 2;
  int x = kMiddle;
  while (volume.at(x, kMiddle, kMiddle) > 0.1f) ++x;  // so low that the first level lets in little
  const RegionGrowth g = growRegion(volume, {Vec3(x, kMiddle, kMiddle)}, 1, 0, kHighest);
  const PlainGrowth plain(volume, (kMiddle * kNoisySide + kMiddle) * kNoisySide + x);
  const double faces = 6.0 * kNoisySide * kNoisySide - 12.0 * kNoisySide + 8;
  double most = 0;
  for (std::size_t b = 0; b < g.voxels.size(); ++b) {
    INFO("level " << b);
    CHECK(g.voxels[b] == plain.voxels[b]);
    CHECK(g.border[b] == Approx(plain.border[b] / faces).epsilon(1e-12));
    CHECK(g.edge[b] == Approx(plain.edgeAt(b, g.voxels.size())).epsilon(1e-12));
    if (b > 0 && g.voxels[b - 1] > 0) most = std::max(most, g.voxels[b] - g.voxels[b - 1]);
  }
  CHECK(most > 100'000);  // else nothing was joined
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

TEST_CASE("what others have had smoothed in a small volume changes no growth in it") {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 3);
  const Volume volume =
      volumeByIndex(cubicGrid(70), [&](int i, int j, int k) { return fromMiddle(i, j, k) + noise(random); });
  const SmoothedVolume fresh(volume, 0.7), used(volume, 0.7);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) used.brick(i, j, k);
  REQUIRE(growsByItself(fresh));
  for (const double sign : {1.0, -1.0}) {
    const double from = sign > 0 ? 0 : -60, to = sign > 0 ? 60 : 0;
    const RegionGrowth a = growRegion(fresh, {Vec3(12, 12, 12)}, sign, from, to);
    const RegionGrowth b = growRegion(used, {Vec3(12, 12, 12)}, sign, from, to);
    CHECK(a.voxels == b.voxels);
    CHECK(a.edge == b.edge);
    CHECK(a.whole == b.whole);
  }
  Grid large;  // of more bricks than a growth may smooth that leaks
  large.size = {SmoothedVolume::kBrick * 301, 1, 1};
  CHECK(!growsByItself(SmoothedVolume(volumeByIndex(large, [](int, int, int) { return 0.0; }), 0)));
}
