#pragma once

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Label map on `grid`: 1 where the voxel centre lies inside the closed mesh (an odd number of crossings, so
//! that cavities are outside), else 0 (uint8). Precondition: the mesh is closed; its orientation does not
//! matter.
Volume rasterize(const TriangleSoup& mesh, const Grid& grid);

}  // namespace handlebody
