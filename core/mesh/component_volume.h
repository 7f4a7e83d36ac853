#pragma once
// The signed volume of a component, summed about a vertex of its own: about the origin of the world, hundreds
// of mm away, rounding would decide the sign of a thin one.

#include <Eigen/Geometry>

#include "core/mesh/mesh.h"

namespace handlebody {

//! Volume (mm³) of the tetrahedron that a face and the component's first vertex span; positive if the vertex
//! lies behind the face. The step's check and the certificate sum the same terms in the same order, so that
//! they tell a body from a cavity alike.
inline double volumeTerm(const Vec3& first, const Vec3& a, const Vec3& b, const Vec3& c) {
  return (a - first).dot((b - first).cross(c - first)) / 6;
}

}  // namespace handlebody
