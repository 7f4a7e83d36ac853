// Balls around clicks outside of the object.

#include <random>

#include "core/object/object_model.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

const Vec3 kMiddle(24, 24, 24), kBeside(39, 24, 24);
constexpr double kRadius = 11;

//! A dark ball in noise.
Volume darkBall() {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 5);
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    return ((Vec3(i, j, k) - kMiddle).norm() < kRadius ? 40 : 120) + normal(random);
  });
}

ObjectModel modelWith(const std::vector<ObjectClick>& outside) {
  const auto model = findObject(darkBall(), {{{kMiddle}}, outside}, nullptr);
  REQUIRE(model);
  return *model;
}

bool holds(const ObjectModel& model, const Vec3& place) {
  const CellGrid& cells = model.work->cells();
  return model.region.inside[cells.at(cells.nearest(place))] != 0;
}

}  // namespace

TEST_CASE("a ball outside corrects the object also where its centre lies outside already") {
  const ObjectModel model = modelWith({{kBeside, 8.0}});
  CHECK(model.isCorrected);
  REQUIRE(model.start.inside.size() == model.region.inside.size());
  CHECK(model.start.count() > model.region.count() + 50);
  CHECK_FALSE(holds(model, kBeside - Vec3(7, 0, 0)));
  CHECK(holds(model, kBeside - Vec3(9, 0, 0)));
}

TEST_CASE("a ball that takes nothing corrects nothing, nor does a mere click outside") {
  const ObjectModel plain = modelWith({});
  for (const ObjectClick& click : {ObjectClick{kBeside, 2.0}, ObjectClick{kBeside, {}}}) {
    const ObjectModel model = modelWith({click});
    CHECK_FALSE(model.isCorrected);
    CHECK(model.region.inside == plain.region.inside);
  }
}
