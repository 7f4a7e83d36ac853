#pragma once
// Keeps a moving mesh regular: long edges are split, short ones collapsed, valences kept near six.

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

struct RemeshLimits {
  double longest = 0;   //!< mm; longer edges are split
  double shortest = 0;  //!< mm; shorter edges are collapsed
};

//! The dihedral angle up to which an edge may be turned or an edge beside it collapsed: the surface moves by
//! at most the longest edge times the sine of it. (cosine)
inline constexpr double kFlatEnough = 0.8;

//! Regulates the mesh around the vertices with active[v] != 0. Topology never changes. New vertices are
//! marked active; `active` grows with the mesh. Vertices with active[v] == 0 are not moved or removed. No
//! edge beside an active vertex is longer than limits.longest afterwards; collapses and flips are done only
//! where the surface is nearly flat (kFlatEnough), so that the surface moves by little; they may still make
//! it intersect another sheet close by, which the caller's detection sees.
void regulate(Mesh& mesh, const RemeshLimits& limits, std::vector<unsigned char>& active);

}  // namespace handlebody
