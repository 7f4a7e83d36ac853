#include "core/object/object_model.h"

#include <array>
#include <atomic>
#include <random>

#include "core/cancellation.h"
#include "core/object/corrections.h"
#include "core/object/displacement.h"
#include "core/object/relabel.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

using Inside = std::function<bool(const Vec3&)>;

bool inBall(const Vec3& p, const Vec3& centre, double radius) { return (p - centre).norm() < radius; }

//! `in` where the predicate holds, `out` elsewhere, with noise.
Volume imageOf(const Grid& grid, const Inside& inside, double in, double out, double noise = 0) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, std::max(noise, 1e-9));
  return volumeByIndex(grid, [&](int i, int j, int k) {
    return (inside(grid.toWorld(Vec3(i, j, k))) ? in : out) + normal(random);
  });
}

double diceOf(const ObjectModel& model, const Inside& truth) {
  const CellGrid& cells = model.work->cells();
  double both = 0, in = 0, wanted = 0;
  forBox({{0, 0, 0}, {cells.grid.size[0] - 1, cells.grid.size[1] - 1, cells.grid.size[2] - 1}},
         [&](const std::array<int, 3>& c) {
           const bool has = model.region.inside[cells.at(c)] != 0,
                      should = truth(cells.grid.toWorld(Vec3(c[0], c[1], c[2])));
           both += has && should, in += has, wanted += should;
         });
  return 2 * both / (in + wanted);
}

ObjectQuery clickAt(const Vec3& place) {
  ObjectQuery query;
  query.inside.push_back({place, {}});
  return query;
}

double diceOfClick(const Volume& volume, const Vec3& place, const Inside& truth) {
  const auto model = findObject(volume, clickAt(place), nullptr);
  REQUIRE(model);
  return diceOf(*model, truth);
}

const Vec3 kMiddle(24, 24, 24);
const Inside kBall = [](const Vec3& p) { return inBall(p, kMiddle, 11); };

}  // namespace

TEST_CASE("one click finds a dark ball and a bright one") {
  CHECK(diceOfClick(imageOf(cubicGrid(49), kBall, 40, 120, 8), Vec3(22, 25, 24), kBall) > 0.97);
  CHECK(diceOfClick(imageOf(cubicGrid(49), kBall, 120, 40, 8), Vec3(22, 25, 24), kBall) > 0.97);
}

TEST_CASE("one click finds a ball between two neighbours, one darker and one brighter") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 4);
  const Volume volume = volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const bool in = kBall(Vec3(i, j, k));
    return (in ? 100 : i < 24 ? 40 : 160) + normal(random);
  });
  CHECK(diceOfClick(volume, kMiddle, kBall) > 0.9);
}

TEST_CASE("one click finds a spot without a plateau, as in PET") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 20);
  const Volume volume = volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    return 30 + 1000 * std::exp(-0.5 * (Vec3(i, j, k) - kMiddle).squaredNorm() / 16) + normal(random);
  });
  // Anything between 40 and 50 % of the maximum is a fair boundary: radii 4.7 to 5.4.
  CHECK(diceOfClick(volume, kMiddle, [](const Vec3& p) { return inBall(p, kMiddle, 5); }) > 0.8);
}

TEST_CASE("one click finds the ball whatever the voxels: thick slices, an oblique grid") {
  Grid grid = cubicGrid(49);
  grid.size = {49, 49, 12};
  grid.spacing = Vec3(1, 1, 4);
  CHECK(diceOfClick(imageOf(grid, kBall, 40, 120, 8), kMiddle, kBall) > 0.93);
}

TEST_CASE("in a constant image there is no object") {
  CHECK(!findObject(imageOf(cubicGrid(20), kBall, 5, 5), clickAt(Vec3(10, 10, 10)), nullptr));
}

