#include "core/evolution/clicked_object.h"

#include <algorithm>
#include <random>
#include <set>

#include "core/evolution/active_contour.h"
#include "core/evolution/region_image.h"
#include "core/evolution/seeds.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"
#include "core/object/region_field.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

const Vec3 kLarge(22, 24, 24), kSmall(37, 24, 24);

//! A dark ball of radius 12 with one of radius 5 on it, in noise.
Volume knob() {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 4);
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const Vec3 p(i, j, k);
    return ((p - kLarge).norm() < 12 || (p - kSmall).norm() < 5 ? 40 : 120) + noise(random);
  });
}

//! Two balls of radius 8 with a passage of radius 3.
RegionField dumbbell() {
  WorkImage work;
  work.image.cells.grid = cubicGrid(49);
  Region region{std::vector<std::uint8_t>(work.cells().count())};
  for (std::size_t i = 0; i < region.inside.size(); ++i) {
    const auto c = work.cells().cellOf(i);
    const Vec3 p(c[0], c[1], c[2]);
    const bool passage = p[0] > 12 && p[0] < 36 && std::hypot(p[1] - 24, p[2] - 24) < 3;
    region.inside[i] = (p - Vec3(12, 24, 24)).norm() < 8 || (p - Vec3(36, 24, 24)).norm() < 8 || passage;
  }
  return RegionField(work, region);
}

Seed click(const Vec3& place, bool background = false) {
  Seed s{place, {}};
  s.background = background;
  return s;
}

}  // namespace

TEST_CASE("a click outside counts also where the image has a strong boundary all round it and the rest") {
  const Volume volume = knob();
  const ClickedObject both = findClickedObject(volume, {click(kLarge)}, {});
  REQUIRE(both.image->inside(kSmall) > 0);
  const ClickedObject one = findClickedObject(volume, {click(kLarge), click(kSmall, true)}, {});
  CHECK(one.image->inside(kSmall) < 0);
  CHECK(one.image->inside(kLarge) > 0);
  CHECK(one.image->inside(kLarge - Vec3(10, 0, 0)) > 0);
}

TEST_CASE("far from what a further click changes the object is to the bit what it was, boundary and all") {
  const Volume volume = knob();
  const ClickedObject before = findClickedObject(volume, {click(kLarge)}, {});
  const ClickedObject after = findClickedObject(volume, {click(kLarge), click(kSmall, true)}, {});
  REQUIRE(after.image->inside(kSmall) < 0);
  int looked = 0;
  for (int j = -8; j <= 8; ++j)
    for (int k = -8; k <= 8; ++k)
      for (double x = -14; x <= -4;
           x += 0.5) {  // the side away from the knob, with a few mm about its surface
        const Vec3 p = kLarge + Vec3(x, j, k);
        if (std::abs((p - kLarge).norm() - 12) > 1.5) continue;
        CHECK(after.image->inside(p) == before.image->inside(p));
        ++looked;
      }
  CHECK(looked > 500);
}

TEST_CASE("a ball outside bounds the object also where its centre lies outside already, boundary and all") {
  const Volume volume = knob();
  Seed ball{kLarge + Vec3(0, 0, 16), 7.0};
  ball.background = true;
  const ClickedObject before = findClickedObject(volume, {click(kLarge)}, {});
  const ClickedObject after = findClickedObject(volume, {click(kLarge), ball}, {});
  REQUIRE(before.image->inside(kLarge + Vec3(0, 0, 10.5)) > 0);
  CHECK(after.image->inside(kLarge + Vec3(0, 0, 10.5)) < 0);
  CHECK(after.image->inside(kLarge + Vec3(0, 0, 8)) > 0);
  for (const double z : {-13.0, -12.0, -11.0})
    CHECK(after.image->inside(kLarge + Vec3(0, 0, z)) == before.image->inside(kLarge + Vec3(0, 0, z)));
}

TEST_CASE("an object that further clicks have left as it was keeps its image") {
  const Volume volume = knob();
  ObjectQuery query;
  query.inside = {{kLarge, {}}};
  std::optional<ObjectModel> model = findObject(volume, query, nullptr);
  REQUIRE(model);
  model->start = model->region;
  const auto image = imageOfRegion(volume, *model, {}, nullptr);
  CHECK(imageOfCorrected(image, *model) == image);
}

TEST_CASE("a region goes on beyond the volume's border, but not where only the search ended") {
  WorkImage work;
  work.image.cells.grid = cubicGrid(12);
  Region region{std::vector<std::uint8_t>(work.cells().count())};
  forBox({{4, 4, 4}, {11, 7, 7}},
         [&](const std::array<int, 3>& c) { region.inside[work.cells().at(c)] = 1; });
  CHECK(RegionField(work, region).at(Vec3(40, 5, 5)) > 1);
  CHECK_FALSE(isCutOff(work.cells(), region));
  work.image.cells.goesOn[0] = {false, true};
  const RegionField field(work, region);
  CHECK(field.at(Vec3(10, 5.5, 5.5)) > 0);
  CHECK(field.at(Vec3(12, 5.5, 5.5)) < 0);  // the last cell ends at 11.5
  CHECK(field.at(Vec3(40, 5, 5)) < -1);
  CHECK(isCutOff(work.cells(), region));
}

