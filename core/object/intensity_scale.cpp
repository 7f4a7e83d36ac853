#include "core/object/intensity_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

constexpr std::size_t kFewest = 100;  // cells of an octave that tell its noise

//! Of the cells that have six neighbours: their neighbours' mean, and how far (absolute) they are from it.
struct Residuals {
  std::vector<double> mean, distance;
};

Residuals residualsOf(const CellImage& image) {
  Residuals out;
  const auto& n = image.cells.grid.size;
  const std::array<std::size_t, 3> steps{1, static_cast<std::size_t>(n[0]),
                                         static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1])};
  for (int z = 1; z + 1 < n[2]; ++z)
    for (int y = 1; y + 1 < n[1]; ++y)
      for (int x = 1; x + 1 < n[0]; ++x) {
        const std::size_t i = image.cells.at(x, y, z);
        if (image.padding[i]) continue;
        double sum = 0;
        for (const std::size_t s : steps)
          sum += static_cast<double>(image.values[i - s]) + static_cast<double>(image.values[i + s]);
        out.mean.push_back(sum / 6);
        out.distance.push_back(std::abs(image.values[i] - sum / 6));
      }
  return out;
}

}  // namespace

IntensityScale IntensityScale::of(const CellImage& image, const ObjectPolicy& policy) {
  const Residuals cells = residualsOf(image);
  if (cells.mean.size() < kFewest) return {};
  const double low = *std::min_element(cells.mean.begin(), cells.mean.end());
  const double top = quantile(cells.mean, 1 - policy.logTop) - low;
  if (!(top > 0)) return {};
  constexpr std::size_t kOctaves = 4;
  std::array<std::vector<double>, kOctaves> octaves;
  for (std::size_t i = 0; i < cells.mean.size(); ++i) {
    const double below = std::floor(std::log2(top / std::max(cells.mean[i] - low, top * 1e-6)));
    if (below >= 0 && below < kOctaves) octaves[static_cast<int>(below)].push_back(cells.distance[i]);
  }
  const double highest = static_cast<double>(octaves[0].size()) / static_cast<double>(cells.mean.size());
  if (highest > policy.logPlateau) return {};
  double above = std::numeric_limits<double>::infinity();
  for (std::vector<double>& octave : octaves) {
    if (octave.size() < kFewest) return {};
    const double noise = quantile(std::move(octave), 0.5);
    if (!(noise > 0) || above < policy.logGrowth * noise) return {};
    above = noise;
  }
  IntensityScale out;
  out.low_ = low;
  out.offset_ = policy.logFloor * top;
  return out;
}

double IntensityScale::to(double intensity) const {
  // Nothing of interest lies below the floor, and a logarithm must have something to take.
  return isLogarithmic() ? std::log(std::max(intensity - low_, -0.5 * offset_) + offset_) : intensity;
}

double IntensityScale::from(double scaled) const {
  return isLogarithmic() && std::isfinite(scaled) ? std::exp(scaled) - offset_ + low_ : scaled;
}

void IntensityScale::apply(std::vector<float>& intensities) const {
  if (!isLogarithmic()) return;
  for (float& v : intensities) v = static_cast<float>(to(v));
}

}  // namespace handlebody
