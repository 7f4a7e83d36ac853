#pragma once
// Angles of a triangle, and between two that share an edge.

#include "core/geometry/vec.h"

namespace handlebody {

//! The least angle of a triangle, degrees; 0 for one without area.
double leastAngle(const Vec3& a, const Vec3& b, const Vec3& c);

//! Between the faces (p,q,c) and (q,p,d) of the edge pq, degrees: 180 where it is flat, small where it is
//! sharp on either side.
double dihedralAngle(const Vec3& p, const Vec3& q, const Vec3& c, const Vec3& d);

}  // namespace handlebody