TEST_CASE("dark and bright leave out what is not") {
  const Volume volume = imageOf(cubicGrid(49), kBall, 40, 120, 8);
  ObjectQuery query = clickAt(kMiddle);
  query.contrast = Contrast::dark;
  const auto dark = findObject(volume, query, nullptr);
  REQUIRE(dark);
  CHECK(dark->rise > 0);
  query.contrast = Contrast::bright;
  const auto bright = findObject(volume, query, nullptr);
  CHECK((!bright || bright->rise < 0));
}

TEST_CASE("another candidate is grown where it is asked for, and the list stays the same") {
  const Inside two = [](const Vec3& p) {
    return inBall(p, Vec3(13, 24, 24), 7) || inBall(p, Vec3(35, 24, 24), 10) ||
           (p[0] > 13 && p[0] < 35 && std::hypot(p[1] - 24, p[2] - 24) < 1.8);
  };
  const Volume volume = imageOf(cubicGrid(49), two, 40, 120, 3);
  ObjectQuery query = clickAt(Vec3(13, 24, 24));
  const auto first = findObject(volume, query, nullptr);
  REQUIRE((first && first->candidates.size() >= 2));
  query.candidate = 2;
  const auto second = findObject(volume, query, nullptr);
  REQUIRE(second);
  CHECK(second->chosen == 2);
  REQUIRE(second->candidates.size() == first->candidates.size());
  CHECK(second->candidates[1].volume == first->candidates[1].volume);
  CHECK(std::abs(static_cast<double>(second->region.count()) - second->candidates[1].volume) < 30);
}

TEST_CASE("every click is true in the end, and one outside cuts off what hangs on there") {
  const Inside left = [](const Vec3& p) { return inBall(p, Vec3(16, 24, 24), 8); };
  const Inside right = [](const Vec3& p) { return inBall(p, Vec3(33, 24, 24), 10); };
  const Inside both = [&](const Vec3& p) { return left(p) || right(p); };
  const Volume volume = imageOf(cubicGrid(52), both, 40, 120, 3);  // they overlap: no neck narrower than 4
  ObjectQuery query = clickAt(Vec3(16, 24, 24));
  query.outside.push_back({Vec3(33, 24, 24), {}});
  const auto model = findObject(volume, query, nullptr);
  REQUIRE(model);
  const CellGrid& cells = model->work->cells();
  CHECK(model->region.inside[cells.at(cells.nearest(Vec3(33, 24, 24)))] == 0);
  CHECK(model->region.inside[cells.at(cells.nearest(Vec3(16, 24, 24)))] == 1);
  CHECK(diceOf(*model, left) > 0.85);
}

TEST_CASE("a further click inside takes in what has other intensities, and leaves the rest as it is") {
  const Inside left = [](const Vec3& p) { return p[0] < 24 && kBall(p); };
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 3);
  const Volume volume = volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const Vec3 p(i, j, k);
    return (left(p) ? 40 : kBall(p) ? 160 : 100) + normal(random);
  });
  ObjectQuery query = clickAt(Vec3(19, 24, 24));
  const auto half = findObject(volume, query, nullptr);
  REQUIRE(half);
  REQUIRE(diceOf(*half, kBall) < 0.7);
  query.inside.push_back({Vec3(30, 24, 24), {}});
  const auto whole = findObject(volume, query, nullptr);
  REQUIRE(whole);
  CHECK(diceOf(*whole, kBall) > 0.9);
}

namespace {

//! Cells that only one of them holds, those at a click left out: it is true by definition. In cells that
//! begin at the origin.
int cellsApart(const WorkImage& work, const Region& a, const Region& b, const Vec3& click) {
  int apart = 0;
  for (std::size_t i = 0; i < a.inside.size(); ++i)
    apart += a.inside[i] != b.inside[i] && (placeOf(work.cells(), work.cells().cellOf(i)) - click).norm() > 1;
  return apart;
}

}  // namespace

