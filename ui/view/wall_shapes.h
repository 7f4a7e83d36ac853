#pragma once
// Internal: walls as surfaces, for the 3D view.

#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody::ui {

//! Only to look at: balls that overlap have one surface, rounded to a third of the smallest radius or a
//! hundredth of all of them; a map's voxels to at most 128 cells along an axis; discs are flat.
TriangleSoup shapesOf(const WallList& walls, const Grid& grid);

}  // namespace handlebody::ui
