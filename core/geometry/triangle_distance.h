#pragma once

#include <array>

#include "core/geometry/vec.h"

namespace handlebody {

//! Square of the distance of p from the triangle abc (Ericson, Real-Time Collision Detection, 5.1.5), for
//! triangles that are a segment or a point, too; in floating point, with its rounding.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

//! Square of the distance of two triangles that have no point in common: the least of a corner from the other
//! triangle, or of two edges; in floating point, with its rounding.
double squaredDistance(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);

//! True if the triangle abc and the box from -half to half have a point in common (separating axes:
//! Akenine-Möller 2001); in floating point, with its rounding.
bool meetsBox(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half);

}  // namespace handlebody