TEST_CASE("a click less deep than half the object moves its surface, which settles; nothing else is tried") {
  const ObjectPolicy policy;
  const Volume volume = imageOf(cubicGrid(49), kBall, 40, 120, 8);
  ObjectQuery query = clickAt(kMiddle);
  const auto ball = findObject(volume, query, nullptr);
  REQUIRE(ball);
  const WorkImage& work = *ball->work;
  const Vec3 place(37, 24, 24);
  const CellClick click{place, work.cells().at(work.cells().nearest(place)), 0};
  const double depth = depthBehindSurface(work, ball->region, click.cell);
  const double radius = deepestInside(work, ball->region);
  REQUIRE(depth < policy.shallow * radius);
  const Region moved = displaced(work, ball->region, ball->region,
                                 {click,
                                  true,
                                  policy.displaced * depth,
                                  policy.displacedWidth * radius,
                                  {},
                                  policy.displacedEdge * ball->noise});
  REQUIRE(moved.count() > ball->region.count());
  const CellClick first{kMiddle, work.cells().at(work.cells().nearest(kMiddle)), 1};
  const Region expected = settled(work, moved, {click, depth, 1000, ball->noise, {first, click}, {}}, policy);
  query.inside.push_back({place, {}});
  const auto wider = findObject(volume, query, nullptr);
  REQUIRE(wider);
  CHECK(cellsApart(work, wider->region, expected, place) == 0);
  ObjectPolicy always;
  always.shallow = 0;
  CHECK(cellsApart(work, findObject(volume, query, nullptr, always)->region, expected, place) > 0);
}

TEST_CASE("of a boundary that is shown only what is near a click settles") {
  const Volume volume = imageOf(cubicGrid(49), kBall, 40, 120, 8);
  ObjectQuery query = clickAt(kMiddle);
  const auto ball = findObject(volume, query, nullptr);
  REQUIRE(ball);
  const WorkImage& work = *ball->work;
  // A cell off its edge all around, which any surface of a region would settle on.
  Region off{std::vector<std::uint8_t>(work.cells().count(), 0)};
  forCellsWithin(work.cells(), kMiddle, 12, [&](std::size_t i) { off.inside[i] = 1; });
  query.shown = std::make_shared<const RegionInCells>(RegionInCells{work.cells(), off});
  const Vec3 click(38, 24, 24);
  query.inside.push_back({click, {}});
  const auto changedFurtherThan = [&](double reach, const ObjectPolicy& policy) {
    const auto model = findObject(volume, query, nullptr, policy);
    REQUIRE(model);
    int changed = 0;
    for (std::size_t i = 0; i < off.inside.size(); ++i)
      changed += model->region.inside[i] != off.inside[i] &&
                 (placeOf(work.cells(), work.cells().cellOf(i)) - click).norm() > reach;
    return changed;
  };
  ObjectPolicy near, wide;
  near.displacedWidth = wide.displacedWidth = 0.2;  // the bell reaches less far than what settles
  wide.settledNear = 1000;
  const double reach = near.settledNear * near.displacedWidth * deepestInside(work, off) + 0.5;
  CHECK(changedFurtherThan(reach, near) == 0);
  CHECK(changedFurtherThan(0, near) > 0);
  CHECK(changedFurtherThan(reach, wide) > 100);
}

TEST_CASE(
    "a click outside in the middle of what was found asks for another candidate, not for a cut; not for next "
    "to nothing once the object has been corrected") {
  const Inside large = [](const Vec3& p) { return inBall(p, Vec3(32, 32, 32), 18); };
  const Inside small = [](const Vec3& p) { return inBall(p, Vec3(32, 32, 41), 5); };
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 8);
  const Volume volume = volumeByIndex(cubicGrid(65), [&](int i, int j, int k) {
    const Vec3 p(i, j, k);
    return (small(p) ? 115 : large(p) ? 100 : 40) + normal(random);
  });
  ObjectQuery query = clickAt(Vec3(32, 32, 41));
  const auto diceWith = [&](int candidate, const Inside& truth, const ObjectPolicy& policy = {}) {
    query.candidate = candidate;
    const auto model = findObject(volume, query, nullptr, policy);
    REQUIRE(model);
    return diceOf(*model, truth);
  };
  const int whole = diceWith(1, large) > 0.95 ? 1 : 2;
  REQUIRE(diceWith(whole, large) > 0.95);
  SECTION("as the first correction") {
    query.outside.push_back({Vec3(32, 32, 30), {}});
    CHECK(diceWith(whole, small) > 0.9);
    ObjectPolicy none;
    none.core = 10;
    CHECK(diceWith(whole, small, none) < 0.5);
  }
  SECTION("after another one") {  // the small ball is a fiftieth of the large one
    query.outside = {{Vec3(32, 32, 15), {}}, {Vec3(32, 32, 30), {}}};
    ObjectPolicy any;
    any.left = 0;
    CHECK(diceWith(whole, small, any) > 0.9);
    CHECK(diceWith(whole, small) < 0.2);
  }
}

