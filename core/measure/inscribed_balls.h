#pragma once
// Internal: the balls that fit into a body.

#include "core/collision/closest_point.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Asks for one mesh, in places near each other. Precondition: the mesh is closed and oriented.
class InscribedBalls {
 public:
  explicit InscribedBalls(const TriangleSoup& mesh) : mesh_(mesh), nearest_(mesh) {}

  //! mm, from the surface, on either side of it
  double radius(const Vec3& p) { return nearest_.distance(p, &hint_); }
  //! The point of the surface that is nearest to p.
  Vec3 foot(const Vec3& p);
  bool isInside(const Vec3& p) const { return nearest_.windingNumber(p) > 0; }
  //! The centre of the largest ball that touches the surface where it is nearest to p; p itself if it is
  //! that. Precondition: p is inside.
  Vec3 medialCentre(const Vec3& p);

 private:
  const TriangleSoup& mesh_;
  ClosestPoint nearest_;
  int hint_ = -1;
};

}  // namespace handlebody
