#include "core/volume/field_of_view.h"

#include "core/volume/not_a_number.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

//! Values that never repeat on a grid of fewer than 16 million voxels.
int unique(int i, int j, int k) { return 1 + i + 200 * j + 40'000 * k; }

std::size_t indexOf(const Grid& g, int i, int j, int k) {
  return static_cast<std::size_t>((k * g.size[1] + j) * g.size[0] + i);
}

bool outsideCircle(int i, int j) { return std::hypot(i - 9.5, j - 9.5) > 9.8; }

}  // namespace

TEST_CASE("an image without a repeated border value has no padding") {
  CHECK(FieldOfView::find(volumeByIndex(cubicGrid(20), unique)) == nullptr);
}

TEST_CASE("padding is exactly what lies outside a circular field of view") {
  const Grid grid = cubicGrid(20);
  const Volume volume =
      volumeByIndex(grid, [](int i, int j, int k) { return outsideCircle(i, j) ? -1000 : unique(i, j, k); });
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) REQUIRE(view->isPadding(indexOf(grid, i, j, k)) == outsideCircle(i, j));
}

TEST_CASE("the padding value inside the image, away from the border, is no padding") {
  const Grid grid = cubicGrid(20);
  const Volume volume = volumeByIndex(grid, [](int i, int j, int k) {
    const bool hole = i == 10 && j == 10 && k == 10;
    return hole || outsideCircle(i, j) ? -1000 : unique(i, j, k);
  });
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  CHECK(view->isPadding(0));
  CHECK_FALSE(view->isPadding(indexOf(grid, 10, 10, 10)));
}

TEST_CASE("padding goes on through passages three voxels wide, not through narrower ones") {
  const Grid grid = cubicGrid(40);
  for (const int width : {1, 2, 3, 4}) {
    // A chamber in the middle, and a passage to it from the padding at the side.
    const auto isDark = [&](int i, int j, int k) {
      const bool chamber = i > 15 && i < 30 && j > 12 && j < 30 && k > 12 && k < 30;
      const bool passage = i < 20 && j >= 20 && j < 20 + width && k >= 20 && k < 20 + width;
      return i < 4 || chamber || passage;
    };
    const Volume volume =
        volumeByIndex(grid, [&](int i, int j, int k) { return isDark(i, j, k) ? 0 : unique(i, j, k); });
    const auto view = FieldOfView::find(volume);
    REQUIRE(view != nullptr);
    CAPTURE(width);
    for (int j = 0; j < 40; ++j)
      for (int k = 0; k < 40; ++k) REQUIRE(view->isPadding(indexOf(grid, 3, j, k)));
    CHECK(view->isPadding(indexOf(grid, 22, 20, 20)) == (width >= 3));
    CHECK(view->isPadding(indexOf(grid, 10, 20, 20)) == (width >= 3));
  }
}

TEST_CASE("along long voxels a passage of padding has no width") {
  Grid grid = cubicGrid(40);
  grid.size[2] = 9;
  const auto isPaddingAt = [&](double spacing) {
    grid.spacing = Vec3(1, 1, spacing);
    const auto view = FieldOfView::find(volumeByIndex(
        grid, [&](int i, int j, int k) { return i < 4 || (k == 4 && i < 20) ? 0 : unique(i, j, k); }));
    return view->isPadding(indexOf(grid, 10, 20, 4));
  };
  CHECK(isPaddingAt(5));
  CHECK_FALSE(isPaddingAt(1));
}

TEST_CASE("padding goes on through faces of voxels, not through edges or corners") {
  const Grid grid = cubicGrid(20);
  const Volume volume = volumeByIndex(grid, [](int i, int j, int k) {
    const bool diagonal = i >= 4 && i < 12 && j >= 8 && k >= 8, slab = i < 4 && (j < 8 || k < 8);
    return slab || (diagonal && j < 15 && k < 15) ? 0 : unique(i, j, k);
  });
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  CHECK(view->isPadding(indexOf(grid, 3, 7, 7)));
  CHECK_FALSE(view->isPadding(indexOf(grid, 4, 8, 8)));
  CHECK_FALSE(view->isPadding(indexOf(grid, 8, 11, 11)));
}

