#pragma once
// The boxes of the paper's eight hash functions (section 2, Eq. 1) by their halves.

#include <array>
#include <optional>
#include <span>

#include "core/geometry/vec.h"

namespace handlebody {

//! Eq. (1) as an integer: floor(a/l + i/2) for i in {0,1}, given the half box floor(2a/l). (Eq. (2) as
//! printed divides by l once more; Theorem 3 holds for one division.)
inline int boxIndex(int halfBox, int i) { return (halfBox + i) >> 1; }

//! Boxes of size l/2, from the lower corner of all vertices on.
struct HalfBoxes {
  Vec3 low{0, 0, 0};     //!< mm: that corner
  double scale = 1;      //!< 2/l, per mm
  Vec3 extent{0, 0, 0};  //!< of all vertices, in half boxes

  //! In half boxes from the corner; not negative for the vertices that they were made for.
  Vec3 placeOf(const Vec3& point) const { return (point - low) * scale; }
  std::array<int, 3> boxOf(const Vec3& point) const {
    const Vec3 a = placeOf(point);
    // Not negative, so truncation is the floor.
    return {static_cast<int>(a.x()), static_cast<int>(a.y()), static_cast<int>(a.z())};
  }
};

//! Half boxes somewhat larger than `radius` (mm), so that vertices within it are in the same or in
//! neighbouring ones, rounded as they are. None if that makes no sense: radius is not positive, there are no
//! vertices, or too many boxes to be numbered.
std::optional<HalfBoxes> halfBoxesFor(std::span<const Vec3> points, std::span<const int> vertices,
                                      double radius);

}  // namespace handlebody
