#pragma once
// A few points at a time: the part of the broad phase that pays for vector instructions. Vectors of GCC and
// Clang: the compiler takes what the machine has, and the bits are those of one operation at a time.

#include <array>
#include <cstdint>
#include <cstring>

namespace handlebody {

inline constexpr std::uint32_t kLanes = 4;

//! Bit k: point k of kLanes, given by its coordinates, is not farther than the root of `limit` from `centre`,
//! in single precision.
inline unsigned lanesWithin(const float* x, const float* y, const float* z,
                            const std::array<float, 3>& centre, float limit) {
  using Floats = float __attribute__((vector_size(16)));
  using Bits = std::int32_t __attribute__((vector_size(16)));
  Floats dx, dy, dz;
  std::memcpy(&dx, x, sizeof dx);
  std::memcpy(&dy, y, sizeof dy);
  std::memcpy(&dz, z, sizeof dz);
  dx -= centre[0];
  dy -= centre[1];
  dz -= centre[2];
  const Bits near = (dx * dx + dy * dy + dz * dz <= limit) & Bits{1, 2, 4, 8};
  return static_cast<unsigned>(near[0] | near[1] | near[2] | near[3]);
}

}  // namespace handlebody
