#pragma once
// Clicks that cannot all hold, and clicks that a surface does not heed.

#include <optional>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! The first seed that has a click outside of the object in its voxel; none: they can all hold.
std::optional<Finding> contradictionOf(const Grid& grid, const std::vector<Seed>& clicks);

//! Seeds that the surface leaves outside, and clicks outside of the object that it encloses, in their order,
//! each place once; not those within half a voxel of it, which is how far a place is known at all.
//! Precondition: the mesh is closed, oriented and without self-intersections.
std::vector<Finding> unheededClicks(const Mesh& mesh, const Grid& grid, const std::vector<Seed>& clicks);

}  // namespace handlebody
