#include "core/object/tube_surface.h"

#include <functional>
#include <numbers>
#include <random>

#include "core/object/object_model.h"
#include "core/object/tube_tracking.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::volumeByIndex;

namespace {

// Half a ring of 60 mm around a corner of the volume, 7 mm thick, in voxels of 2 mm.
constexpr double kBend = 60, kRadius = 7;
const Vec3 kMiddle(0, 40, 20);
const Vec3 kOnRing(kBend, 40, 20);

Grid gridOfRing() { return {{40, 60, 20}, Vec3(2, 2, 2), Vec3(-8, -20, 0)}; }

//! Distance from the middle line, and the angle along it.
struct Place {
  double aside, angle;
};
Place placeOf(const Vec3& p) {
  const Vec3 to = p - kMiddle;
  return {std::hypot(std::hypot(to[0], to[1]) - kBend, to[2]), std::atan2(to[1], to[0])};
}
bool isInRing(const Vec3& p) { return placeOf(p).aside < kRadius; }

//! The ring among things as bright as itself: its wall is dark, and open for a third of the way.
double valueAt(const Vec3& p) {
  const auto [aside, angle] = placeOf(p);
  const bool isOpen = std::fmod(angle + 7, 0.3) < 0.1 && p[2] > kMiddle[2];
  return aside > kRadius && aside < kRadius + 4 && !isOpen ? 20 : 100;
}

Volume ring() {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 8);
  const Grid grid = gridOfRing();
  return volumeByIndex(
      grid, [&](int i, int j, int k) { return valueAt(grid.toWorld(Vec3(i, j, k))) + noise(random); });
}

WorkImage workOf(const Volume& volume, const ObjectPolicy& policy) {
  const CellGrid cells = cellsAround(volume.grid, kOnRing, policy.reach, policy.workCells);
  WorkImage work{makeCells(volume, cells, nullptr), {}};
  work.values = smoothed(cells, work.image.values, policy.smoothing * cells.grid.meanSpacing());
  return work;
}

double farthestAside(const Tube& tube) {
  double out = 0;
  for (const CrossSection& s : tube.sections) out = std::max(out, placeOf(s.centre).aside);
  return out;
}
Vec3 onRing(double angle) { return kMiddle + kBend * Vec3(std::cos(angle), std::sin(angle), 0); }
double least(const Tube& tube) {
  double out = 10;
  for (const CrossSection& s : tube.sections) out = std::min(out, placeOf(s.centre).angle);
  return out;
}
double most(const Tube& tube) {
  double out = -10;
  for (const CrossSection& s : tube.sections) out = std::max(out, placeOf(s.centre).angle);
  return out;
}

}  // namespace

TEST_CASE("A bent tube whose wall is open in places is followed both ways") {
  const Volume volume = ring();
  const ObjectPolicy policy;
  const WorkImage work = workOf(volume, policy);
  const auto tube = trackTube(work, {{kOnRing}}, {}, 6, policy);
  REQUIRE(tube);
  CHECK(tube->usualRadius() == Approx(kRadius).margin(1));
  CHECK(farthestAside(*tube) < kRadius / 3);
  CHECK(least(*tube) < -0.7);
  CHECK(most(*tube) > 0.7);
}

TEST_CASE("A click outside on its line ends a tube") {
  const Volume volume = ring();
  const ObjectPolicy policy;
  const WorkImage work = workOf(volume, policy);
  const auto tube = trackTube(work, {{kOnRing}}, {{onRing(0.5)}}, 6, policy);
  REQUIRE(tube);
  CHECK(most(*tube) < 0.5);
  CHECK(least(*tube) < -0.7);
}

TEST_CASE("Where a tube is lost a further click inside leads it on") {
  Volume volume = ring();
  const Grid grid = volume.grid;
  const Volume blank = volumeByIndex(grid, [&](int i, int j, int k) {  // a stretch in which nothing is seen
    const Vec3 p = grid.toWorld(Vec3(i, j, k));
    const double angle = placeOf(p).angle;
    return angle > 0.2 && angle < 0.75 ? 100.0 : valueAt(p);
  });
  const ObjectPolicy policy;
  const WorkImage work = workOf(blank, policy);
  const Vec3 start = onRing(-0.2);
  const auto first = trackTube(work, {{start}}, {}, 6, policy);
  REQUIRE(first);
  REQUIRE(most(*first) < 0.5);
  const auto both = trackTube(work, {{start}, {onRing(0.9)}}, {}, 6, policy);
  REQUIRE(both);
  CHECK(most(*both) > 0.85);
}

TEST_CASE("A ball is no tube") {
  const Grid grid = gridOfRing();
  const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
    return (grid.toWorld(Vec3(i, j, k)) - kOnRing).norm() < 9 ? 100 : 20;
  });
  const ObjectPolicy policy;
  const WorkImage work = workOf(volume, policy);
  for (const double start : {3.0, 6.0, 9.0, 14.0})
    CHECK_FALSE(trackTube(work, {{kOnRing}}, {}, start, policy));
}

TEST_CASE("One click in a bent tube with an open wall finds the tube") {
  const Volume volume = ring();
  const auto model = findObject(volume, {{{kOnRing}}, {}, 1, Contrast::any, 2}, nullptr);
  REQUIRE(model);
  const CellGrid& cells = model->work->cells();
  std::size_t both = 0, truth = 0;
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const auto c = cells.cellOf(i);
    const bool in = isInRing(cells.grid.toWorld(Vec3(c[0], c[1], c[2])));
    truth += in;
    both += in && model->region.inside[i];
  }
  CHECK(2.0 * static_cast<double>(both) / static_cast<double>(truth + model->region.count()) > 0.8);
}

TEST_CASE("A tube is followed further than the search around a click reaches") {
  const Grid grid{{20, 20, 130}, Vec3(2, 2, 4), Vec3(0, 0, 0)};
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 8);
  const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
    const double aside = std::hypot(2 * i - 20.0, 2 * j - 20.0);
    const bool isOpen = k % 12 < 4 && i > 10;
    return (aside > kRadius && aside < kRadius + 4 && !isOpen ? 20 : 100) + noise(random);
  });
  const auto model = findObject(volume, {{{Vec3(20, 20, 60)}}, {}, 1, Contrast::any, 2}, nullptr);
  REQUIRE(model);
  const CellGrid& cells = model->work->cells();
  const auto holds = [&](const Vec3& p) {
    return cells.contains(p) && model->region.inside[cells.at(cells.nearest(p))];
  };
  CHECK(holds(Vec3(20, 20, 100)));
  CHECK(holds(Vec3(20, 20, 400)));  // the search reaches 220
}
