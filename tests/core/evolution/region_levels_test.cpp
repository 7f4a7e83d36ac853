#include "core/evolution/region_levels.h"

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;

namespace {

const Vec3 kCentre(16, 16, 16);
constexpr double kRadius = 8;

//! A ball of 40 in a background of `outside(x)`, with an edge of one cell, in cells of a grid; the region is
//! the ball.
template <typename F>
std::pair<WorkImage, Region> ballIn(const Grid& grid, F&& outside) {
  WorkImage work;
  work.image.cells.grid = grid;
  const std::size_t count = work.cells().count();
  work.image.padding.assign(count, 0);
  work.values.resize(count);
  Region region{std::vector<std::uint8_t>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = work.cells().cellOf(i);
    const double depth = kRadius - (Vec3(c[0], c[1], c[2]) - kCentre).norm();
    const double t = std::clamp(0.5 - depth, 0.0, 1.0), around = outside(c[0]);
    work.values[i] = static_cast<float>(40 + t * (around - 40));
    region.inside[i] = depth > 0;
  }
  return {std::move(work), std::move(region)};
}

}  // namespace

TEST_CASE("levels on a region's surface are half-way up the edges next to it") {
  const Grid grid = cubicGrid(33);
  const auto [dark, region] = ballIn(grid, [](int) { return 120; });
  const RegionLevels levels = levelsOn(dark, region, grid);
  CHECK(levels.kind == ObjectKind::dark);
  CHECK(levels.high->at(kCentre) == Approx(80).margin(4));
  CHECK(levels.side->at(kCentre) == Approx(1));
  CHECK(levels.halfStep > 20);

  const auto [bright, same] = ballIn(grid, [](int) { return 0; });
  const RegionLevels falling = levelsOn(bright, same, grid);
  CHECK(falling.kind == ObjectKind::bright);
  CHECK(falling.low->at(kCentre) == Approx(20).margin(4));
  CHECK(falling.side->at(kCentre) == Approx(-1));
}

TEST_CASE("an object between two intensities has edges that rise and edges that fall") {
  const Grid grid = cubicGrid(33);
  const auto [work, region] = ballIn(grid, [](int x) { return x < 16 ? -20 : 100; });
  const RegionLevels levels = levelsOn(work, region, grid);
  CHECK(levels.side->at(Vec3(8, 16, 16)) < -0.1);  // each is heard on the other side, too
  CHECK(levels.side->at(Vec3(24, 16, 16)) > 0.1);
  CHECK(levels.high->at(Vec3(24, 16, 16)) == Approx(70).margin(6));
  CHECK(levels.low->at(Vec3(8, 16, 16)) == Approx(10).margin(6));
}

TEST_CASE("levels follow their edges, and are told on the grid that is asked for") {
  const Grid cells = cubicGrid(33);
  const auto [work, region] = ballIn(cells, [](int x) { return x < 16 ? 100 : 160; });
  Grid fine = cells;  // levels are smoothed over voxels of that grid
  fine.size = {65, 65, 65};
  fine.spacing /= 2;
  const RegionLevels levels = levelsOn(work, region, fine);
  CHECK(levels.high->at(fine.toIndex(cells.toWorld(Vec3(8, 16, 16)))) == Approx(70).margin(6));
  CHECK(levels.high->at(fine.toIndex(cells.toWorld(Vec3(24, 16, 16)))) == Approx(100).margin(6));
}

TEST_CASE("a level that is known already is kept, and around it counts as its edges would") {
  const Grid grid = cubicGrid(33);
  const Vec3 left(8, 16, 16), right(24, 16, 16);
  const auto [dark, region] = ballIn(grid, [](int) { return 120; });
  const auto everywhere = [](const Vec3&, bool rises) { return rises ? std::optional(50.0) : std::nullopt; };
  CHECK(levelsOn(dark, region, grid, everywhere).high->at(left) == Approx(50));
  const auto onTheLeft = [](const Vec3& p, bool) { return p[0] < 16 ? std::optional(50.0) : std::nullopt; };
  const RegionLevels levels = levelsOn(dark, region, grid, onTheLeft);
  const double own = levelsOn(dark, region, grid).high->at(right), middle = (50 + own) / 2;
  CHECK(levels.high->at(left) < middle);
  CHECK(levels.high->at(right) > middle);

  const auto [bright, same] = ballIn(grid, [](int) { return 0; });
  const auto falling = [](const Vec3&, bool rises) { return rises ? std::nullopt : std::optional(35.0); };
  CHECK(levelsOn(bright, same, grid, falling).low->at(left) == Approx(35));
}

TEST_CASE("a region in an image of one value has no levels") {
  const Grid grid = cubicGrid(33);
  const auto [work, region] = ballIn(grid, [](int) { return 40; });
  CHECK(levelsOn(work, region, grid).halfStep == 0);
}
