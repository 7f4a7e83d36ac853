#pragma once
// The shortest handle of two loops, out of the handle database (paper, section 4, "Inserting handles from the
// database"), where all handles of these sizes are stored.

#include <optional>

#include "core/handles/cross_edges.h"
#include "core/handles/handle_enumeration.h"

namespace handlebody {

//! The shortest of all handles with edges and faces that are allowed, faces as in a Handle, over vertices
//! numbered as in `edges`. None if the database does not list all handles of these sizes (Family::all for two
//! loops; balanced and monotone ones are not all), if all of the list are forbidden, and if lengths alone do
//! not tell which it is: another handle, or a triangulation that is none since it has an edge twice, may be
//! as short but for rounding.
std::optional<Handle> shortestListed(const CrossEdges& edges);

}  // namespace handlebody
