#include "sample_volumes/phantom.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/errors.h"
#include "sample_volumes/placement.h"
#include "sample_volumes/rendering.h"
#include "sample_volumes/shapes.h"

namespace handlebody {
namespace phantoms {
namespace {

// Part of the voxel at p that is dark, for a signed distance d.
double coverage(const Shape& shape, const Hole& hole, const Vec3& spacing, const Vec3& p, double d) {
  const double widest = std::sqrt(5.0 / 3) * spacing.maxCoeff();
  if (std::abs(d) >= widest / 2) return d < 0 ? 1 : 0;
  constexpr double kStep = 1e-3;  // mm
  Vec3 normal;
  for (int a = 0; a < 3; ++a)
    normal[a] = darkDistance(shape, hole, p + kStep * Vec3::Unit(a)) -
                darkDistance(shape, hole, p - kStep * Vec3::Unit(a));
  return coveredPart(d, normal.normalized(), spacing);
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
  phantoms::requirePhantomType(options.type);  // before the work
  Phantom phantom;
  phantom.name = name;
  void* truth = nullptr;
  phantom.truth = makeVolume(place.grid, VoxelType::uint8, &truth);
  std::vector<float> signal =
      phantoms::renderSignal(shape, place, options.bias, static_cast<std::uint8_t*>(truth));
  const double noise = options.noise < 0 ? shape.noise : options.noise;
  const auto kind = shape.speckle ? phantoms::NoiseKind::speckle : phantoms::NoiseKind::white;
  if (noise > 0) phantoms::addNoise(kind, place.grid, noise, options.randomSeed, signal);
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
