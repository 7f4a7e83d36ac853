#include "core/evolution/word_flood.h"

#include <algorithm>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;

namespace {

using Voxel = ObjectRegion::Voxel;

//! Noise in which about half of the voxels lie below 0, in lumps, with padding where x + y is large.
Volume lumps(const std::array<int, 3>& size, unsigned seed, bool padded) {
  Grid grid = cubicGrid(8);
  grid.size = size;
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(-20, 100);
  return testing::volumeByIndex(grid, [&](int x, int y, int) {
    return padded && x + y > (size[0] + size[1]) / 2 ? -5000.f : noise(random);
  });
}

//! Levels that differ from place to place.
LevelField slope(const Grid& grid) {
  LevelField::Samples samples(grid);
  samples.add(Vec3(0, 0, 0), -30, 1);
  samples.add(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1), 40, 1);
  return samples.spread();
}

//! As inner voxel, axis and step, in order.
std::vector<std::array<int, 5>> facesOf(const ObjectRegion& region) {
  std::vector<std::array<int, 5>> out;
  for (const ObjectRegion::Face& f : region.faces) {
    const Voxel& v = region.voxels[f.voxel];
    out.push_back({v[0], v[1], v[2], f.axis, f.step});
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Voxel> sorted(std::vector<Voxel> voxels) {
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

std::vector<Voxel> voxelsOf(const WordFlood& flood) {
  std::vector<Voxel> out;
  flood.forEachRun([&](int first, int last, int y, int z) {
    for (int x = first; x <= last; ++x) out.push_back({x, y, z});
  });
  return sorted(std::move(out));
}

}  // namespace

TEST_CASE("by words a flood takes the same voxels and faces as voxel by voxel") {
  std::size_t largest = 0;
  unsigned seed = 0;
  for (const std::array<int, 3>& size :
       {std::array{40, 30, 20}, std::array{64, 9, 70}, std::array{33, 40, 5}, std::array{7, 50, 40}})
    for (const bool padded : {false, true})
      for (const double sign : {1., -1.}) {
        const Volume volume = lumps(size, ++seed, padded);
        const SmoothedVolume image(volume, 0.8, padded ? FieldOfView::find(volume) : nullptr, -5000);
        const LevelField levels = slope(volume.grid);
        const std::vector<Vec3> seeds{Vec3(3, 4, 3), Vec3(5, 20, 4)};
        const ObjectRegion expected = floodObject(image, seeds, sign, levels, 1'000'000);
        WordFlood flood(image, seeds, sign, levels);
        const bool whole = flood.run(1'000'000);
        CAPTURE(size[0], padded, sign);
        CHECK(image.hasPadding() == padded);
        CHECK((whole && expected.whole));
        CHECK(flood.count() == expected.voxels.size());
        CHECK(voxelsOf(flood) == sorted(expected.voxels));
        CHECK(facesOf(flood.rim()) == facesOf(expected));
        largest = std::max(largest, flood.count());
      }
  CHECK(largest > 5'000);
}

TEST_CASE("by words a flood ends soon after as many voxels as are wanted") {
  const Volume volume = testing::volumeByDistance(
      cubicGrid(60), 0, 100, [](const Vec3& p) { return (p - Vec3(30, 30, 30)).norm() - 20; });
  const SmoothedVolume image(volume, 0);
  const LevelField levels(volume.grid, 50);
  const std::vector<Vec3> seeds{Vec3(30, 30, 30)};
  WordFlood all(image, seeds, 1, levels);
  CHECK(all.run(1'000'000));
  CHECK(WordFlood(image, seeds, 1, levels).run(all.count()));
  WordFlood part(image, seeds, 1, levels);
  CHECK_FALSE(part.run(5'000));
  CHECK(part.count() > 5'000);
  CHECK(part.count() <= 5'032);
}

TEST_CASE("by words a flood without a seed in the object is empty") {
  const SmoothedVolume image(testing::volumeByDistance(cubicGrid(20), 0, 100, [](const Vec3&) { return 1.; }),
                             0);
  const LevelField levels(image.grid(), 50);
  WordFlood flood(image, {Vec3(10, 10, 10)}, 1, levels);
  CHECK(flood.run(1'000));
  CHECK(flood.count() == 0);
  CHECK(flood.rim().faces.empty());
}
