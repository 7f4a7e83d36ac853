#pragma once
// A disc as a wall: the flat polygon that stands for it, and how far things are from it.

#include <array>

#include "core/evolution/constraints.h"

namespace handlebody {

//! The disc lies wholly in a regular polygon of 32 corners, 0.5 % wider, which is what triangles keep out of:
//! so their distances and intersections are those of triangles.
class DiscShape {
 public:
  //! Precondition: requireSensible.
  explicit DiscShape(const WallDisc& disc);

  //! mm of a point from the disc; 0 on it.
  double distance(const Vec3& p) const;
  //! The point of the disc that is nearest to a place.
  Vec3 nearest(const Vec3& p) const;
  //! True if the triangle has a point in common with the polygon: exact for the polygon's corners as they are
  //! rounded.
  bool meets(const std::array<Vec3, 3>& t) const;
  //! True if the triangle keeps more than so many mm from the polygon.
  bool clears(const std::array<Vec3, 3>& t, double clearance) const;
  //! Half sides of the box around the disc along the world's axes.
  Vec3 halfBox() const;

 private:
  static constexpr std::size_t kCorners = 32;
  bool isFar(const std::array<Vec3, 3>& t, double clearance) const;
  template <typename F>
  bool anyPart(F&& f) const;

  Vec3 centre_, normal_;
  double radius_;
  std::array<Vec3, kCorners> corners_;
};

}  // namespace handlebody
