#pragma once
// A few points at a time: the part of the broad phase that pays for vector instructions. SSE2 is part of
// every x86-64; elsewhere the same operations run one by one, with the same bits.

#include <array>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace handlebody {

inline constexpr std::uint32_t kLanes = 4;

//! Bit k: point k of kLanes, given by its coordinates, is not farther than the root of `limit` from `centre`,
//! in single precision.
inline unsigned lanesWithin(const float* x, const float* y, const float* z,
                            const std::array<float, 3>& centre, float limit) {
#ifdef __SSE2__
  const __m128 dx = _mm_sub_ps(_mm_loadu_ps(x), _mm_set1_ps(centre[0]));
  const __m128 dy = _mm_sub_ps(_mm_loadu_ps(y), _mm_set1_ps(centre[1]));
  const __m128 dz = _mm_sub_ps(_mm_loadu_ps(z), _mm_set1_ps(centre[2]));
  const __m128 d = _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy)), _mm_mul_ps(dz, dz));
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(d, _mm_set1_ps(limit))));
#else
  unsigned bits = 0;
  for (std::uint32_t k = 0; k < kLanes; ++k) {
    const float dx = x[k] - centre[0], dy = y[k] - centre[1], dz = z[k] - centre[2];
    bits |= static_cast<unsigned>(dx * dx + dy * dy + dz * dz <= limit) << k;
  }
  return bits;
#endif
}

}  // namespace handlebody