TEST_CASE("once an object has been corrected, a click inside does not add much more than is missing") {
  const Vec3 middle(30, 30, 22);
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 6);
  // A core in a rim, which a wide layer of the same intensities touches.
  const Volume volume = volumeByIndex(cubicGrid(61), [&](int i, int j, int k) {
    const double distance = (Vec3(i, j, k) - middle).norm();
    return (distance < 6 ? 110 : distance < 10 || (k >= 31 && k < 55) ? 70 : 30) + normal(random);
  });
  ObjectPolicy limitless, none;
  limitless.growth = 1e9;
  none.growth = none.growthApart = 0;
  const auto cellsWith = [&](const ObjectQuery& query, const ObjectPolicy& policy) {
    const auto model = findObject(volume, query, nullptr, policy);
    REQUIRE(model);
    return static_cast<double>(model->region.count());
  };
  ObjectQuery query = clickAt(middle);
  query.inside.push_back({Vec3(30, 38, 22), {}});
  const ObjectPolicy policy;
  const double before = cellsWith(query, policy);
  CHECK(cellsWith(query, none) == before);  // the first correction
  query.inside.push_back({Vec3(30, 30, 31), {}});
  // The layer comes with it; the bell and what settles then add to either, or take off.
  const double after = cellsWith(query, policy);
  CHECK(after > before);
  CHECK(after < (1 + policy.growth) * before);
  CHECK(cellsWith(query, limitless) - before > 2 * (after - before));
}

namespace {

//! A ball of three intensities, and another one that touches it.
Volume patchwork() {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 3);
  return volumeByIndex(cubicGrid(52), [&](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const double in = p[0] < 24 ? 40 : p[1] < 24 ? 160 : 200;
    const bool other = inBall(p, Vec3(10, 24, 24), 6);
    return (kBall(p) ? in : other ? 45 : 100) + normal(random);
  });
}

void checkSame(const std::optional<ObjectModel>& a, const std::optional<ObjectModel>& b) {
  REQUIRE((a && b));
  CHECK((a->region.inside == b->region.inside));  // a mismatch is not worth printing
  CHECK(a->chosen == b->chosen);
  CHECK(a->isCloseChoice == b->isCloseChoice);
  CHECK(a->isCorrected == b->isCorrected);
  CHECK(std::array{a->low, a->high, a->rise, a->level, a->noise} ==
        std::array{b->low, b->high, b->rise, b->level, b->noise});
  REQUIRE(a->candidates.size() == b->candidates.size());
  for (std::size_t i = 0; i < a->candidates.size(); ++i) {
    CHECK(a->candidates[i].volume == b->candidates[i].volume);
    CHECK(a->candidates[i].score == b->candidates[i].score);
  }
}

}  // namespace

