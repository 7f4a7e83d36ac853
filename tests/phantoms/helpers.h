#pragma once
// What several phantom tests need.

#include <random>
#include <string>
#include <vector>

#include "sample_volumes/phantom.h"
#include "tests/support/catch.h"

namespace handlebody::phantomtest {

//! Uniform points in a box; the engine's raw numbers are fixed by the standard.
class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 inBox(const Vec3& half) {
    const double x = uniform(-half.x(), half.x());
    const double y = uniform(-half.y(), half.y());
    return {x, y, uniform(-half.z(), half.z())};
  }

 private:
  std::mt19937 engine_;
};

//! Gradient by central differences.
template <typename F>
Vec3 gradient(F&& f, const Vec3& p) {
  constexpr double kStep = 1e-4;  // mm
  Vec3 g;
  for (int a = 0; a < 3; ++a)
    g[a] = (f(p + kStep * Vec3::Unit(a)) - f(p - kStep * Vec3::Unit(a))) / (2 * kStep);
  return g;
}

//! The intensity half way between object and background.
inline double halfLevel(VoxelType type) {
  return type == VoxelType::uint8 ? 120 : type == VoxelType::int16 ? 300 : 0.5;
}

inline std::vector<double> voxelsOf(const Volume& volume) {
  return visitVoxels(
      volume, [&](const auto* data) { return std::vector<double>(data, data + volume.grid.voxelCount()); });
}

//! Options with the anisotropic spacing and the oblique direction that the engine is tried with.
inline PhantomOptions oblique() {
  PhantomOptions options;
  options.spacing = Vec3(0.5, 1, 2);
  options.rotationDegrees = Vec3(20, -35, 50);
  return options;
}

}  // namespace handlebody::phantomtest
