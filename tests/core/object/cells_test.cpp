#include "core/object/cells.h"

#include <cmath>
#include <numeric>
#include <random>

#include "core/object/distance.h"
#include "core/object/morphology.h"
#include "core/object/region_field.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

std::vector<std::uint8_t> randomBytes(std::size_t n, int values, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> out(n);
  for (auto& x : out) x = static_cast<std::uint8_t>(random() % static_cast<unsigned>(values));
  return out;
}

}  // namespace

TEST_CASE("cells of one voxel are the voxels") {
  const Volume volume = volumeByIndex(cubicGrid(9), [](int i, int j, int k) { return i + 10 * j + 100 * k; });
  const CellGrid cells = cellsAround(volume.grid, Vec3(4, 4, 4), 100, 1000);
  CHECK(cells.factor == std::array{1, 1, 1});
  CHECK(cells.count() == 729);
  const CellImage image = makeCells(volume, cells, nullptr);
  CHECK(image.values[cells.at(3, 4, 5)] == 543);
}

TEST_CASE("too many cells are made coarser along the finest axis first, and keep their places in the world") {
  Grid grid = cubicGrid(16);
  grid.spacing = Vec3(1, 1, 4);
  grid.origin = Vec3(5, -3, 2);
  const Volume volume = volumeByIndex(grid, [](int i, int, int) { return i; });
  const CellGrid cells = cellsAround(grid, grid.toWorld(Vec3(8, 8, 8)), 1000, 1024);
  CHECK(cells.factor == std::array{2, 2, 1});
  CHECK(cells.count() == 1024);
  // The first cell holds the voxels 0 and 1.
  CHECK((cells.grid.origin - grid.toWorld(Vec3(0.5, 0.5, 0))).norm() < 1e-12);
  CHECK(makeCells(volume, cells, nullptr).values[cells.at(3, 0, 0)] == 6.5);
}

TEST_CASE("a cell is the mean of its voxels, also where the last ones of the volume are fewer") {
  const Volume volume =
      volumeByIndex(cubicGrid(11), [](int i, int j, int k) { return (7 * i + 13 * j + 29 * k) % 101; });
  const CellGrid cells = cellsAround(volume.grid, Vec3(6, 6, 6), 4.5, 64);  // voxels 1 to 10, by threes
  CHECK(cells.factor == std::array{3, 3, 3});
  CHECK(cells.low == std::array{1, 1, 1});
  const CellImage image = makeCells(volume, cells, nullptr);
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        double sum = 0;
        int n = 0;
        for (int k = 1 + 3 * z; k < std::min(11, 4 + 3 * z); ++k)
          for (int j = 1 + 3 * y; j < std::min(11, 4 + 3 * y); ++j)
            for (int i = 1 + 3 * x; i < std::min(11, 4 + 3 * x); ++i)
              sum += (7 * i + 13 * j + 29 * k) % 101, ++n;
        CHECK(image.values[cells.at(x, y, z)] == Approx(sum / n));
      }
}

TEST_CASE("a box around a point says beyond which sides the volume goes on") {
  const CellGrid cells = cellsAround(cubicGrid(40), Vec3(5, 20, 20), 8, 1'000'000);
  CHECK(cells.goesOn[0] == std::array{false, true});
  CHECK(cells.goesOn[1] == std::array{true, true});
  CHECK(cells.low == std::array{0, 12, 12});
}

TEST_CASE("smoothing keeps a constant image and the sum of a point") {
  const CellGrid cells = cellsAround(cubicGrid(15), Vec3(7, 7, 7), 100, 10'000);
  for (const float x : smoothed(cells, std::vector<float>(cells.count(), 3), 1.2)) CHECK(x == Approx(3));
  std::vector<float> point(cells.count(), 0);
  point[cells.at(7, 7, 7)] = 1;
  const std::vector<float> wide = smoothed(cells, point, 1.2);
  CHECK(std::accumulate(wide.begin(), wide.end(), 0.0) == Approx(1));
}

TEST_CASE("distances are those of a search over all pairs, in spacings that differ") {
  const std::array<int, 3> size{7, 6, 5};
  const Vec3 spacing(1, 2.5, 0.7);
  std::vector<std::uint8_t> mask = randomBytes(210, 12, 3);
  for (auto& m : mask) m = m == 0;
  const std::vector<float> d = distanceTo(size, spacing, mask);
  const auto place = [&](std::size_t i) -> Vec3 {
    return Vec3(static_cast<double>(i % 7), static_cast<double>(i / 7 % 6), static_cast<double>(i / 42))
        .cwiseProduct(spacing);
  };
  for (std::size_t i = 0; i < mask.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t j = 0; j < mask.size(); ++j)
      if (mask[j]) nearest = std::min(nearest, (place(i) - place(j)).norm());
    CHECK(d[i] == Approx(nearest).margin(1e-5));
  }
  for (const double limit : {1.5, 4.0, 9.0}) {
    const std::vector<float> near = distanceTo(size, spacing, mask, limit);
    for (std::size_t i = 0; i < d.size(); ++i) {
      INFO(limit << " mm, cell " << i);
      if (d[i] <= limit)
        CHECK(near[i] == Approx(d[i]));
      else
        CHECK(near[i] > limit);
    }
  }
}