TEST_CASE("a finder that is asked click by click finds what it would find at once") {
  const Volume volume = patchwork();
  const ObjectClick left{Vec3(19, 24, 24)}, lower{Vec3(30, 19, 24)}, upper{Vec3(30, 30, 24)},
      beside{Vec3(8, 24, 24)};
  const std::vector<ObjectQuery> queries{
      {{left}, {}},
      {{left, lower}, {}},
      {{left, lower}, {beside}},
      {{left, lower, upper}, {beside}},
      {{left, lower}, {}},                      // taken back
      {{left, upper}, {beside}},                // another one
      {{left, lower, upper}, {beside}, 2},      // another candidate
      {{left, lower, upper}, {beside}},         // and the first again
      {{upper}, {}},                            // another object
      {{left}, {beside}, 1, Contrast::bright},  // what is asked for
      {{left, lower, upper}, {beside}},
  };
  ObjectFinder finder;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    INFO("query " << i);
    const auto known = finder.find(volume, queries[i], nullptr),
               anew = findObject(volume, queries[i], nullptr);
    REQUIRE(known.has_value() == anew.has_value());
    if (anew) checkSame(known, anew);
  }
}

TEST_CASE(
    "a click far beyond the cells of the object widens them; what was found before it stays, click by "
    "click") {
  Grid grid = cubicGrid(32);  // three balls along a line of 444 mm
  grid.size[0] = 112;
  grid.spacing = Vec3(4, 1, 1);
  const Vec3 near(60, 16, 16), far(264, 16, 16), farther(408, 16, 16);
  const Volume volume = imageOf(
      grid,
      [&](const Vec3& p) { return inBall(p, near, 12) || inBall(p, far, 12) || inBall(p, farther, 12); }, 40,
      120, 4);
  const ObjectClick first{near}, second{far}, third{farther}, beside{Vec3(60, 16, 5)};
  const std::vector<ObjectQuery> queries{
      {{first}, {}},
      {{first}, {beside}},
      {{first, second}, {beside}},
      {{first, second, third}, {beside}},
      {{first, second}, {beside}},  // taken back
      {{first, third}, {beside}},
      {{first, third, second}, {beside}},
  };
  ObjectFinder finder;
  std::vector<std::size_t> cells;
  for (const ObjectQuery& query : queries) {
    const auto known = finder.find(volume, query, nullptr);
    checkSame(known, findObject(volume, query, nullptr));
    cells.push_back(known->work->cells().count());
    for (const ObjectClick& c : query.inside) {
      const CellGrid& grown = known->work->cells();
      REQUIRE(grown.contains(c.place));
      CHECK(known->region.inside[grown.at(grown.nearest(c.place))] == 1);
    }
    if (known->isCorrected) CHECK(known->start.inside.size() == known->region.inside.size());
  }
  CHECK(cells[1] == cells[0]);
  CHECK(cells[2] > cells[1]);
  CHECK(cells[3] > cells[2]);
  CHECK(cells[4] == cells[2]);
}

TEST_CASE("a finder that gave up finds the same afterwards, and keeps volumes apart") {
  const Volume volume = patchwork(), other = imageOf(cubicGrid(52), kBall, 120, 40, 8);
  const ObjectQuery query{{{Vec3(19, 24, 24)}, {Vec3(30, 19, 24)}}, {{Vec3(8, 24, 24)}}};
  ObjectFinder finder;
  REQUIRE(finder.find(volume, {{query.inside[0]}, {}}, nullptr));
  {
    const std::atomic<bool> cancelled{true};
    const CancelScope scope(cancelled);
    CHECK_THROWS_AS(finder.find(volume, query, nullptr), Cancelled);
  }
  checkSame(finder.find(volume, query, nullptr), findObject(volume, query, nullptr));
  ObjectQuery second{{query.inside[0]}, {}, 2};  // given up while its region is made
  {
    const std::atomic<bool> cancelled{true};
    const CancelScope scope(cancelled);
    CHECK_THROWS_AS(finder.find(volume, second, nullptr), Cancelled);
  }
  checkSame(finder.find(volume, second, nullptr), findObject(volume, second, nullptr));
  checkSame(finder.find(other, query, nullptr), findObject(other, query, nullptr));
  Volume wider = other;  // the same voxels, another spacing
  wider.grid.spacing = Vec3(1, 1, 1.5);
  const ObjectQuery there{{{Vec3(19, 24, 36)}}, {}};
  checkSame(finder.find(wider, there, nullptr), findObject(wider, there, nullptr));
}