TEST_CASE("padding is exactly what lies outside an ultrasound fan") {
  const Grid grid = cubicGrid(70);  // more than a word of bits
  const auto isOutside = [](int i, int j, int k) {
    const double x = i - 34.5, y = j + 4.0, z = k - 34.5;
    return std::abs(x) > 0.8 * y || std::abs(z) > 0.8 * y || Vec3(x, y, z).norm() > 65;
  };
  const auto view = FieldOfView::find(volumeByIndex(
      grid, [&](int i, int j, int k) { return isOutside(i, j, k) ? 0 : unique(i % 64, j, k); }));
  REQUIRE(view != nullptr);
  std::size_t differ = 0;
  for (int k = 0; k < 70; ++k)
    for (int j = 0; j < 70; ++j)
      for (int i = 0; i < 70; ++i) differ += view->isPadding(indexOf(grid, i, j, k)) != isOutside(i, j, k);
  CHECK(differ == 0);
}

TEST_CASE("a value on fewer border voxels than kMinPadding is no padding, on as many it is") {
  const Grid grid = cubicGrid(10);
  const int border = 10 * 10 * 10 - 8 * 8 * 8;
  const auto withRepeats = [&](int repeats) {
    int left = repeats;
    return volumeByIndex(grid, [&](int i, int j, int k) {
      const bool onBorder = i == 0 || i == 9 || j == 0 || j == 9 || k == 0 || k == 9;
      return onBorder && left-- > 0 ? 0 : unique(i, j, k);
    });
  };
  const int least = static_cast<int>(std::ceil(kMinPadding * border));
  CHECK(FieldOfView::find(withRepeats(least - 1)) == nullptr);
  CHECK(FieldOfView::find(withRepeats(least)) != nullptr);
}

TEST_CASE("of two repeated border values the commoner one is the padding") {
  const Grid grid = cubicGrid(10);
  const Volume volume = volumeByIndex(grid, [](int i, int j, int k) {
    return k == 0 ? 7 : (k == 9 || k == 8) ? 5 : unique(i, j, k);
  });
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  CHECK(view->isPadding(indexOf(grid, 5, 5, 9)));
  CHECK(view->isPadding(indexOf(grid, 5, 5, 8)));
  CHECK_FALSE(view->isPadding(indexOf(grid, 5, 5, 0)));
}

TEST_CASE("padding is found in integer volumes and in volumes of one slice") {
  Grid grid;
  grid.size = {8, 8, 1};
  void* buffer = nullptr;
  const Volume volume = makeVolume(grid, VoxelType::int16, &buffer);
  for (int v = 0; v < 64; ++v) static_cast<std::int16_t*>(buffer)[v] = static_cast<std::int16_t>(v);
  for (int v = 0; v < 16; ++v) static_cast<std::int16_t*>(buffer)[v] = -2000;
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  for (std::size_t v = 0; v < 64; ++v) CHECK(view->isPadding(v) == (v < 16));
}

TEST_CASE("voxels that were not a number are padding wherever they lie, and no others") {
  const Grid grid = cubicGrid(20);
  const auto wasNone = [](int i, int j, int k) { return (i == 10 && j == 10) || k == 3; };
  for (const float least : {1.0F, 0.0F, -1024.0F, 3e-44F}) {
    const float below = notANumberBelow(least);
    REQUIRE(below < least);
    const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
      if (wasNone(i, j, k)) return below;
      return i == 0 && j == 0 && k == 0 ? least : least + 2 + static_cast<float>(unique(i, j, k));
    });
    const auto view = FieldOfView::find(volume);
    REQUIRE(view != nullptr);
    for (int k = 0; k < 20; ++k)
      for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 20; ++i) REQUIRE(view->isPadding(indexOf(grid, i, j, k)) == wasNone(i, j, k));
  }
}

TEST_CASE("a least value next to the second one is no padding") {
  const Grid grid = cubicGrid(20);
  const float least = 1000, next = std::nextafter(least, 2000.0F);
  CHECK(FieldOfView::find(volumeByIndex(grid, [&](int i, int j, int k) {
          if (i == 5) return least;
          return i == 6 ? next : 2000 + static_cast<float>(unique(i, j, k));
        })) == nullptr);
}
