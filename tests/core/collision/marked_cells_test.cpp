#include "core/collision/marked_cells.h"

#include <limits>
#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

Box randomBox(std::mt19937& random, double largest) {
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double x = uniform(), y = uniform(), z = uniform(), a = uniform(), b = uniform();
  const Vec3 low = 100 * Vec3(x, y, z) - Vec3::Constant(50);
  return {low, low + largest * Vec3(a, b, uniform())};
}

}  // namespace

TEST_CASE("every box that meets a marked one may meet it, and few others") {
  std::mt19937 random(5);
  int others = 0, apart = 0;
  for (int round = 0; round < 20; ++round) {
    MarkedCells cells;
    cells.clear(2);
    std::vector<Box> marked;
    for (int i = 0; i < 100; ++i) marked.push_back(randomBox(random, i % 20 == 0 ? 30 : 2));
    for (const Box& box : marked) cells.mark(box);
    for (int i = 0; i < 500; ++i) {
      const Box box = randomBox(random, 2);
      const bool meets =
          std::any_of(marked.begin(), marked.end(), [&](const Box& m) { return m.overlaps(box); });
      if (meets) CHECK(cells.mayMeet(box));
      apart += !meets;
      others += !meets && cells.mayMeet(box);
    }
  }
  CHECK(others < apart / 3);
}

TEST_CASE("boxes that cannot be numbered may meet anything") {
  MarkedCells cells;
  cells.clear(1);
  const Vec3 zero(0, 0, 0);
  CHECK_FALSE(cells.mayMeet({zero, zero}));
  CHECK(cells.mayMeet({zero, Vec3(0, 1e300, 0)}));
  CHECK(cells.mayMeet({Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), zero}));
  cells.mark({zero, Vec3::Constant(std::numeric_limits<double>::infinity())});
  CHECK(cells.mayMeet({zero, zero}));
}
