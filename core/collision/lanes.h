#pragma once
// A few points at a time: the part of the broad phase that pays for vector instructions. Vectors of GCC and
// Clang: the compiler takes what the machine has, and the bits are those of one operation at a time.

#include <array>
#include <cstdint>
#include <cstring>

namespace handlebody {

inline constexpr std::uint32_t kLanes = 4;

using LaneFloats = float __attribute__((vector_size(16)));
using LaneBits = std::int32_t __attribute__((vector_size(16)));

inline LaneFloats loadLanes(const float* from) {
  LaneFloats lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

//! All bits of lane k: k < count, and point k, given by its coordinates, is not farther than the root of
//! `limit` from `centre`, in single precision.
inline LaneBits lanesWithin(const float* x, const float* y, const float* z,
                            const std::array<float, 3>& centre, float limit, std::int32_t count) {
  const LaneFloats dx = loadLanes(x) - centre[0], dy = loadLanes(y) - centre[1],
                   dz = loadLanes(z) - centre[2];
  return (dx * dx + dy * dy + dz * dz <= limit) & (LaneBits{0, 1, 2, 3} < count);
}

//! Bit k: bit k of lane k is set. (Lanes that are all or nothing, shifted and combined, give many such bits.)
inline unsigned anyLane(const LaneBits& lanes) {
  return static_cast<unsigned>(lanes[0] | lanes[1] | lanes[2] | lanes[3]);
}

}  // namespace handlebody
