#include "core/volume/border_region.h"

#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("rows that are set whole are those set voxel by voxel, and their runs hold exactly what is in") {
  const int width = GENERATE(1, 61, 62, 63, 64, 125, 126, 127, 200);
  const int share = GENERATE(0, 1, 2, 30, 100);  // one voxel of so many is out
  CAPTURE(width, share);
  const std::array<int, 3> size{width, 3, 2};
  std::mt19937 random(static_cast<unsigned>(width));
  std::vector<int> isIn;
  for (int i = 0; i < width; ++i)
    isIn.push_back(share == 1 || (share > 1 && random() % static_cast<unsigned>(share) != 0));
  VoxelBits rows(size, true), single(size, true);
  rows.setRow(1, 1, [&](int i) { return isIn[i] != 0; });
  for (int i = 0; i < width; ++i)
    if (isIn[i]) single.set(i, 1, 1);
  std::vector<int> found(width, 0);
  int last = -1;
  rows.forEachRun(1, 1, [&](int first, int end) {
    REQUIRE(first > last);  // with a gap between them
    REQUIRE(end > first);
    REQUIRE(end <= width);
    last = end;
    for (int i = first; i < end; ++i) found[i] = 1;
  });
  CHECK(found == isIn);
  for (int i = 0; i < width; ++i) CHECK(rows.test(i, 1, 1) == single.test(i, 1, 1));
  rows.forEachRun(0, 1, [](int, int) { FAIL("another row"); });
  CHECK(rows.test(-1, 1, 1));
  CHECK(rows.test(width, 1, 1));

  VoxelBits none(size, false);
  rows &= none;
  rows.forEachRun(1, 1, [](int, int) { FAIL("nothing is in both"); });
}
