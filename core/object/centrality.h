#pragma once
// How far inside of a region its click lies: a user clicks well within what is meant, not at its rim.

#include "core/object/candidates.h"

namespace handlebody {

//! Depth of the search's click in a region over that of the region's deepest cell, 0 to 1. Large regions are
//! sampled: within a tenth or so. Beyond the cells that were searched counts as outside.
double centrality(const RankedRegion& region);

}  // namespace handlebody
