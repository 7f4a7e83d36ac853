#pragma once

#include <optional>

#include "core/mesh/mesh.h"

namespace handlebody {

//! Area (mm²) of that part of the cross-section of a body that holds p: the plane through p with this unit
//! normal cuts the mesh in polygons; counted is what lies within the innermost outline around p, without its
//! holes. None if p is not in the body. Precondition: the mesh is closed, manifold, oriented, without
//! self-intersections. One pass over the mesh.
std::optional<double> sectionArea(const TriangleSoup& mesh, const Vec3& p, const Vec3& normal);

}  // namespace handlebody
