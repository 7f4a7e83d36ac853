#pragma once
// Signed distances (mm, negative inside) of points to simple bodies centred at 0. All are exact everywhere.

#include "core/geometry/vec.h"

namespace handlebody::phantoms {

double ballDistance(const Vec3& p, double radius);
//! Cylinder of infinite length through 0; `axis` has length 1.
double cylinderDistance(const Vec3& p, const Vec3& axis, double radius);
//! All points within `radius` of the segment from -halfLength to halfLength on the x axis.
double capsuleDistance(const Vec3& p, double halfLength, double radius);
//! Ring around `axis` (length 1): tube of `tube` mm radius about a circle of `ring` mm radius.
double torusDistance(const Vec3& p, const Vec3& axis, double ring, double tube);
//! Box whose edges are rounded with `rounding` mm (0 = sharp); `half` are its half sides, rounding included.
double boxDistance(const Vec3& p, const Vec3& half, double rounding);
//! Cube of half side `half` without the ball of `radius` at its centre; half < radius < sqrt(2)·half, so that
//! the ball pierces every face and leaves the twelve edges.
double frameDistance(const Vec3& p, double half, double radius);

}  // namespace handlebody::phantoms
