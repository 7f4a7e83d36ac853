#pragma once
// Two faces of a mesh: what they share by index, and whether they intersect besides.

#include <span>
#include <utility>

#include "core/geometry/vec.h"

namespace handlebody {

//! Two faces by slot, first < second.
using FacePair = std::pair<int, int>;

//! True if the faces have a vertex in common.
inline bool shareVertex(const Triangle& a, const Triangle& b) {
  return a[0] == b[0] || a[0] == b[1] || a[0] == b[2] || a[1] == b[0] || a[1] == b[1] || a[1] == b[2] ||
         a[2] == b[0] || a[2] == b[1] || a[2] == b[2];
}

//! True if the faces have a point in common outside the vertex or edge they share; always if they have the
//! same three vertices. Exact.
bool facesIntersect(std::span<const Vec3> points, const Triangle& a, const Triangle& b);

}  // namespace handlebody