namespace {

//! A plate 450 mm long, dark, with a darker ball in it around the click.
const Vec3 kPlateClick(75, 75, 75);
Volume plate() {
  Grid grid = cubicGrid(31);
  grid.size[0] = 100;
  grid.spacing = Vec3(5, 5, 5);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 3);
  return volumeByIndex(grid, [&](int i, int j, int k) {
    const bool isInPlate = i > 4 && i < 95 && j > 3 && j < 27 && k > 8 && k < 22,
               isInBall = (Vec3(i, j, k) - kPlateClick / 5).norm() < 4;
    return (isInBall ? 20 : isInPlate ? 70 : 160) + noise(random);
  });
}

}  // namespace

TEST_CASE("an object wider than a search is found whole; another candidate that is not tells so") {
  const Volume volume = plate();
  const Vec3 near(200, 75, 75), far(440, 75, 75), outside(490, 75, 75);
  const ClickedObject whole = findClickedObject(volume, {click(near)}, {});
  CHECK(whole.image->inside(near) > 0);
  CHECK(whole.image->inside(far) > 0);
  CHECK(whole.image->inside(outside) < 0);
  CHECK_FALSE(whole.isCutOff);

  int cut = 0;
  for (int candidate = 1; candidate <= 5; ++candidate) {
    Parameters p;
    p.candidate = candidate;
    const ClickedObject object = findClickedObject(volume, {click(kPlateClick)}, p);
    const bool isPlate = object.image->inside(near) > 0;  // 125 mm from the click; the search ends at 160
    CHECK(object.isCutOff == isPlate);
    CHECK(object.image->inside(far) < 0);
    cut += object.isCutOff;
    const ActiveContour contour(volume, {click(kPlateClick)}, p);
    const std::vector<Finding> told = contour.warnings(contour.support());
    CHECK(isPlate == std::any_of(told.begin(), told.end(),
                                 [](const Finding& f) { return f.kind == FindingKind::endsWithSearch; }));
  }
  CHECK(cut > 0);
}

TEST_CASE("places in a region are joined if a way between them is as deep as asked for") {
  const RegionField field = dumbbell();
  const Vec3 left(12, 24, 24), right(36, 24, 24);
  CHECK(field.areJoined(left, right, 1));
  CHECK(field.areJoined(left, right, 1.5));
  CHECK_FALSE(field.areJoined(left, right, 4));
  CHECK(field.areJoined(left, Vec3(14, 25, 23), 4));
  CHECK_FALSE(field.areJoined(left, Vec3(24, 24, 40), 1));   // outside of the region
  CHECK_FALSE(field.areJoined(left, Vec3(500, 24, 24), 1));  // and of its box
}

TEST_CASE("a further click in a region has no start of its own where the front of the first one comes") {
  const Grid grid = cubicGrid(49);
  const auto level = std::make_shared<const LevelField>(grid, 100);
  RegionLimits limits{std::make_shared<RegionField>(dumbbell()), grid, level, level, level, 0, 1};
  const ObjectImage image(std::make_shared<SmoothedVolume>(knob(), 0), std::move(limits), 40, nullptr);
  const Seed first = click(Vec3(12, 24, 24)), near = click(Vec3(14, 29, 24)),
             beyond = click(Vec3(36, 24, 24));
  const double wide = 4, narrow = 1.6;  // edge lengths, mm: a front needs three quarters
  CHECK(fitSeeds(image, {first, near}, narrow, false).size() == 1);
  CHECK(fitSeeds(image, {first, beyond}, narrow, false).size() == 1);
  CHECK(fitSeeds(image, {first, beyond}, wide, false).size() == 2);
  Seed placed = beyond;
  placed.radius = 2;
  CHECK(fitSeeds(image, {first, placed}, narrow, false).size() == 2);
}

TEST_CASE("next to a click the surface is the region's own, elsewhere the levels have it") {
  const Grid grid = cubicGrid(49);
  const auto level = std::make_shared<const LevelField>(grid, 100),
             side = std::make_shared<const LevelField>(grid, 1);
  const auto dark =
      std::make_shared<SmoothedVolume>(volumeByIndex(grid, [](int, int, int) { return 40; }), 0);
  const Vec3 beside(12, 24, 32.2), far(36, 24, 32.2);  // of a ball of radius 8 each
  const auto imageWith = [&](std::vector<ObjectClick> clicks) {
    RegionLimits limits{
        std::make_shared<RegionField>(dumbbell()), grid, level, level, side, 1, 1, false, clicks};
    return ObjectImage(dark, std::move(limits), 40, nullptr);
  };
  CHECK(imageWith({}).inside(beside) > 0);
  CHECK(imageWith({}).inside(far) > 0);
  CHECK(imageWith({{beside}}).inside(beside) < 0);
  CHECK(imageWith({{beside}}).inside(far) == imageWith({}).inside(far));
  const ObjectClick ball{beside + Vec3(0, 0, 6), 6.0};  // it ends there
  CHECK(imageWith({ball}).inside(beside) < 0);
  CHECK(imageWith({{ball.place}}).inside(beside) == imageWith({}).inside(beside));
}

