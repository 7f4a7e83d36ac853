#pragma once
// Voxels that are not a number in their file, or too large a one, are read as a number below all others,
// which is known again by its digits.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

namespace handlebody {

//! No voxel that was measured is larger, of either sign: ±FLT_MAX and ±DBL_MAX are what programs write where
//! they have no value. Sums of so large ones stay finite in single precision (smoothing).
inline constexpr double kLargestVoxel = 1e37;

//! Neither NaN, infinite nor above kLargestVoxel. T is float or double.
template <typename T>
bool isVoxelValue(T voxel) {
  return std::abs(voxel) <= static_cast<T>(kLargestVoxel);
}

//! The largest number below `least`, that of all voxels that are numbers, whose last bits are a mark. May be
//! infinite. T is float or double.
template <typename T>
T notANumberBelow(T least) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  constexpr Bits kLast = 0xfff, kMark = 0xa5c, kSign = Bits{1} << (8 * sizeof(T) - 1);
  const T below = std::nextafter(least, -std::numeric_limits<T>::infinity());
  const Bits bits = std::bit_cast<Bits>(below), size = bits & ~kSign;
  Bits marked = (size & ~kLast) | kMark;
  if (below > 0) {
    if (marked > size) {
      if (marked <= kLast) return std::bit_cast<T>(kSign | kMark);  // there is none above 0
      marked -= kLast + 1;
    }
    return std::bit_cast<T>(marked);
  }
  if (marked < size) marked += kLast + 1;
  return std::bit_cast<T>(kSign | marked);
}

//! The number that stands for voxels that are not a number, if there are any; none of whole numbers. Looks at
//! all of them.
template <typename T>
std::optional<T> notANumberIn(const T* voxels, std::size_t count) {
  if constexpr (std::is_floating_point_v<T>) {
    T least = std::numeric_limits<T>::infinity(), next = least;
    for (std::size_t i = 0; i < count; ++i) {
      const T v = voxels[i];
      if (v < least) {
        next = least;
        least = v;
      } else if (v > least && v < next) {
        next = v;
      }
    }
    if (std::isfinite(next) && least == notANumberBelow(next)) return least;
  }
  return std::nullopt;
}

}  // namespace handlebody
