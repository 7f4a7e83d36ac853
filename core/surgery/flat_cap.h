#pragma once
// Triangles that fill a plane region with holes.

#include <optional>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Triangulates the region between polygons of one plane without new points: the first is its outer boundary,
//! counter-clockwise seen against `normal`, the others, clockwise, are holes. All triangles are
//! counter-clockwise. By exact orientations in the projection along the largest component of
//! the normal (ear clipping, the best shaped ear first; holes are joined by bridges; then edges are turned as
//! Delaunay's): whatever the rounding of the points, triangles without a common corner are disjoint if no two
//! polygons cross. None if it cannot be done: the polygons cross or touch. Takes the square of the number of
//! points.
std::optional<std::vector<Triangle>> flatCap(const std::vector<Vec3>& points, const Vec3& normal,
                                             const std::vector<std::vector<int>>& polygons);

//! How often the polygon winds around p, in the same projection.
int windingAround(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& polygon,
                  const Vec3& p);

}  // namespace handlebody
