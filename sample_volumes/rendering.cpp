#include "sample_volumes/rendering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "core/errors.h"
#include "sample_volumes/noise.h"

namespace handlebody::phantoms {
namespace {

const Vec3 kPointSpread(1.5, 1.5, 0.7);  // mm: lateral, elevational, axial

// Intensities of object and background, and what the type can hold.
struct Scale {
  double object, background, low, high;
};

Scale scaleOf(VoxelType type) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  switch (type) {
    case VoxelType::uint8:
      return {60, 180, 0, 255};
    case VoxelType::int16:
      return {-200, 800, -32768, 32767};
    case VoxelType::float32:
      return {0.25, 0.75, -kLargest, kLargest};
    default:
      throw UsageError(
          std::string("The phantom's voxel type (--type) must be uint8, int16 or float32, not ") +
          voxelTypeName(type) + ".");
  }
}

template <typename T>
void quantize(const std::vector<float>& signal, const Scale& scale, T* out) {
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double value = scale.object + signal[i] * (scale.background - scale.object);
    const double rounded = std::is_integral_v<T> ? std::floor(value + 0.5) : value;
    out[i] = static_cast<T>(std::clamp(rounded, scale.low, scale.high));
  }
}

}  // namespace

double coveredPart(double d, const Vec3& normal, const Vec3& spacing) {
  const double width =
      std::sqrt(5.0 / 3) * normal.cwiseProduct(spacing).norm();  // 5/3: variance 1/20 to 1/12
  const double t = std::clamp(0.5 - d / width, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

void addNoise(NoiseKind kind, const Grid& grid, double deviation, std::uint64_t seed,
              std::vector<float>& signal) {
  if (kind == NoiseKind::white) {
    for (std::size_t i = 0; i < signal.size(); ++i)
      signal[i] += static_cast<float>(deviation * normalPair(seed, i).first);
    return;
  }
  const std::vector<float> envelope = speckleEnvelope(grid, kPointSpread, seed);
  for (std::size_t i = 0; i < signal.size(); ++i)
    signal[i] = static_cast<float>(
        std::clamp(signal[i] + deviation * compressedSpeckle(envelope[i]), kDisplayLow, kDisplayHigh));
}

void requirePhantomType(VoxelType type) { scaleOf(type); }

Volume toVolume(const Grid& grid, VoxelType type, const std::vector<float>& signal) {
  const Scale scale = scaleOf(type);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, type, &buffer);
  if (type == VoxelType::uint8) quantize(signal, scale, static_cast<std::uint8_t*>(buffer));
  if (type == VoxelType::int16) quantize(signal, scale, static_cast<std::int16_t*>(buffer));
  if (type == VoxelType::float32) quantize(signal, scale, static_cast<float*>(buffer));
  return volume;
}

}  // namespace handlebody::phantoms
