#pragma once

#include "core/geometry/vec.h"

namespace handlebody {

//! True if the closed triangles (a0,a1,a2) and (b0,b1,b2), which share no vertex, have a common point. Exact:
//! filtered floating point, then exact arithmetic; degenerate and coplanar triangles included.
bool trianglesIntersect(const Vec3& a0, const Vec3& a1, const Vec3& a2, const Vec3& b0, const Vec3& b1,
                        const Vec3& b2);

//! Triangles (s,a1,a2) and (s,b1,b2) share the vertex s: true if they have a common point besides s.
bool trianglesIntersectSharedVertex(const Vec3& s, const Vec3& a1, const Vec3& a2, const Vec3& b1,
                                    const Vec3& b2);

//! Triangles (s,t,a) and (s,t,b) share the edge st: true if they have a common point off that edge.
bool trianglesIntersectSharedEdge(const Vec3& s, const Vec3& t, const Vec3& a, const Vec3& b);

}  // namespace handlebody
