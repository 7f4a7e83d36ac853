#pragma once
// Fronts that meet at one place in one step.

#include <vector>

#include "core/mesh/mesh.h"
#include "core/surgery/collision_groups.h"

namespace handlebody {

//! Three or more fronts that are to be joined at once, and the groups that they were found in.
struct Gathering {
  CollisionGroup whole;
  std::vector<CollisionGroup> parts;  //!< empty if `whole` is a group as it was found
};

//! Groups whose sets Λ lie on the same fronts become one. A front that meets two others collides with them at
//! two places, which are one set Λ only if they have a common neighbour (paper, section 4). Four fronts that
//! come from four sides would so be joined two by two, around a tunnel that has to be closed later. Here sets
//! that are at most `reach` edges apart on the surface count as one front, with a shortest path between them,
//! if that makes three fronts or more of several groups. All else stays as it was found, in the same order.
std::vector<Gathering> gatherFronts(const Mesh& mesh, const std::vector<CollisionGroup>& groups, int reach);

}  // namespace handlebody
