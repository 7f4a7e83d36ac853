#pragma once
// The special positions of the triangle-triangle tests: coplanar triangles, and degenerate ones, which are
// segments or points. All exact, all for closed point sets; coordinates as in predicates.h.

#include <array>

#include "core/geometry/vec.h"

namespace handlebody::detail {

using TrianglePoints = std::array<const Vec3*, 3>;

//! True if the triangles have a common point. Precondition: they are coplanar or at least one is degenerate.
bool flatTrianglesIntersect(const TrianglePoints& a, const TrianglePoints& b);

//! Triangles that share their first point: true if they have a common point besides it. Precondition as
//! above.
bool flatFansIntersect(const TrianglePoints& a, const TrianglePoints& b);

//! Triangles (s,t,a) and (s,t,b): true if they have a common point off the segment st. Precondition:
//! orient3d(s,t,a,b) == 0.
bool flatHingeIntersects(const Vec3& s, const Vec3& t, const Vec3& a, const Vec3& b);

}  // namespace handlebody::detail
