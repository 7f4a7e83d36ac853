#pragma once
// The object that a surface to begin with stands for: what it encloses, with its boundary on the edges next
// to it. It says more than any click in it.

#include <memory>

#include "core/evolution/constraints.h"
#include "core/evolution/object_range.h"
#include "core/object/region.h"

namespace handlebody {

//! The click that a surface stands for where there is none: a ball around its deepest place.
Seed seedWithin(const StartSurface& start);

//! The cells whose centres it encloses. Precondition: it has been read.
std::shared_ptr<const RegionInCells> cellsWithin(const StartSurface& start, const Grid& volume);

//! True if a part of the surface lies next to the boundary, and a part does not: then it stands for a part of
//! the object, and says where that ends. One that lies next to it everywhere stands for all of the object,
//! and one that is elsewhere begins somewhere in the object, or around it: the boundary is where they are to
//! go.
bool outlinesPart(const StartSurface& start, const ObjectChoice& boundary);

}  // namespace handlebody
