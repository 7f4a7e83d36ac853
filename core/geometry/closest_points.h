#pragma once

#include <array>

#include "core/geometry/vec.h"

namespace handlebody {

//! The point of a triangle that is nearest to p (Ericson, Real-Time Collision Detection, 5.1.5), for
//! triangles that are a segment or a point, too; in floating point, with its rounding.
Vec3 closestPoint(const Vec3& p, const std::array<Vec3, 3>& triangle);

//! A point of each of two triangles that have none in common, as near to each other as any; in floating
//! point, with its rounding.
std::array<Vec3, 2> closestPoints(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);

}  // namespace handlebody