TEST_CASE("a place that was clicked lies on its side of the surface, anew and going on") {
  const Volume volume = knob();
  const auto grow = [](ActiveContour& contour) {
    while (contour.stopReason() == StopReason::running) contour.step();
  };
  const auto windsAround = [](const ActiveContour& contour, const Vec3& place) {
    constexpr int kNone = -1;  // no component is left out
    return windingNumber(contour.mesh(), findComponents(contour.mesh()), kNone, place) == 1;
  };
  ActiveContour first(volume, {click(kLarge)}, {});
  grow(first);
  for (const Vec3& way : {Vec3(-2, 1, 2), Vec3(-1, -2, 2), Vec3(-2, -2, -1), Vec3(-3, 0, 0)})
    for (const double radius : {11.0, 13.0}) {  // of 12, in voxels of 1 mm
      const Vec3 place = kLarge + radius / 3 * way;
      const bool isOutside = radius < 12;
      CAPTURE(way, radius);
      const std::vector<Seed> clicks{click(kLarge), click(place, isOutside)};
      ActiveContour anew(volume, clicks, {}), goingOn = first;
      grow(anew);
      CHECK(windsAround(anew, place) != isOutside);
      goingOn.change({clicks, {}});
      grow(goingOn);
      CHECK(windsAround(goingOn, place) != isOutside);
    }
}

namespace {

//! Voxels of 3 mm: a dark ball of radius 18 mm, grey around it, and bright half-way round a little further
//! out.
const Vec3 kCoarse(48, 48, 48);
Volume inCoarseVoxels() {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 3);
  Grid grid = cubicGrid(33);
  grid.spacing = Vec3(3, 3, 3);
  return volumeByIndex(grid, [&](int i, int j, int k) {
    const Vec3 p = 3 * Vec3(i, j, k) - kCoarse;
    const double outside = std::clamp(p.norm() / 3 - 6 + 0.5, 0.0, 1.0),
                 bright = p[0] > 0 ? std::clamp(p.norm() / 3 - 8 + 0.5, 0.0, 1.0) : 0;
    return 25 + outside * 75 + bright * 150 + noise(random);
  });
}

double volumeOf(const Volume& volume, const std::vector<Seed>& clicks) {
  ActiveContour contour(volume, clicks, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  return signedVolume(contour.mesh());
}

}  // namespace

TEST_CASE("in coarse voxels, too, a click outside lets the object grow nowhere") {
  const Volume volume = inCoarseVoxels();
  const Vec3 place = kCoarse + 16.5 * Vec3(-2, 1, 2) / 3;
  const double before = volumeOf(volume, {click(kCoarse)});
  const double after = volumeOf(volume, {click(kCoarse), click(place, true)});
  CHECK(before == Approx(4.0 / 3 * 3.1416 * std::pow(18, 3)).epsilon(0.1));
  CHECK(after < 1.005 * before);
  CHECK(after > 0.9 * before);
}

TEST_CASE("both ends of a passage are reached, whatever its width, from one start or two") {
  const Vec3 kLeft(12, 24, 24), kRight(36, 24, 24), kKnob(10, 34, 24);
  std::set<std::size_t> starts;
  for (const double radius : {1.0, 1.6, 2.0, 2.2, 2.4, 3.0}) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 4);
    const Volume volume = volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
      const Vec3 p(i, j, k);
      const bool passage = p[0] > 12 && p[0] < 36 && std::hypot(p[1] - 24, p[2] - 24) < radius;
      return ((p - kLeft).norm() < 8 || (p - kRight).norm() < 8 || (p - kKnob).norm() < 5 || passage ? 40
                                                                                                     : 120) +
             noise(random);
    });
    const std::vector<Seed> clicks{click(kLeft), click(kRight), click(kKnob + Vec3(0, 1, 0), true)};
    ActiveContour contour(volume, clicks, {});
    while (contour.stopReason() == StopReason::running) contour.step();
    const Components parts = findComponents(contour.mesh());
    CAPTURE(radius);
    constexpr int kNone = -1;  // no component is left out
    CHECK(windingNumber(contour.mesh(), parts, kNone, kLeft) == 1);
    CHECK(windingNumber(contour.mesh(), parts, kNone, kRight) == 1);
    starts.insert(contour.parameters().seeds.size() - 1);  // but for the click outside
  }
  CHECK(starts == std::set<std::size_t>{1, 2});
}
