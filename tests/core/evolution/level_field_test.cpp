#include "core/evolution/level_field.h"

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;

namespace {

const Vec3 kLeft(8, 32, 32), kRight(56, 32, 32);

//! Near the left end of a volume of 65³ voxels 10, near the right one 30.
LevelField betweenTwoSamples(double leftWeight = 1, double rightWeight = 1) {
  LevelField::Samples samples(cubicGrid(65));
  samples.add(kLeft, 10, leftWeight);
  samples.add(kRight, 30, rightWeight);
  return samples.spread();
}

}  // namespace

TEST_CASE("a constant level field has its level everywhere, outside of the volume too") {
  const LevelField field(cubicGrid(20), 42);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(7.3, 2, 19), Vec3(-50, 200, 3)}) CHECK(field.at(p) == 42);
  CHECK(field.lowest() == 42);
  CHECK(field.highest() == 42);
}

TEST_CASE("samples of one level spread to that level everywhere") {
  LevelField::Samples samples(cubicGrid(65));
  samples.add(Vec3(3, 5, 60), 7, 0.5);
  samples.add(Vec3(40, 20, 10), 7, 100);
  const LevelField field = samples.spread();
  CHECK(field.lowest() == Approx(7));
  CHECK(field.highest() == Approx(7));
}

TEST_CASE("a level field has the level of a sample near it and passes from one to the other between them") {
  const LevelField field = betweenTwoSamples();
  CHECK(field.at(kLeft) == Approx(10).margin(1));
  CHECK(field.at(kRight) == Approx(30).margin(1));
  CHECK(field.at(0.5 * (kLeft + kRight)) == Approx(20).margin(1e-9));  // by symmetry
  double last = field.at(kLeft);
  for (int x = 9; x <= 56; ++x) {
    const double level = field.at(Vec3(x, 32, 32));
    CHECK(level >= last - 1e-12);
    last = level;
  }
}

TEST_CASE("where there are no samples, a level field has the level of the nearest ones") {
  LevelField::Samples samples(cubicGrid(129));
  samples.add(Vec3(0, 0, 0), 10, 1);
  samples.add(Vec3(24, 0, 0), 30, 1);
  const LevelField field = samples.spread();
  CHECK(field.at(Vec3(0, 16, 16)) < 15);
  CHECK(field.at(Vec3(24, 16, 16)) > 25);
  CHECK(field.at(Vec3(128, 128, 128)) >= 10);
  CHECK(field.at(Vec3(128, 128, 128)) <= 30);
}

TEST_CASE("what is near decides about a level, however much weight there is far away") {
  LevelField::Samples samples(cubicGrid(129));
  samples.add(Vec3(0, 64, 64), 10, 1);
  samples.add(Vec3(96, 64, 64), 30, 100);
  CHECK(samples.spread().at(Vec3(0, 64, 64)) == Approx(10).margin(1));
}

TEST_CASE("samples at one place count with their weights") {
  LevelField::Samples samples(cubicGrid(17));
  samples.add(Vec3(8, 8, 8), 10, 1);
  samples.add(Vec3(8, 8, 8), 30, 3);
  CHECK(samples.spread().at(Vec3(8, 8, 8)) == Approx(25));
}

TEST_CASE("a heavier sample draws the middle to its level") {
  const Vec3 middle = 0.5 * (kLeft + kRight);
  CHECK(betweenTwoSamples(1, 4).at(middle) == Approx(26));  // (10 + 4 · 30) / 5
}

TEST_CASE("there are no samples until one has a weight") {
  LevelField::Samples samples(cubicGrid(17));
  CHECK(samples.empty());
  samples.add(Vec3(8, 8, 8), 10, 0);
  CHECK(samples.empty());
  samples.add(Vec3(8, 8, 8), 10, 1);
  CHECK_FALSE(samples.empty());
}

TEST_CASE("a level field is the same bit for bit each time") {
  const LevelField a = betweenTwoSamples(0.3, 0.7), b = betweenTwoSamples(0.3, 0.7);
  for (double x = 0; x < 64; x += 0.37)
    CHECK(a.at(Vec3(x, 0.5 * x, 64 - x)) == b.at(Vec3(x, 0.5 * x, 64 - x)));
}

TEST_CASE("a field part of the way between two lies there at every place") {
  const Grid grid = cubicGrid(65);
  const LevelField one(grid, 50), other = betweenTwoSamples();
  const LevelField onward = LevelField::between(one, other, 0.25),
                   back = LevelField::between(other, one, 0.75);
  for (const Vec3& p : {kLeft, kRight, Vec3(30, 10, 50)}) {
    CHECK(onward.at(p) == Approx(50 + 0.25 * (other.at(p) - 50)));
    CHECK(back.at(p) == Approx(onward.at(p)));
  }
}

TEST_CASE("a level field is in millimetres as wide along coarse axes as along fine ones") {
  Grid coarse = cubicGrid(65);
  coarse.size = {65, 65, 17};
  coarse.spacing = Vec3(1, 1, 4);
  LevelField::Samples samples(coarse);
  samples.add(Vec3(0, 0, 0), 10, 1);
  samples.add(Vec3(64, 64, 16), 30, 1);
  const LevelField field = samples.spread();
  CHECK(field.at(Vec3(40, 0, 0)) == Approx(field.at(Vec3(0, 0, 10))).margin(1e-9));
}
