#pragma once
// Whether some triangles lie wholly within a distance of others.

#include <array>
#include <span>

#include "core/geometry/vec.h"

namespace handlebody {

using Corners = std::array<Vec3, 3>;

//! True only if every point of `triangle` lies within `distance` of one of `others`; false also if that is
//! not shown, which happens where the distance comes within a few per cent of the limit, or the triangle is a
//! hundred times as large. Pieces are halved
//! until one of `others` is near to all three corners (the distance from a convex set is convex, so it is
//! then near to all between them) or the centre is near by more than the piece is large.
bool isCovered(const Corners& triangle, std::span<const Corners> others, double distance);

//! The same of those points of `triangle` that lie within `distance` of one of `where`.
bool isCovered(const Corners& triangle, std::span<const Corners> where, std::span<const Corners> others,
               double distance);

//! The largest distance of a point of `triangle` from the nearest of `others`, of points that lie densely
//! (some fifty).
double farthestFrom(const Corners& triangle, std::span<const Corners> others);

}  // namespace handlebody
