#include "core/object/centrality.h"

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;

namespace {

//! The cells of `isInside` as a region around a click.
struct Made {
  ClickSearch search;
  ArrivalMap map;
  RankedRegion region;
  Made(int cells, const Vec3& spacing, const std::array<int, 3>& click, auto&& isInside) {
    CellGrid& grid = search.image.cells;
    grid.grid = cubicGrid(cells);
    grid.grid.spacing = spacing;
    search.click = click;
    for (int z = 0; z < cells; ++z)
      for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
          map.level.push_back(isInside(Vec3(x, y, z).cwiseProduct(spacing)) ? 0 : kNever);
    region.search = &search;
    region.map = &map;
  }
};

}  // namespace

TEST_CASE("the middle of a ball is as deep as it gets, its rim is not", "[object]") {
  // 31³ cells are looked at one by one, 99³ by samples.
  const int cells = GENERATE(31, 99);
  const double half = (cells - 1) / 2.0, radius = 0.8 * half;
  const int middle = static_cast<int>(half);
  for (const double part : {1.0, 0.75, 0.5, 0.25}) {
    const std::array<int, 3> click{middle + static_cast<int>(std::lround((1 - part) * radius)), middle,
                                   middle};
    const Made ball(cells, Vec3(1, 1, 1), click,
                    [&](const Vec3& p) { return (p - Vec3::Constant(half)).norm() < radius; });
    INFO(cells << " cells, " << part);
    CHECK(std::abs(centrality(ball.region) - part) < 0.1);
  }
}

TEST_CASE("depths are told in mm where cells are not cubes", "[object]") {
  // A plate of 20 mm, 4 mm thick along z, a click in its middle and one near its upper face.
  const Vec3 spacing(0.5, 0.5, 1.0 / 3);
  const auto plate = [](const Vec3& p) { return p[2] > 3 && p[2] < 7 && p[0] > 2; };
  const Made middle(40, spacing, {20, 20, 15}, plate);
  CHECK(centrality(middle.region) > 0.9);
  const Made high(40, spacing, {20, 20, 19}, plate);
  CHECK(centrality(high.region) < 0.4);
}

TEST_CASE("a region without its click, and one of a single cell", "[object]") {
  const Made without(9, Vec3(1, 1, 1), {4, 4, 4}, [](const Vec3& p) { return p[0] < 2; });
  CHECK(centrality(without.region) == 0);
  const Made single(9, Vec3(1, 1, 1), {4, 4, 4},
                    [](const Vec3& p) { return (p - Vec3(4, 4, 4)).norm() < 0.5; });
  CHECK(centrality(single.region) == 1);
}

TEST_CASE("what lies beyond the cells that were searched is outside", "[object]") {
  const Made all(40, Vec3(1, 1, 1), {1, 20, 20}, [](const Vec3&) { return true; });
  CHECK(centrality(all.region) < 0.2);
}
