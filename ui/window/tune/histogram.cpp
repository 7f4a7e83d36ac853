#include "ui/window/tune/histogram.h"

#include <algorithm>
#include <cmath>

namespace handlebody::ui {

namespace {

constexpr std::size_t kSamples = 2'000'000;
constexpr double kTail = 0.001;

std::vector<float> samplesOf(const Volume& volume) {
  const std::size_t count = volume.grid.voxelCount();
  std::size_t stride = std::max<std::size_t>(1, count / kSamples);
  // Not a divisor of a row, or whole columns would be left out.
  if (stride > 1 && static_cast<std::size_t>(volume.grid.size[0]) % stride == 0) ++stride;
  std::vector<float> samples;
  samples.reserve(count / stride + 1);
  visitVoxels(volume, [&](const auto* voxels) {
    for (std::size_t i = 0; i < count; i += stride) samples.push_back(static_cast<float>(voxels[i]));
  });
  return samples;
}

double nthOf(std::vector<float>& samples, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size() - 1));
  std::nth_element(samples.begin(), samples.begin() + rank, samples.end());
  return samples[rank];
}

bool isWhole(VoxelType type) { return type != VoxelType::float32 && type != VoxelType::float64; }

}  // namespace

Histogram histogramOf(const Volume& volume, int bins) {
  std::vector<float> samples = samplesOf(volume);
  Histogram histogram;
  histogram.low = nthOf(samples, kTail);
  histogram.high = std::max(nthOf(samples, 1 - kTail), std::nextafter(histogram.low, HUGE_VAL));
  histogram.whole = isWhole(volume.type);
  if (histogram.whole) {
    histogram.low -= 0.5;
    const double width = std::max(1.0, std::ceil((histogram.high + 0.5 - histogram.low) / bins));
    bins = std::max(1, static_cast<int>(std::ceil((histogram.high + 0.5 - histogram.low) / width)));
    histogram.high = histogram.low + width * bins;
  }
  histogram.counts.assign(bins, 0);
  const double scale = bins / (histogram.high - histogram.low);
  for (float sample : samples) {
    const auto bin = static_cast<int>(std::clamp((sample - histogram.low) * scale, 0.0, bins - 1.0));
    histogram.counts[bin] += 1;
  }
  return histogram;
}

}  // namespace handlebody::ui
