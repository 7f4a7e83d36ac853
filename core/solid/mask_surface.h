#pragma once
// The surface of a mask as a closed mesh whose topology is that of the voxels.

#include "core/mesh/mesh.h"
#include "core/solid/mask.h"

namespace handlebody {

//! The surface that runs midway between the centres of voxels inside and outside (marching cubes at one half,
//! resolved so that the object is 6-connected and the background 26-connected everywhere). Voxels beyond the
//! grid are outside. Closed, 2-manifold, oriented and free of self-intersections for every mask: crossing
//! points lie on the grid's edges, what joins them within one cell, and the 256 cases are tested. Its
//! components are those of the object and its cavities, its genus is the number of the object's tunnels.
//! Linear in the voxels; needs two planes of them besides the mesh. Throws InputError, without a subject
//! ("has a surface of more than … triangles"), at `most` triangles.
TriangleSoup maskSurface(const Mask& mask, std::size_t most = 20'000'000);

}  // namespace handlebody
