#pragma once
// Volumes made from a formula, for tests.

#include <algorithm>
#include <cmath>

#include "core/volume/volume.h"

namespace handlebody::testing {

//! n³ voxels of 1 mm with the origin at voxel 0.
inline Grid cubicGrid(int n) {
  Grid grid;
  grid.size = {n, n, n};
  return grid;
}

//! Voxels f(i, j, k), of float32.
template <typename F>
Volume volumeByIndex(const Grid& grid, F&& f) {
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::float32, &buffer);
  float* out = static_cast<float*>(buffer);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) *out++ = static_cast<float>(f(i, j, k));
  return volume;
}

//! Voxels `inside` where the signed distance (mm, world) is negative, `outside` where it is positive, and a
//! ramp of one mm between them: the half-way level lies on the surface.
template <typename F>
Volume volumeByDistance(const Grid& grid, double inside, double outside, F&& distance) {
  return volumeByIndex(grid, [&](int i, int j, int k) {
    const double t = std::clamp(distance(grid.toWorld(Vec3(i, j, k))) + 0.5, 0.0, 1.0);
    return inside + t * (outside - inside);
  });
}

}  // namespace handlebody::testing
