#pragma once
// STL and most readers of meshes hold coordinates in single precision.

#include "core/mesh/mesh.h"

namespace handlebody {

//! The mesh with its coordinates rounded to single precision. Where that makes faces touch or cross that did
//! not, their vertices are moved apart by as few units in the last place as it takes, at most
//! kMostNudge of them (of the vertex's largest coordinate). The same mesh always gives the same result. A
//! mesh that intersects itself by more than that is returned with its intersections.
TriangleSoup roundedToSingle(const TriangleSoup& mesh);

inline constexpr double kMostNudge = 256;

}  // namespace handlebody
