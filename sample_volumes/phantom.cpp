#include "sample_volumes/phantom.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/errors.h"
#include "sample_volumes/noise.h"
#include "sample_volumes/placement.h"
#include "sample_volumes/shapes.h"

namespace handlebody {
namespace phantoms {
namespace {

const Vec3 kPointSpread(1.5, 1.5, 0.7);  // mm: lateral, elevational, axial
constexpr double kDisplayLow = -0.5;     // grey 0 and 255 of the uint8 scale, in contrasts above the object
constexpr double kDisplayHigh = 1.625;

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

// Part of the voxel at p that is dark, for a signed distance d. A voxel's width along the unit normal n has
// the variance sum(n_a² h_a²)/12 whatever n is; the smooth step has that variance too, and is 1/2 at distance
// 0.
double coverage(const Shape& shape, const Hole& hole, const Vec3& spacing, const Vec3& p, double d) {
  const double widest = std::sqrt(5.0 / 3) * spacing.maxCoeff();
  if (std::abs(d) >= widest / 2) return d < 0 ? 1 : 0;
  constexpr double kStep = 1e-3;  // mm
  Vec3 normal;
  for (int a = 0; a < 3; ++a)
    normal[a] = darkDistance(shape, hole, p + kStep * Vec3::Unit(a)) -
                darkDistance(shape, hole, p - kStep * Vec3::Unit(a));
  normal.normalize();
  const double width =
      std::sqrt(5.0 / 3) * normal.cwiseProduct(spacing).norm();  // 5/3: variance 1/20 to 1/12
  const double t = std::clamp(0.5 - d / width, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Smooth gain; over the phantom's own extent its largest value is `bias` times its smallest one.
double gainAt(const Shape& shape, const Vec3& p, double bias) {
  const double along = 2 * p.cwiseQuotient(shape.extent).sum() / 3;  // -1 … 1 from corner to corner
  return std::pow(bias, 0.5 * std::sin(std::numbers::pi / 2 * std::clamp(along, -1.0, 1.0)));
}

// Noise-free intensity in contrasts: 0 = object, 1 = background.
double signalAt(const Shape& shape, const Hole& hole, const Vec3& spacing, double bias, const Vec3& p,
                double d) {
  double signal = 1 - coverage(shape, hole, spacing, p, d);
  if (shape.brightness && signal > 0) signal *= shape.brightness(p);
  signal -= shape.depthLoss * p.z() / shape.extent.z();
  if (bias != 1) signal = kDisplayLow + (signal - kDisplayLow) * gainAt(shape, p, bias);
  return signal;
}

// The noise-free volume in contrasts, and the truth label.
std::vector<float> renderSignal(const Shape& shape, const Placement& place, double bias,
                                std::uint8_t* truth) {
  std::vector<float> signal(place.grid.voxelCount());
  const Vec3& spacing = place.grid.spacing;
  std::size_t i = 0;
  for (int z = 0; z < place.grid.size[2]; ++z)
    for (int y = 0; y < place.grid.size[1]; ++y)
      for (int x = 0; x < place.grid.size[0]; ++x, ++i) {
        const Vec3 p = Vec3(x, y, z).cwiseProduct(spacing) + place.corner;
        const double d = darkDistance(shape, place.hole, p);
        signal[i] = static_cast<float>(signalAt(shape, place.hole, spacing, bias, p, d));
        truth[i] = (shape.dark ? shape.distance(p) : d) < 0;
      }
  return signal;
}

void addNoise(const Shape& shape, const Grid& grid, double noise, std::uint64_t seed,
              std::vector<float>& signal) {
  if (!shape.speckle) {
    for (std::size_t i = 0; i < signal.size(); ++i)
      signal[i] += static_cast<float>(noise * normalPair(seed, i).first);
    return;
  }
  const std::vector<float> envelope = speckleEnvelope(grid, kPointSpread, seed);
  for (std::size_t i = 0; i < signal.size(); ++i)
    signal[i] = static_cast<float>(
        std::clamp(signal[i] + noise * compressedSpeckle(envelope[i]), kDisplayLow, kDisplayHigh));
}

template <typename T>
void quantize(const std::vector<float>& signal, const Scale& scale, T* out) {
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double value = scale.object + signal[i] * (scale.background - scale.object);
    const double rounded = std::is_integral_v<T> ? std::floor(value + 0.5) : value;
    out[i] = static_cast<T>(std::clamp(rounded, scale.low, scale.high));
  }
}

Volume toVolume(const Grid& grid, VoxelType type, const std::vector<float>& signal) {
  const Scale scale = scaleOf(type);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, type, &buffer);
  if (type == VoxelType::uint8) quantize(signal, scale, static_cast<std::uint8_t*>(buffer));
  if (type == VoxelType::int16) quantize(signal, scale, static_cast<std::int16_t*>(buffer));
  if (type == VoxelType::float32) quantize(signal, scale, static_cast<float*>(buffer));
  return volume;
}

}  // namespace
}  // namespace phantoms

const std::vector<std::string>& phantomNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const phantoms::Shape& shape : phantoms::allShapes()) all.push_back(shape.name);
    return all;
  }();
  return names;
}

Phantom makePhantom(const std::string& name, const PhantomOptions& options) {
  const phantoms::Shape& shape = phantoms::findShape(name);
  const phantoms::Placement place = phantoms::placeShape(shape, options);
  phantoms::scaleOf(options.type);  // refuses a type before the work
  Phantom phantom;
  phantom.name = name;
  void* truth = nullptr;
  phantom.truth = makeVolume(place.grid, VoxelType::uint8, &truth);
  std::vector<float> signal =
      phantoms::renderSignal(shape, place, options.bias, static_cast<std::uint8_t*>(truth));
  const double noise = options.noise < 0 ? shape.noise : options.noise;
  if (noise > 0) phantoms::addNoise(shape, place.grid, noise, options.randomSeed, signal);
  phantom.volume = phantoms::toVolume(place.grid, options.type, signal);
  phantom.seed = place.toWorld(shape.seed);
  phantom.seedRadius = shape.seedRadius;
  phantom.genus = shape.genus;
  return phantom;
}

double phantomDistance(const std::string& name, const PhantomOptions& options, const Vec3& world) {
  const phantoms::Shape& shape = phantoms::findShape(name);
  return shape.distance(phantoms::placeShape(shape, options).toShape(world));
}

}  // namespace handlebody