TEST_CASE("without a marked cell all distances are infinite") {
  for (const float d : distanceTo({3, 3, 3}, Vec3(1, 1, 1), std::vector<std::uint8_t>(27, 0)))
    CHECK(std::isinf(d));
}

TEST_CASE("a pass takes the highest or lowest of the neighbours named, and nothing else") {
  const std::array<int, 3> size{5, 4, 6};
  const std::vector<std::uint8_t> cells = randomBytes(120, 200, 5);
  for (const OpeningPass pass :
       {OpeningPass{{true, true, true}, false}, OpeningPass{{true, true, true}, true},
        OpeningPass{{true, false, true}, true}, OpeningPass{{false, false, true}, false}}) {
    std::vector<std::uint8_t> high = cells, low = cells;
    Morphology morphology(size);
    morphology.highest(high, pass);
    morphology.lowest(low, pass);
    for (int z = 0; z < 6; ++z)
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) {
          int most = 0, least = 255;
          for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
              for (int dx = -1; dx <= 1; ++dx) {
                const int moved = std::abs(dx) + std::abs(dy) + std::abs(dz);
                if (moved > (pass.diagonal ? 2 : 1)) continue;
                if ((dx && !pass.along[0]) || (dy && !pass.along[1]) || (dz && !pass.along[2])) continue;
                const int i = x + dx, j = y + dy, k = z + dz;
                if (i < 0 || j < 0 || k < 0 || i > 4 || j > 3 || k > 5) continue;
                const int v = cells[(k * 4 + j) * 5 + i];
                most = std::max(most, v), least = std::min(least, v);
              }
          const auto at = static_cast<std::size_t>((z * 4 + y) * 5 + x);
          CHECK(high[at] == most);
          CHECK(low[at] == least);
        }
  }
}

TEST_CASE("the depth in a ball of cells is its radius less the distance from the centre") {
  const Volume volume = volumeByIndex(cubicGrid(31), [](int, int, int) { return 0; });
  WorkImage work{makeCells(volume, cellsAround(volume.grid, Vec3(15, 15, 15), 100, 100'000), nullptr), {}};
  Region ball{std::vector<std::uint8_t>(work.cells().count(), 0)};
  const Vec3 centre(15, 15, 15);
  forCellsWithin(work.cells(), centre, 9.5, [&](std::size_t i) { ball.inside[i] = 1; });
  const RegionField field(work, ball);
  for (const double r : {3.0, 6.0, 8.0, 10.0, 12.0})
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Vec3 at = centre;
        at[axis] += sign * r;
        CHECK(field.at(at) == Approx(9.5 - r).margin(0.5));
      }
}

TEST_CASE("only parts with a wanted cell are kept, and small cavities are filled") {
  const Volume volume = volumeByIndex(cubicGrid(12), [](int, int, int) { return 0; });
  const WorkImage work{makeCells(volume, cellsAround(volume.grid, Vec3(5, 5, 5), 100, 100'000), nullptr), {}};
  Region region{std::vector<std::uint8_t>(work.cells().count(), 0)};
  forCellsWithin(work.cells(), Vec3(4, 4, 4), 3.1, [&](std::size_t i) { region.inside[i] = 1; });
  const std::size_t whole = region.count();
  region.inside[work.cells().at(4, 4, 4)] = 0;
  region.inside[work.cells().at(10, 10, 10)] = 1;
  keepParts(work, region, {work.cells().at(3, 4, 4)}, 2);
  CHECK(region.count() == whole);
  CHECK(region.inside[work.cells().at(4, 4, 4)] == 1);
  CHECK(region.inside[work.cells().at(10, 10, 10)] == 0);
}
