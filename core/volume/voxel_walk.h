#pragma once
// Voxels of a box by their numbers, x running fastest: neighbours by faces, and values between centres.

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/geometry/vec.h"
#include "core/indices.h"

namespace handlebody {

//! Calls f(number, axis) for the neighbours of a voxel by its faces: along each axis the one below, then the
//! one above.
template <typename F>
void forFaceNeighbours(const std::array<int, 3>& size, std::size_t voxel, F&& f) {
  const std::array<std::size_t, 3> steps{1, idx(size[0]), idx(size[0]) * idx(size[1])};
  const std::array<std::size_t, 3> c{voxel % steps[1], voxel / steps[1] % idx(size[1]), voxel / steps[2]};
  for (std::size_t a = 0; a < 3; ++a) {
    if (c[a] > 0) f(voxel - steps[a], a);
    if (c[a] + 1 < idx(size[a])) f(voxel + steps[a], a);
  }
}

//! Trilinear between the centres of a box, at a continuous index; beyond the outermost as there. Values
//! without weight may be anything. Precondition: the box is not empty.
template <typename T>
double trilinear(const T* values, const std::array<int, 3>& size, const Vec3& index) {
  std::array<std::array<std::size_t, 2>, 3> offset{};  // of the lower and the upper one
  std::array<std::array<double, 2>, 3> part{};
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::clamp(index[static_cast<int>(a)], 0.0, size[a] - 1.0);
    const int low = std::max(0, std::min(static_cast<int>(x), size[a] - 2));
    part[a] = {1 - (x - low), x - low};
    offset[a] = {idx(low) * stride, idx(size[a] > 1 ? low + 1 : low) * stride};
    stride *= idx(size[a]);
  }
  double sum = 0;
  for (std::size_t z = 0; z < 2; ++z)
    for (std::size_t y = 0; y < 2; ++y)
      for (std::size_t x = 0; x < 2; ++x) {
        const double weight = part[0][x] * part[1][y] * part[2][z];
        if (weight > 0)
          sum += weight * static_cast<double>(values[offset[0][x] + offset[1][y] + offset[2][z]]);
      }
  return sum;
}

}  // namespace handlebody
