#pragma once
// Which points of many may be near to some of a few: a bit table of the boxes around the few.

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

class NearPoints {
 public:
  //! Marks the boxes of side 2·radius (mm, > 0) that the cubes of half side `radius` around points[v], v in
  //! `vertices` (not empty), meet.
  void build(std::span<const Vec3> points, std::span<const int> vertices, double radius);

  //! True for every point within the radius of a marked one, and for some others.
  bool mayBeNear(const Vec3& p) const {
    if (!((p.array() >= low_.array()).all() && (p.array() <= high_.array()).all())) return false;
    const Vec3 a = (p - low_) * scale_;
    const std::uint32_t at = slot(static_cast<std::int64_t>(a.x()), static_cast<std::int64_t>(a.y()),
                                  static_cast<std::int64_t>(a.z()));
    return (bits_[at >> 6] >> (at & 63) & 1) != 0;
  }

 private:
  std::uint32_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return (static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
            static_cast<std::uint32_t>(z) * 83492791u) &
           mask_;
  }

  Vec3 low_, high_;   // around all cubes
  double scale_ = 0;  // boxes per mm
  std::uint32_t mask_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace handlebody
