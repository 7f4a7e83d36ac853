#include "core/evolution/start_object.h"

#include <cmath>
#include <random>

#include "core/evolution/clicked_object.h"
#include "core/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

const Vec3 kMiddle(24, 24, 24), kOther(38, 24, 24);

StartSurface startOf(const TriangleSoup& mesh, const Vec3& inside) {
  StartSurface start;
  start.path = "start.stl";
  start.mesh = std::make_shared<const TriangleSoup>(mesh);
  start.inside = inside;
  return start;
}

StartSurface ball(const Vec3& centre, double radius) {
  return startOf(icosphere(centre, radius, 1.5), centre);
}

//! Two balls apart from each other.
StartSurface pair() {
  TriangleSoup both = icosphere(kMiddle, 6, 1.5);
  const TriangleSoup other = icosphere(kOther, 5, 1.5);
  const int first = static_cast<int>(both.points.size());
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return startOf(both, kMiddle);
}

//! A dark ball of that radius, 80 below what is around it.
Volume ballVolume(double radius) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 3);
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const double out = std::clamp((Vec3(i, j, k) - kMiddle).norm() - radius + 0.5, 0.0, 1.0);
    return 40 + 80 * out + noise(random);
  });
}

//! Nothing but noise.
Volume noiseVolume() {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(100, 10);
  return volumeByIndex(cubicGrid(49), [&](int, int, int) { return noise(random); });
}

//! The parts of a ball, and of the shell from 1.5 to 4 mm around it, that the object holds.
struct Held {
  double inside = 0, around = 0;
};
Held heldIn(const ObjectImage& image, const Vec3& centre, double radius) {
  Held held;
  double in = 0, around = 0;
  for (int k = 0; k < 49; ++k)
    for (int j = 0; j < 49; ++j)
      for (int i = 0; i < 49; ++i) {
        const Vec3 p(i, j, k);
        const double d = (p - centre).norm() - radius;
        const bool isHeld = image.inside(p) > 0;
        if (d < -1) in += 1, held.inside += isHeld;
        if (d > 1.5 && d < 4) around += 1, held.around += isHeld;
      }
  return {held.inside / in, held.around / around};
}

}  // namespace

TEST_CASE("the cells within a surface are those whose centres it encloses", "[evolution][start]") {
  const Grid grid = cubicGrid(49);
  const auto region = cellsWithin(ball(kMiddle, 9), grid);
  CHECK(region->cells.grid.size[0] < 30);  // no more than it takes
  CHECK(static_cast<double>(region->region.count()) == Approx(4.0 / 3 * 3.14159 * 729).epsilon(0.03));
  const auto cell = region->cells.nearest(kMiddle + Vec3(8, 0, 0));
  CHECK(region->region.inside[region->cells.at(cell)] == 1);
  CHECK(region->region.inside[region->cells.at(region->cells.nearest(kMiddle + Vec3(10, 0, 0)))] == 0);
}

TEST_CASE("a surface that lies next to a boundary here and not there outlines a part", "[evolution][start]") {
  const ObjectChoice boundary = chooseObject(ballVolume(10), {Seed{kMiddle, 4.0}}, {});
  CHECK(outlinesPart(ball(kMiddle + Vec3(4, 0, 0), 6), boundary));
  CHECK_FALSE(outlinesPart(ball(kMiddle, 10), boundary));  // all of it
  CHECK_FALSE(outlinesPart(ball(kMiddle, 12), boundary));
  CHECK_FALSE(outlinesPart(ball(kMiddle, 5), boundary));  // elsewhere
  CHECK_FALSE(outlinesPart(ball(kMiddle, 14), boundary));
}

TEST_CASE("where the image shows no object a start means what it encloses", "[evolution][start]") {
  const Volume volume = noiseVolume();
  const StartSurface start = ball(kMiddle, 9);
  const ClickedObject found = findClickedObject(volume, {}, {}, nullptr, &start);
  const Held held = heldIn(*found.image, kMiddle, 9);
  CHECK(held.inside > 0.98);
  CHECK(held.around < 0.02);
}