TEST_CASE("what a click has changed stays when another one of its side is added, however deep that lies") {
  const Volume volume = patchwork();
  ObjectQuery query = clickAt(Vec3(19, 24, 24));
  query.inside.push_back({Vec3(26, 18, 24)});
  const auto before = findObject(volume, query, nullptr);
  REQUIRE(before);
  const CellGrid& cells = before->work->cells();
  const Region first = findObject(volume, clickAt(Vec3(19, 24, 24)), nullptr)->region;
  // Deeper behind the first surface than the click before, which took it in.
  Vec3 deeper = Vec3::Zero();
  double depth = depthBehindSurface(*before->work, first, cells.at(cells.nearest(query.inside[1].place)));
  for (std::size_t i = 0; i < cells.count(); ++i) {
    if (!before->region.inside[i] || first.inside[i]) continue;
    if (const double d = depthBehindSurface(*before->work, first, i); d > depth)
      depth = d, deeper = placeOf(cells, cells.cellOf(i));
  }
  REQUIRE(deeper != Vec3::Zero());
  query.inside.push_back({deeper});
  const auto after = findObject(volume, query, nullptr);
  REQUIRE(after);
  int others = 0;
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const auto c = cells.cellOf(i);
    const bool isAtClick = (Vec3(c[0], c[1], c[2]) - deeper).norm() <= 1;  // that is inside by definition
    others += !isAtClick && after->region.inside[i] != before->region.inside[i];
  }
  CHECK(others == 0);
}

TEST_CASE("the same clicks give the same object with any number of threads") {
  const Volume volume = imageOf(cubicGrid(49), kBall, 40, 120, 20);
  ObjectQuery query = clickAt(kMiddle);
  query.outside.push_back({Vec3(24, 24, 33), {}});
  const auto one = findObject(volume, query, nullptr);
  query.threads = 3;
  const auto three = findObject(volume, query, nullptr);
  REQUIRE((one && three));
  CHECK(one->region.inside == three->region.inside);
}

TEST_CASE("a click close to the surface of something thick is a close choice, one in its middle is not") {
  const Volume volume = imageOf(cubicGrid(49), kBall, 40, 120, 4);
  const auto middle = findObject(volume, clickAt(kMiddle), nullptr);
  REQUIRE(middle);
  CHECK_FALSE(middle->isCloseChoice);
  CHECK(deepestInside(*middle->work, middle->region) == Approx(11).margin(1));
  const auto surface = findObject(volume, clickAt(kMiddle + Vec3(9, 0, 0)), nullptr);
  REQUIRE(surface);
  REQUIRE(surface->candidates.size() > 1);
  CHECK(surface->isCloseChoice);
}

TEST_CASE("a choice is close where another candidate is expected to fit nearly as well") {
  const auto twoBalls = [](const Vec3& p) {
    const bool neck = std::hypot(p[1] - 24, p[2] - 24) < 3 && std::abs(p[0] - 24) < 12;
    return (p - Vec3(12, 24, 24)).norm() < 9 || (p - Vec3(36, 24, 24)).norm() < 9 || neck;
  };
  const Volume volume = imageOf(cubicGrid(49), twoBalls, 40, 120, 4);
  ObjectPolicy policy;
  policy.sure = policy.thinPart = 0;  // no other reasons
  const ObjectQuery query = clickAt(Vec3(12, 24, 24));
  const auto model = findObject(volume, query, nullptr, policy);
  REQUIRE(model);
  REQUIRE(model->candidates.size() > 1);
  double next = 0;
  for (std::size_t i = 1; i < model->candidates.size(); ++i)
    next = std::max(next, model->candidates[i].score);
  const double behind = model->candidates[0].score - next;
  policy.rival = behind + 0.01;
  CHECK(findObject(volume, query, nullptr, policy)->isCloseChoice);
  policy.rival = behind - 0.01;
  CHECK_FALSE(findObject(volume, query, nullptr, policy)->isCloseChoice);
}
