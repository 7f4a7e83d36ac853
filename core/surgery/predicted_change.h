#pragma once
// What a change of the mesh does to its topology, said before it is made (the paper's Theorem 6, for any
// surface that is taken out and any that is put in). The step counts afterwards; see evolution/step_check.h.

#include "core/mesh/topology.h"
#include "core/surgery/plan.h"

namespace handlebody {

//! Euler number of what an opening takes out, without its boundary: 1 for a disc, 0 for an annulus, 2 - 2g
//! for a whole component of genus g.
int eulerNumberOf(const Opening& opening);

//! By how much the plan changes the Euler number of a closed mesh. Surfaces glued along circles add their
//! Euler numbers. A handle that joins k polygons adds 2 - k, a cap 1; a handle for k discs thus
//! (2 - k) - k = -2 (k - 1), which is Theorem 6: the genus of a connected surface grows by k - 1.
int eulerChange(const Plan& plan);

//! The numbers after the plan. `opened` is the mesh M_b: the openings are taken out and nothing is put in.
//! What was one component may be several in it; a handle makes one of all that it joins, a cap joins nothing.
TopologyNumbers predictChange(const TopologyNumbers& before, const Mesh& opened, const Plan& plan);

//! The numbers after a whole component of these is deleted.
TopologyNumbers predictDeletion(const TopologyNumbers& before, const Components& parts, int component);

}  // namespace handlebody
