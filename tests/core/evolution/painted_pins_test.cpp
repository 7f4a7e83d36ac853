// Strokes of the brush over the surface as pins.
#include "core/evolution/painted_pins.h"

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

//! Vertices on a line, 1 mm apart.
std::vector<Vec3> line(int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(i, 0, 0);
  return points;
}

std::vector<int> indices(const std::vector<bool>& flags) {
  std::vector<int> out;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) out.push_back(static_cast<int>(i));
  return out;
}

const std::vector<Vec3> kLine = line(20);
const std::vector<bool> kNone(20, false);

}  // namespace

TEST_CASE("a stroke leaves out the balls that hold nothing of their own, and holds all that it covers",
          "[painted_pins]") {
  const std::vector<WallBall> stroke{{{2, 0, 0}, 2}, {{2.5, 0, 0}, 1.5}, {{4, 9, 0}, 2}, {{5, 0, 0}, 2}};
  const std::vector<Pin> pins = pinsOf(stroke, kLine, kNone, 7);
  REQUIRE(pins == std::vector<Pin>{{{2, 0, 0}, 2, 7}, {{5, 0, 0}, 2, 7}});
  CHECK(indices(heldBy(pins, kLine, kNone, 7)) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
  // What is held already needs no pin.
  CHECK(pinsOf(stroke, kLine, heldBy(pins, kLine, kNone, 7), 7).empty());
  CHECK(pinsOf({{{4, 9, 0}, 2}}, kLine, kNone, 7).empty());
}

TEST_CASE("a vertex that came into the ball of an earlier pin later is not held by it", "[painted_pins]") {
  const std::vector<Pin> pins{{{3, 0, 0}, 1, 5}};
  std::vector<bool> held(20, false);
  held[3] = held[4] = true;  // 2 was elsewhere at iteration 5
  CHECK(indices(heldBy(pins, kLine, held, 9)) == std::vector<int>{3, 4});
  CHECK(indices(heldBy(pins, kLine, held, 5)) == std::vector<int>{2, 3, 4});
  CHECK(heldBy(pins, kLine, held, 4) == kNone);  // not yet
  CHECK(heldBy({}, kLine, held, 9) == kNone);    // lifted
}

TEST_CASE("the eraser takes the pins whose vertices it covers, whole, and no others", "[painted_pins]") {
  const std::vector<Pin> pins{{{2, 0, 0}, 1, 3}, {{4, 0, 0}, 1, 3}, {{12, 0, 0}, 1.4, 3}};
  const std::vector<bool> held = heldBy(pins, kLine, kNone, 3);
  CHECK(unpinned(pins, {{{5, 0, 0}, 0.1}}, kLine, held) == std::vector<Pin>{pins[0], pins[2]});
  CHECK(unpinned(pins, {{{3, 0, 0}, 0.1}}, kLine, held) == std::vector<Pin>{pins[2]});  // of both
  // It reaches into the balls, and meets the surface where nothing is held, or nowhere.
  CHECK(unpinned(pins, {{{13.6, 0, 0}, 0.5}}, kLine, held) == pins);
  CHECK(unpinned(pins, {{{4, 0.9, 0}, 0.5}}, kLine, held) == pins);
}
