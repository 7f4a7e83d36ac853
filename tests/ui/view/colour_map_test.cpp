#include "ui/view/colour_map.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

double channel(std::uint32_t colour, int c) { return colour >> (16 - 8 * c) & 0xffU; }

//! Rec. 601.
double luminance(std::uint32_t c) {
  return 0.299 * channel(c, 0) + 0.587 * channel(c, 1) + 0.114 * channel(c, 2);
}

//! How many differences of colour lie between the ends of a map.
double pathLength(const ColourTable& table) {
  double sum = 0;
  for (std::size_t i = 1; i < table.size(); ++i) {
    double square = 0;
    for (int c = 0; c < 3; ++c) square += std::pow(channel(table[i], c) - channel(table[i - 1], c), 2);
    sum += std::sqrt(square);
  }
  return sum;
}

}  // namespace

TEST_CASE("Grey, hot and contrast run from black to white and never grow darker", "[colour_map]") {
  for (ColourMap map : {ColourMap::grey, ColourMap::hot, ColourMap::contrast}) {
    const ColourTable& table = colourTable(map);
    CHECK(table.front() == 0xff000000);
    CHECK(table.back() == 0xffffffff);
    // Channels are rounded to integers: half a unit each.
    for (std::size_t i = 1; i < table.size(); ++i) CHECK(luminance(table[i]) >= luminance(table[i - 1]) - 1);
  }
}

TEST_CASE("The inverted map is the grey one turned round", "[colour_map]") {
  for (std::size_t i = 0; i < 256; ++i)
    CHECK(colourTable(ColourMap::inverted)[i] == colourTable(ColourMap::grey)[255 - i]);
}

TEST_CASE("The contrast map has more differences of colour than grey", "[colour_map]") {
  CHECK(pathLength(colourTable(ColourMap::contrast)) > 1.5 * pathLength(colourTable(ColourMap::grey)));
}

TEST_CASE("A drag to the right widens the window, and back restores it", "[window_level]") {
  const WindowLevel start{200, 40};
  const WindowLevel wider = draggedWindow(start, 250, 0);
  CHECK(wider.window == Approx(200 * std::exp(1.0)));
  CHECK(wider.level == 40);
  CHECK(draggedWindow(wider, -250, 0).window == Approx(200));
  CHECK(draggedWindow(start, -1e4, 0).window > 0);
}

TEST_CASE("A drag upwards makes the picture brighter", "[window_level]") {
  CHECK(draggedWindow({200, 40}, 0, -50).level < 40);
}

TEST_CASE("The automatic window leaves out a thousandth at each end", "[window_level]") {
  Grid grid;
  grid.size = {100, 100, 1};
  const IntensityRange range =
      displayRange(handlebody::testing::volumeByIndex(grid, [](int i, int j, int) { return i + 100 * j; }));
  CHECK(range.low == Approx(10).margin(1));
  CHECK(range.high == Approx(9989).margin(1));
}

TEST_CASE("The automatic window of a large volume is that of all its voxels", "[window_level]") {
  Grid grid;
  grid.size = {256, 256, 64};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1000);
  const Volume volume =
      handlebody::testing::volumeByIndex(grid, [&](int, int, int) { return uniform(random); });
  const IntensityRange range = displayRange(volume);
  // Of n samples the share below the 0.1 percentile is off by sqrt(0.001 / n): 3e-5, or 0.03 of 1000; five
  // times that.
  CHECK(range.low == Approx(1).margin(0.2));
  CHECK(range.high == Approx(999).margin(0.2));
}

TEST_CASE("A volume of one intensity has a window about it", "[window_level]") {
  Grid grid;
  grid.size = {4, 4, 4};
  const WindowLevel window =
      windowOver(displayRange(handlebody::testing::volumeByIndex(grid, [](int, int, int) { return 42; })));
  CHECK(window.window > 0);
  CHECK(window.level == 42);
}
