#pragma once
// Clicks that cannot all hold, and clicks that a surface does not heed.

#include <optional>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! The first seed that has a click outside of the object in its voxel, or lies in the ball of one; none: they
//! can all hold.
std::optional<Finding> contradictionOf(const Grid& grid, const std::vector<Seed>& clicks);

//! The same of the deepest place (mm) of a surface to begin with, which is a seed where none is given.
std::optional<Finding> contradictionOf(const Grid& grid, const Vec3& start, const std::vector<Seed>& clicks);

//! Seeds that the surface leaves outside, and clicks outside of the object that it encloses or whose balls it
//! reaches into, in their order, each once; not those within half a voxel of it, which is how far a place is
//! known at all, and balls as far as they are drawn.
//! Precondition: the mesh is closed, oriented and without self-intersections.
std::vector<Finding> unheededClicks(const Mesh& mesh, const Grid& grid, const std::vector<Seed>& clicks);

}  // namespace handlebody
