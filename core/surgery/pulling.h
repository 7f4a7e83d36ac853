#pragma once
// Pulling a place of the surface somewhere else.

#include "core/surgery/touched_mesh.h"

namespace handlebody {

//! Moves the point of the surface that is nearest to `from` to `to` (mm, LPS), and what lies within `radius`
//! (mm, along the surface) of it the less the further it is from it. Where the surface is drawn out it is
//! divided, where it is pressed together vertices are merged, so that the edges stay about as long as they
//! were there. That point is a vertex of the result; it may be up to 0.3 edges from the nearest one. Where
//! one pull would make the surface meet itself, several shorter ones are tried; then it is refused, and so is
//! one over more than kFurthestPull radii. Precondition: `mesh` is certified, and radius > 0.
TouchedMesh pulled(const Mesh& mesh, const Vec3& from, const Vec3& to, double radius);

inline constexpr double kFurthestPull = 20;

}  // namespace handlebody