TEST_CASE("a start within a clear object, or around it, means that object; one that is a part of it does not",
          "[evolution][start]") {
  const Volume volume = ballVolume(10);
  for (const double radius : {5.0, 12.0, 14.0}) {
    const StartSurface start = ball(kMiddle, radius);
    const ClickedObject found = findClickedObject(volume, {}, {}, nullptr, &start);
    CHECK(heldIn(*found.image, kMiddle, 10).inside > 0.98);
    CHECK(heldIn(*found.image, kMiddle, 10).around < 0.02);
  }
  // A half: a dome with a flat face through the middle, which the image does not show.
  TriangleSoup dome = icosphere(kMiddle, 10, 1.5);
  for (Vec3& p : dome.points) p[2] = std::max(p[2], 24 + 1e-3 * (p[2] - 24));
  const StartSurface half = startOf(dome, kMiddle + Vec3(0, 0, 4));
  const ClickedObject found = findClickedObject(volume, {}, {}, nullptr, &half);
  CHECK(found.image->inside(kMiddle + Vec3(0, 0, 5)) > 0);
  CHECK(found.image->inside(kMiddle - Vec3(0, 0, 5)) < 0);
}

TEST_CASE("clicks correct what a start means, and all its parts stay", "[evolution][start]") {
  const Volume volume = noiseVolume();
  const StartSurface start = pair();
  const ClickedObject both = findClickedObject(volume, {}, {}, nullptr, &start);
  CHECK(heldIn(*both.image, kMiddle, 6).inside > 0.98);
  CHECK(heldIn(*both.image, kOther, 5).inside > 0.98);

  Seed outside{kMiddle - Vec3(5, 0, 0), {}};
  outside.background = true;
  const ClickedObject cut = findClickedObject(volume, {outside}, {}, nullptr, &start);
  CHECK(cut.image->inside(outside.centre) < 0);
  CHECK(cut.image->inside(kMiddle + Vec3(3, 0, 0)) > 0);
  CHECK(heldIn(*cut.image, kOther, 5).inside > 0.98);

  const Seed further{kMiddle + Vec3(0, 0, 8), {}};
  const ClickedObject grown = findClickedObject(volume, {further}, {}, nullptr, &start);
  CHECK(grown.image->inside(further.centre) > 0);
  CHECK(heldIn(*grown.image, kOther, 5).inside > 0.98);
}

TEST_CASE("where all is zero a start means what it encloses", "[evolution][start]") {
  const Volume volume = volumeByIndex(cubicGrid(49), [](int, int, int) { return 0; });
  const StartSurface start = ball(kMiddle, 9);
  const ClickedObject found = findClickedObject(volume, {}, {}, nullptr, &start);
  CHECK(std::isfinite(found.image->inside(kMiddle)));
  const Held held = heldIn(*found.image, kMiddle, 9);
  CHECK(held.inside > 0.98);
  CHECK(held.around < 0.02);
}

TEST_CASE("all that is given is kept, also where its last coarse cells stand out of the volume",
          "[evolution][start]") {
  Grid grid;
  grid.size = {31, 31, 181};
  grid.spacing = Vec3(4, 4, 1.2);
  const Vec3 middle(60, 60, 108), end(60, 60, 210);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(100, 5);
  const Volume volume = volumeByIndex(grid, [&](int, int, int) { return noise(random); });
  ObjectPolicy policy;
  policy.workCells = 60'000;
  auto given = std::make_shared<RegionInCells>();
  given->cells = cellsAround(grid, middle, 200, policy.workCells);
  REQUIRE(given->cells.factor[2] == 3);  // 181 voxels: the middle of the last cell lies beyond the volume
  given->region.inside.assign(given->cells.count(), 1);
  ObjectQuery query{{{middle}}, {}};
  query.given = given;
  const auto model = findObject(volume, query, nullptr, policy);
  REQUIRE(model);
  const CellGrid& cells = model->work->cells();
  REQUIRE(cells.contains(end));
  CHECK(model->region.inside[cells.at(cells.nearest(end))] == 1);
}
