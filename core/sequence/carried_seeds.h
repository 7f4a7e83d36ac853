#pragma once
// Where to look for the object in another frame: the clicks, as far as the surface of the frame beside it
// still holds them.

#include <vector>

#include "core/evolution/parameters.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! The clicks inside that `surface` holds at least `depth` mm deep, with radii that fit into it; if it holds
//! none so, the place deepest in it. Clicks in the background that it does not enclose stay, the others are
//! left out. Precondition: the surface is closed and not empty.
std::vector<Seed> carriedSeeds(const std::vector<Seed>& clicks, const TriangleSoup& surface, double depth);

//! Deepest place of a lattice in the surface, mm, and how deep that is. Precondition: as above.
Seed deepestPlace(const TriangleSoup& surface);

}  // namespace handlebody
