#include "core/volume/intensity_statistics.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/volume/not_a_number.h"

namespace handlebody {

namespace {

std::size_t rankAt(double q, std::size_t count) {
  return static_cast<std::size_t>(q * static_cast<double>(count - 1));
}
std::size_t rankOf(double percent, std::size_t count) { return rankAt(percent / 100.0, count); }

template <typename T>
T valueAtRank(std::vector<T>& values, std::size_t rank) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

constexpr std::size_t kFewValues = 100'000;  // counting them takes longer

//! The first 16 bits of a number that is ordered as the values are.
std::size_t leadingBits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.f);  // -0 is 0
  return ((bits >> 31) != 0 ? ~bits : bits | 0x80000000U) >> 16;
}

// Types of one or two bytes have few values: counting them needs no copy of the volume.
template <typename T>
std::vector<double> percentilesByCounting(std::span<const T> voxels, std::span<const double> percents) {
  constexpr int kLowest = std::is_signed_v<T> ? -(1 << (8 * sizeof(T) - 1)) : 0;
  std::vector<std::size_t> counts(std::size_t{1} << (8 * sizeof(T)), 0);
  for (T v : voxels) ++counts[v - kLowest];
  std::vector<double> result;
  for (double percent : percents) {
    const std::size_t rank = rankOf(percent, voxels.size());
    std::size_t value = 0;
    for (std::size_t below = counts[0]; below <= rank; below += counts[value]) ++value;
    result.push_back(static_cast<double>(value) + kLowest);
  }
  return result;
}

template <typename T>
std::vector<double> percentilesBySelection(std::vector<T> values, std::span<const double> percents) {
  std::vector<double> result;
  for (double percent : percents)
    result.push_back(static_cast<double>(valueAtRank(values, rankOf(percent, values.size()))));
  return result;
}

//! But for the percentiles.
template <typename T>
IntensityStatistics rangeAndMean(std::span<const T> values) {
  IntensityStatistics s;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  s.minimum = static_cast<double>(*low);
  s.maximum = static_cast<double>(*high);
  double sum = 0;
  for (T v : values) sum += static_cast<double>(v);
  s.mean = sum / static_cast<double>(values.size());
  return s;
}

template <typename T>
IntensityStatistics statisticsOf(std::span<const T> voxels, std::span<const double> percents) {
  if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
    IntensityStatistics s = rangeAndMean(voxels);
    s.percentiles = percentilesByCounting(voxels, percents);
    return s;
  } else {
    std::vector<T> values(voxels.begin(), voxels.end());
    if (const std::optional<T> none = notANumberIn(voxels.data(), voxels.size())) std::erase(values, *none);
    IntensityStatistics s = rangeAndMean(std::span<const T>(values));
    s.percentiles = percentilesBySelection(std::move(values), percents);
    return s;
  }
}

}  // namespace

IntensityStatistics intensityStatistics(const Volume& volume, std::span<const double> percents) {
  return visitVoxels(volume, [&](const auto* voxels) {
    return statisticsOf(std::span(voxels, volume.grid.voxelCount()), percents);
  });
}

double quantile(std::vector<double> values, double q) {
  return valueAtRank(values, rankAt(q, values.size()));
}
double quantile(std::vector<float> values, double q) {
  // Counted first by their leading bits: only values that share these with the one that is looked for are
  // left.
  const std::size_t rank = rankAt(q, values.size());
  if (values.size() < kFewValues) return static_cast<double>(valueAtRank(values, rank));
  std::vector<std::size_t> counts(std::size_t{1} << 16, 0);
  for (const float v : values) ++counts[leadingBits(v)];
  std::size_t leading = 0, below = 0;
  while (below + counts[leading] <= rank) below += counts[leading++];
  std::erase_if(values, [&](float v) { return leadingBits(v) != leading; });
  return static_cast<double>(valueAtRank(values, rank - below));
}

}  // namespace handlebody
