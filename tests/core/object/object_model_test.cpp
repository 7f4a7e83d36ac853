#include "core/object/object_model.h"

#include <random>

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
  const CellGrid& cells = model.work.cells();
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
  const CellGrid& cells = model->work.cells();
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
  CHECK(deepestInside(middle->work, middle->region) == Approx(11).margin(1));
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
