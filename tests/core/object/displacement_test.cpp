#include "core/object/displacement.h"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

//! Cells of 1 mm; the region is what lies below z = 20.
struct HalfSpace {
  HalfSpace() {
    const Volume volume = volumeByIndex(cubicGrid(41), [](int, int, int) { return 0; });
    const CellGrid cells = cellsAround(volume.grid, Vec3(20, 20, 20), 100, 1'000'000);
    work = {makeCells(volume, cells, nullptr), {}};
    work.values.assign(cells.count(), 0);
    region.inside.assign(cells.count(), 0);
    forAll([&](const std::array<int, 3>& c) { region.inside[work.cells().at(c)] = c[2] < 20; });
  }
  template <typename F>
  void forAll(F&& f) const {
    forBox({{0, 0, 0}, {40, 40, 40}}, f);
  }
  CellClick click(const Vec3& place) const {
    return {place, work.cells().at(work.cells().nearest(place)), 0};
  }
  //! Cells inside above a column, counted from z = 0.
  int height(const Region& r, int x, int y) const {
    int n = 0;
    for (int z = 0; z < 41; ++z) n += r.inside[work.cells().at(std::array{x, y, z})] != 0;
    return n;
  }
  WorkImage work;
  Region region;
};

}  // namespace

TEST_CASE(
    "a plane is displaced by a bell around the click, upwards for one inside and downwards for one outside") {
  const HalfSpace h;
  for (const bool isInside : {true, false}) {
    // The click lies 4 mm behind the last cell of its own side; distances are those of cells' centres.
    const CellClick click = h.click(Vec3(20, 20, isInside ? 23 : 16));
    const Displacement d{click, isInside, 6, 5, {}};
    const Region moved = displaced(h.work, h.region, h.region, d);
    h.forAll([&](const std::array<int, 3>& c) {
      const double beyond = isInside ? c[2] - 19 : 20 - c[2];
      const double r2 = (Vec3(c[0], c[1], c[2]) - click.place).squaredNorm();
      const double lift = 6 * std::exp(-r2 / 50);
      const bool isOwn = beyond <= 0, isTaken = lift > 0.5 && beyond <= lift;
      CHECK((moved.inside[h.work.cells().at(c)] != 0) == ((isOwn || isTaken) == isInside));
    });
    CHECK(std::abs(h.height(moved, 20, 20) - 20) >= 5);
    CHECK(h.height(moved, 2, 20) == 20);
  }
}

TEST_CASE(
    "what is nearer to a click of the other kind stays, and so does all where the bell is lower than half a "
    "cell") {
  const HalfSpace h;
  const CellClick click = h.click(Vec3(20, 20, 23)), other = h.click(Vec3(26, 20, 23));
  const Region moved = displaced(h.work, h.region, h.region, {click, true, 6, 8, {other}});
  CHECK(h.height(moved, 20, 20) > 23);
  CHECK(h.height(moved, 14, 20) > 22);
  for (int x = 24; x < 41; ++x) CHECK(h.height(moved, x, 20) == 20);
  const Region same = displaced(h.work, h.region, h.region, {click, true, 0.4, 8, {}});
  CHECK(same.inside == h.region.inside);
}

TEST_CASE("what was found for the click beside the moved surface is kept") {
  const HalfSpace h;
  Region found = h.region;
  const std::size_t far = h.work.cells().at(std::array{3, 3, 38});
  found.inside[far] = 1;
  const Region both = displaced(h.work, h.region, found, {h.click(Vec3(20, 20, 23)), true, 6, 5, {}});
  CHECK(both.inside[far] == 1);
  CHECK(both.count() > h.region.count() + 100);
}

TEST_CASE("edges stop the surface that is displaced, the more the stronger they are") {
  HalfSpace h;
  // Intensities rise by 10 between z = 21 and z = 22: a step there is worth 1 mm times 1 + (10 / edge)^2.
  h.forAll([&](const std::array<int, 3>& c) { h.work.values[h.work.cells().at(c)] = c[2] > 21 ? 10 : 0; });
  const CellClick click = h.click(Vec3(20, 20, 21));
  const auto heightWith = [&](double edge) {
    return h.height(displaced(h.work, h.region, h.region, {click, true, 6, 8, {}, edge}), 20, 20) - 20;
  };
  CHECK(heightWith(0) == 5);   // beyond it the bell is lower than the way
  CHECK(heightWith(10) == 4);  // one step counts twice
  CHECK(heightWith(4) == 2);   // a step of 7.25 mm is higher than the bell
}

TEST_CASE("a click outside in a slice on the volume's border means the slice, not its rim") {
  constexpr int kAcross = 41;
  const auto keptOf = [](int slices, int clicked, double thick, bool isInside = false) {
    Grid grid = cubicGrid(kAcross);
    grid.size[2] = slices;
    grid.spacing[2] = 10;
    WorkImage work;
    work.image.cells.grid = grid;
    work.values.assign(work.cells().count(), 0);
    Region region{std::vector<std::uint8_t>(work.cells().count())};
    const auto forAll = [&](auto&& f) { forBox({{0, 0, 0}, {kAcross - 1, kAcross - 1, slices - 1}}, f); };
    forAll([&](const std::array<int, 3>& c) {
      region.inside[work.cells().at(c)] = std::hypot(c[0] - 20, c[1] - 20) < 15;
    });
    const std::array<int, 3> at{12, 20, clicked};
    const CellClick click{work.cells().grid.toWorld(Vec3(at[0], at[1], at[2])), work.cells().at(at), 0};
    const Region moved = displaced(work, region, region, {click, isInside, 9, 13, {}, 0, thick});
    std::vector<int> kept(static_cast<std::size_t>(slices), 0);  // cells per slice, of 697
    forAll([&](const std::array<int, 3>& c) { kept[c[2]] += moved.inside[work.cells().at(c)]; });
    return kept;
  };
  const std::vector<int> rim = keptOf(6, 0, 0), slice = keptOf(6, 0, 2.5);
  CHECK(rim[0] > 250);
  CHECK(slice[0] < 150);
  CHECK(std::equal(slice.begin() + 1, slice.end(), rim.begin() + 1));
  CHECK(keptOf(6, 5, 2.5)[5] == slice[0]);                  // the other end
  CHECK(keptOf(6, 2, 2.5) == keptOf(6, 2, 0));              // in the midst of the stack
  CHECK(keptOf(6, 0, 20) == rim);                           // no slices: they would have to be thicker
  CHECK(keptOf(4, 0, 2.5) == keptOf(4, 0, 0));              // all ends
  CHECK(keptOf(6, 0, 2.5, true) == keptOf(6, 0, 0, true));  // only what is too much comes by the slice
}
