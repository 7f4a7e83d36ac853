#pragma once
// Smoothing in a ball.

#include "core/surgery/touched_mesh.h"

namespace handlebody {

//! Smooths the surface within `radius` (mm) of `centre` (mm, LPS) by Taubin's method, falling off to nothing
//! at the rim of that ball, and moves what was smoothed along its normals until the enclosed volume is what
//! it was. Where the whole of it would make the surface meet itself a part of it is done. The faces stay the
//! same, vertices outside do not move. Refused if no vertex lies there. Precondition: `mesh` is certified.
TouchedMesh smoothedHere(const Mesh& mesh, const Vec3& centre, double radius);

}  // namespace handlebody
