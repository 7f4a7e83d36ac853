#include "core/object/relabel.h"

#include <random>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

constexpr double kNoise = 6;
const Vec3 kBallCentre(20, 20, 20);
double distance(const std::array<int, 3>& c) { return (Vec3(c[0], c[1], c[2]) - kBallCentre).norm(); }

//! A core of 100 to 8 mm, a rim of 80 to 12 mm, 20 around it.
WorkImage rimmedBall() {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, kNoise);
  const Volume volume = volumeByIndex(cubicGrid(41), [&](int i, int j, int k) {
    const double d = distance({i, j, k});
    return (d < 8 ? 100 : d < 12 ? 80 : 20) + normal(random);
  });
  const CellGrid cells = cellsAround(volume.grid, kBallCentre, 100, 1'000'000);
  WorkImage work{makeCells(volume, cells, nullptr), {}};
  work.values = smoothed(cells, work.image.values, 0.6);
  return work;
}

template <typename F>
void forAll(const WorkImage& work, F&& f) {
  const auto& n = work.cells().grid.size;
  forBox({{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}}, f);
}
Region ballOf(const WorkImage& work, double radius) {
  Region r{std::vector<std::uint8_t>(work.cells().count(), 0)};
  forAll(work, [&](const std::array<int, 3>& c) { r.inside[work.cells().at(c)] = distance(c) < radius; });
  return r;
}
double diceOf(const WorkImage& work, const Region& region, double radius) {
  const Region truth = ballOf(work, radius);
  double both = 0;
  forAll(work, [&](const std::array<int, 3>& c) {
    both += region.inside[work.cells().at(c)] && truth.inside[work.cells().at(c)];
  });
  return 2 * both / static_cast<double>(region.count() + truth.count());
}
Relabelling clickAt(const WorkImage& work, const Vec3& place, double depth, double reach) {
  return {{place, work.cells().at(work.cells().nearest(place)), 1}, depth, reach, kNoise, {}, {}};
}

}  // namespace

TEST_CASE("a click in a missed rim takes in the rim all around, as far as it reaches") {
  const WorkImage work = rimmedBall();
  const Region core = ballOf(work, 8);
  REQUIRE(diceOf(work, core, 12) < 0.5);
  const Region all = relabelled(work, core, clickAt(work, Vec3(30, 20, 20), 2, 1000), {});
  CHECK(diceOf(work, all, 12) > 0.95);
  const Region near = relabelled(work, core, clickAt(work, Vec3(30, 20, 20), 2, 6), {});
  forAll(work, [&](const std::array<int, 3>& c) {
    const std::size_t i = work.cells().at(c);
    if ((Vec3(c[0], c[1], c[2]) - Vec3(30, 20, 20)).norm() > 6) CHECK(near.inside[i] == core.inside[i]);
  });
  CHECK(near.count() > core.count() + 200);
}

TEST_CASE("a surface a cell or two off its edge is moved towards it, one on its edge stays") {
  const WorkImage work = rimmedBall();
  CHECK(diceOf(work, refined(work, ballOf(work, 12), kNoise, {}), 12) > 0.97);
  for (const double radius : {10.0, 11.0, 13.0}) {
    const double before = diceOf(work, ballOf(work, radius), 12);
    CHECK(1 - diceOf(work, refined(work, ballOf(work, radius), kNoise, {}), 12) < 0.6 * (1 - before));
  }
}

TEST_CASE("a surface far from any edge moves by less than half a cell, and an empty region stays empty") {
  const WorkImage work = rimmedBall();
  const double half = diceOf(work, ballOf(work, 5.5), 5);
  CHECK(diceOf(work, refined(work, ballOf(work, 5), kNoise, {}), 5) > half);
  CHECK(refined(work, ballOf(work, 0), kNoise, {}).count() == 0);
}

