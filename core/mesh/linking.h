#pragma once
// How the generators of the first homology link each other in space: what tells the loops around handles from
// those around tunnels.

#include <optional>
#include <vector>

#include "core/mesh/tree_cotree.h"

namespace handlebody {

//! The matrix P, 2g × 2g, row by row, that takes the coordinates of a class (in the primal loops) to those of
//! its part that bounds outside of the body; I - P gives the part that bounds inside. None if the surface
//! folds so tightly that its linking numbers come out contradictory.
//!
//! Row k of P holds, but for one sign, the linking numbers of the dual loop k, pushed outwards, with the
//! primal loops: outside of a closed surface in space a curve sees the classes within only (Alexander
//! duality), and the two kinds of push differ by the intersection number. P is a projection of rank g, which
//! is checked. Crossings in a projection are counted with exact predicates. Precondition as for treeCotree.
std::optional<std::vector<int>> outerProjection(const Mesh& mesh, const TreeCotree& trees);

}  // namespace handlebody
