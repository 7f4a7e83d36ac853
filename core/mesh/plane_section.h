#pragma once
// Where a mesh crosses a plane.

#include <array>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! The segments in which triangles cross the plane normal·p = offset, one per crossed triangle, in no order;
//! their ends lie on edges of the mesh, so that a closed mesh gives closed lines. A point on the plane counts
//! as above it: a triangle that only touches the plane from above gives nothing. `section` is overwritten.
//! One pass over the points and one over the triangles. `crossed`, if given, gets the triangle of each
//! segment.
void planeSection(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const Vec3& normal,
                  double offset, std::vector<std::array<Vec3, 2>>& section,
                  std::vector<int>* crossed = nullptr);

}  // namespace handlebody
