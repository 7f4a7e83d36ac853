#pragma once
// Neighbours in space beside each other in memory: without this, a mesh that has grown by splitting edges
// has them anywhere, and every look at a ring misses the cache.

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! The vertices (slots) along a Morton curve (Z-order) through the cubes of side `cell` (mm, > 0); within a
//! cube in the order of their slots. Depends on the mesh alone.
std::vector<int> mortonOrder(const Mesh& mesh, double cell);

}  // namespace handlebody
