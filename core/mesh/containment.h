#pragma once
// Which component lies in which.

#include <vector>

#include "core/mesh/topology.h"

namespace handlebody {

//! Per component the innermost other one around it, or -1. Exact (winding numbers). Precondition: closed,
//! oriented, no self-intersections. Costs one look at every face, and one at each component around another.
std::vector<int> surroundingComponents(const Mesh& mesh, const Components& parts);

//! Per component the body that it bounds: a solid component itself, and that around a cavity; -1 for a cavity
//! outside of any.
std::vector<int> bodyOfComponents(const Components& parts, const std::vector<int>& surrounding);

}  // namespace handlebody
