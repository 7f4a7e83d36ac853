#pragma once
// Exact signs of determinants of double coordinates: a filter in floating point with a proven error bound,
// then expansion arithmetic (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", 1997). Needs IEEE doubles, round to nearest and no reordering by the compiler
// (no -ffast-math, -ffp-contract=off).
//
// Domain in which the signs are exact: every coordinate is 0 or has a magnitude between 1e-60 and 1e60. (The
// lowest bit of a coordinate is then at least 1e-76, that of a product of three 1e-228, far above the
// underflow at 5e-324; the largest product is below 1e182.)

#include "core/geometry/vec.h"

namespace handlebody {

//! Sign of det(b-a, c-a, d-a): +1 if d lies on the side of the plane abc to which (b-a)×(c-a) points, 0 if
//! the four points are coplanar, else -1. Exact.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

//! Orientation of the triangle abc in the projection along coordinate axis `axis` (0, 1, 2), that is the sign
//! of that component of (b-a)×(c-a). Exact.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

//! True if the three points lie on a line (or coincide). Exact.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

namespace detail {
//! The fallbacks alone, without the filter; same contract. For tests.
int orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
int orient2dExact(const Vec3& a, const Vec3& b, const Vec3& c, int axis);
}  // namespace detail

}  // namespace handlebody
