#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody::bench {

//! The zero level of a field on `grid` as triangles (world mm) with their normals towards greater values:
//! VTK's flying edges, which makes the triangles of marching cubes faster. Outside of the grid the field is
//! positive.
TriangleSoup isoSurface(const std::vector<float>& field, const Grid& grid);

}  // namespace handlebody::bench
