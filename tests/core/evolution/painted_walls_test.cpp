// Strokes of the brush as walls.
#include "core/evolution/painted_walls.h"

#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! How far a place on the way of the brush lies in the balls at least; negative if it lies in none.
double depth(const Vec3& p, const std::vector<WallBall>& balls) {
  double deepest = -1e300;
  for (const WallBall& b : balls) deepest = std::max(deepest, b.radius - (p - b.centre).norm());
  return deepest;
}

}  // namespace

TEST_CASE("a stroke is a chain of balls half a radius apart, as thick as the brush but for 4 %",
          "[painted]") {
  constexpr double kRadius = 3;
  std::vector<WallBall> stroke;
  const std::vector<Vec3> way{{0, 0, 0}, {0.4, 0, 0}, {10, 0, 0}, {10, 7, 0}, {3, 2, 5}};
  for (const Vec3& p : way) drawTo(stroke, p, kRadius);
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    CHECK(stroke[i].radius == kRadius);
    CHECK((stroke[i].centre - stroke[i - 1].centre).norm() <= kRadius / 2 + 1e-12);
  }
  // The length of the way over half a radius.
  CHECK(stroke.size() <= 2 + static_cast<std::size_t>((10 + 7 + std::sqrt(49 + 25 + 25)) / (kRadius / 2)));
  // Of the straight part to its last ball: what the brush swept is within, beside it as on it.
  for (double x = 0; x < 9; x += 0.05) CHECK(depth(Vec3(x, 0, 0.96 * kRadius), stroke) >= 0);
}

TEST_CASE("a brush that stands still or returns adds next to no balls", "[painted]") {
  WallList walls;
  for (int pass = 0; pass < 20; ++pass) {
    std::vector<WallBall> stroke;
    drawTo(stroke, Vec3(0.1 * (pass % 3), 0, 0), 2);
    drawTo(stroke, Vec3(20, 0.1 * (pass % 3), 0), 2);
    walls = painted(std::move(walls), stroke);
  }
  CHECK(walls.balls.size() <= 2 * 21);  // one pass: 21
  CHECK(painted(walls, {{{10, 9, 0}, 2}}).balls.size() == walls.balls.size() + 1);
}

TEST_CASE("what stands out of a wall that is there is added to it", "[painted]") {
  WallList walls;
  walls.balls = {{{0, 0, 0}, 4}};
  CHECK(painted(walls, {{{1, 0, 0}, 2}}).balls.size() == 1);    // within
  CHECK(painted(walls, {{{2.4, 0, 0}, 2}}).balls.size() == 1);  // by a fifth of its radius
  CHECK(painted(walls, {{{3, 0, 0}, 2}}).balls.size() == 2);
  CHECK(painted(walls, {{{0, 0, 0}, 6}}).balls.size() == 2);  // larger
}

TEST_CASE("the eraser takes the balls and discs that it touches, and no others", "[painted]") {
  WallList walls;
  walls.balls = {{{0, 0, 0}, 2}, {{5, 0, 0}, 2}, {{20, 0, 0}, 2}};
  walls.discs = {{{0, 10, 0}, {0, 1, 0}, 3}, {{0, 10, 0}, {0, 0, 1}, 3}};
  CHECK(erased(walls, {{{8.1, 0, 0}, 1}}) == walls);
  const WallList one = erased(walls, {{{7.9, 0, 0}, 1}});
  CHECK(one.balls.size() == 2);
  CHECK(one.balls[1].centre.x() == 20);
  const WallList disc = erased(walls, {{{0, 8, 0}, 1}});  // 2 mm from the one, 1 mm within the other
  REQUIRE(disc.discs.size() == 1);
  CHECK(disc.discs[0].normal == Vec3(0, 1, 0));
  CHECK(erased(walls, {{{0, 0, 0}, 100}}).empty());
}

TEST_CASE("only what reaches into the volume is kept, and a seed keeps its room", "[painted]") {
  const Grid grid = cubicGrid(10);  // from -0.5 to 9.5
  const auto kept =
      reachingInto(grid, {{{-2.4, 5, 5}, 2}, {{-2.6, 5, 5}, 2}, {{5, 5, 5}, 1}, {{-2, -2, 5}, 2}});
  REQUIRE(kept.size() == 2);
  CHECK(kept[0].centre.x() == -2.4);
  const std::vector<Seed> seeds{{{5, 5, 5}, 3.0, true}, {{8, 5, 5}, {}}};
  CHECK(coveredSeed(seeds, {{{5, 5, 5}, 1}}, 0.5) == -1);  // a click outside may lie in one
  CHECK(coveredSeed(seeds, {{{5, 5, 5}, 2.6}}, 0.5) == 1);
  CHECK(coveredSeed(seeds, {{{5, 5, 5}, 2.4}}, 0.5) == -1);
}