TEST_CASE("a surface that a click has pushed past its edge comes back to it, and the click keeps its side") {
  const WorkImage work = rimmedBall();
  for (const bool isInside : {true, false}) {
    // The object ends at 12 mm. The click lies 3 mm behind a surface that was moved too far, by 1 mm.
    Relabelling r = clickAt(work, Vec3(isInside ? 31 : 33, 20, 20), 3, 1000);
    r.isInside = isInside;
    const Region moved = ballOf(work, isInside ? 13 : 11);
    const Region out = settled(work, moved, r, {});
    const double before = diceOf(work, moved, 12);
    CHECK(1 - diceOf(work, out, 12) < 0.5 * (1 - before));
    CHECK((out.inside[r.click.cell] != 0) == isInside);
    // No further than a third of the click's depth and a cell.
    ObjectPolicy little;
    little.settled = 0;
    const Region less = settled(work, moved, r, little);
    const double after = diceOf(work, less, 12);
    CHECK(after > before);
    CHECK(after < diceOf(work, out, 12));
  }
}

TEST_CASE("where the image is silent a ball shrinks by less than the walk's curvature alone would make it") {
  WorkImage work = rimmedBall();
  std::mt19937 random(7);
  std::normal_distribution<float> normal(50, static_cast<float>(kNoise));
  for (float& v : work.image.values) v = normal(random);
  work.values = smoothed(work.cells(), work.image.values, 0.6);
  const double depth = 4, radius = 8;
  const Region ball = ballOf(work, radius);
  const Region out = settled(work, ball, clickAt(work, Vec3(24, 20, 20), depth, 1000), {});
  // Between inside and outside the walk is harmonic: a + b / r, half way at the harmonic mean of the radii.
  const double zone = ObjectPolicy().settled * depth + 1, in = radius - zone, far = radius + zone;
  CHECK(overlapOf(out, ball) > overlapOf(ballOf(work, 2 * in * far / (in + far)), ball));
}

TEST_CASE("other clicks keep their side when a rim is relabelled") {
  const WorkImage work = rimmedBall();
  Relabelling r = clickAt(work, Vec3(30, 20, 20), 2, 1000);
  const Vec3 other(10, 20, 20);
  r.outside.push_back({other, work.cells().at(work.cells().nearest(other)), 1});
  CHECK_FALSE(relabelled(work, ballOf(work, 8), r, {}).inside[r.outside[0].cell]);
}

TEST_CASE("a change onto an edge gains edges, one away from it loses them") {
  const WorkImage work = rimmedBall();
  const EdgeChange onto = edgesOfChange(work, ballOf(work, 10), ballOf(work, 12), kNoise);
  CHECK(onto.gained > onto.lost + 1);
  const EdgeChange away = edgesOfChange(work, ballOf(work, 12), ballOf(work, 15), kNoise);
  CHECK(away.lost > away.gained + 1);
  const EdgeChange none = edgesOfChange(work, ballOf(work, 12), ballOf(work, 12), kNoise);
  CHECK(none.gained == 0);
  CHECK(none.lost == 0);
}

TEST_CASE(
    "a change as deep as its click costs nothing, one much deeper, against its sense or off an edge does") {
  const WorkImage work = rimmedBall();
  const auto cost = [&](double from, double radius, bool isInside, double depth) {
    ObjectPolicy byDepth;
    byDepth.edgesLost = 0;
    return costOfChange(work, ballOf(work, from), ballOf(work, radius), {isInside, depth, kNoise}, byDepth);
  };
  CHECK(cost(10, 10, true, 2) == 0);
  CHECK(cost(10, 12, true, 2) == 0);
  CHECK(cost(10, 15, true, 2) > cost(10, 13, true, 2));
  CHECK(cost(10, 15, true, 1) > cost(10, 15, true, 2));
  CHECK(cost(10, 8, false, 2) == 0);
  CHECK(cost(10, 8, true, 2) > 0);
  CHECK(cost(10, 12, false, 2) > 0);
  const auto withEdges = [&](double from, double radius) {
    return costOfChange(work, ballOf(work, from), ballOf(work, radius), {true, 4, kNoise}, {});
  };
  CHECK(withEdges(10, 12) == 0);   // onto the edge: it wins nothing
  CHECK(withEdges(12, 15) > 0.4);  // off it
}
