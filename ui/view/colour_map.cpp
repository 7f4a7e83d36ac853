#include "ui/view/colour_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handlebody::ui {
namespace {

using Rgb = std::array<double, 3>;  // 0 … 255

std::uint32_t packed(const Rgb& c) {
  std::uint32_t value = 0xff;
  for (double channel : c) value = value << 8 | static_cast<std::uint32_t>(std::lround(channel));
  return value;
}

//! Linear between stops that are evenly spaced.
ColourTable tableOf(const std::vector<Rgb>& stops) {
  ColourTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double x = static_cast<double>(i) / 255 * static_cast<double>(stops.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(x), stops.size() - 2);
    const double t = x - static_cast<double>(low);
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = (1 - t) * stops[low][c] + t * stops[low + 1][c];
    table[i] = packed(mixed);
  }
  return table;
}

}  // namespace

const ColourTable& colourTable(ColourMap map) {
  static const Rgb kBlack{0, 0, 0}, kWhite{255, 255, 255};
  static const ColourTable grey = tableOf({kBlack, kWhite}), inverted = tableOf({kWhite, kBlack});
  static const ColourTable hot = tableOf({kBlack, {230, 0, 0}, {255, 210, 0}, kWhite});
  static const ColourTable contrast = tableOf({kBlack,
                                               {45, 15, 105},
                                               {35, 70, 185},
                                               {0, 140, 175},
                                               {30, 180, 95},
                                               {150, 205, 40},
                                               {250, 225, 60},
                                               kWhite});
  switch (map) {
    case ColourMap::inverted:
      return inverted;
    case ColourMap::hot:
      return hot;
    case ColourMap::contrast:
      return contrast;
    default:
      return grey;
  }
}

int WindowLevel::entry(double intensity) const {
  const double part = (intensity - level) / window + 0.5;
  return static_cast<int>(std::clamp(part * 256, 0.0, 255.0));
}

WindowLevel draggedWindow(const WindowLevel& start, double dx, double dy) {
  constexpr double kPixels = 250;
  return {start.window * std::exp(dx / kPixels), start.level + start.window * dy / kPixels};
}

IntensityRange displayRange(const Volume& volume) {
  constexpr std::size_t kSamples = 1 << 20;
  const std::size_t count = volume.grid.voxelCount();
  std::vector<double> sample;
  visitVoxels(volume, [&](const auto* voxels) {
    // An irrational share of the voxels between two samples: no row or slice is met again and again.
    const double stride = count <= kSamples ? 1 : M_SQRT2 * static_cast<double>(count) / kSamples;
    for (double at = 0; at < static_cast<double>(count); at += stride) {
      const auto voxel = static_cast<std::size_t>(at);
      sample.push_back(static_cast<double>(voxels[voxel]));
    }
  });
  const auto rank = [&](double share) {
    const auto nth =
        sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), nth, sample.end());
    return *nth;
  };
  return {rank(0.001), rank(0.999)};
}

WindowLevel windowOver(const IntensityRange& range) {
  const double width = range.high - range.low;
  return {width > 0 ? width : 1, (range.low + range.high) / 2};
}

}  // namespace handlebody::ui
