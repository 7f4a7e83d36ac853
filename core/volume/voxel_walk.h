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
  std::array<std::size_t, 3> first{}, step{};
  std::array<double, 3> part{};
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::clamp(index[static_cast<int>(a)], 0.0, size[a] - 1.0);
    const int low = std::max(0, std::min(static_cast<int>(x), size[a] - 2));
    part[a] = x - low;
    first[a] = idx(low) * stride;
    step[a] = size[a] > 1 ? stride : 0;
    stride *= idx(size[a]);
  }
  double sum = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t offset = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool upper = (corner >> a & 1U) != 0;
      weight *= upper ? part[a] : 1 - part[a];
      offset += first[a] + (upper ? step[a] : 0);
    }
    if (weight > 0) sum += weight * static_cast<double>(values[offset]);
  }
  return sum;
}

}  // namespace handlebody
