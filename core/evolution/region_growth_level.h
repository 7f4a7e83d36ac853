#pragma once
// The level at which a growing region has the clearest boundary.

#include <optional>

#include "core/evolution/region_growth.h"

namespace handlebody {

struct RegionGrowthLevel {
  double level = 0;     //!< signed as in RegionGrowth
  double strength = 0;  //!< mean edge there, signed intensity per mm
  double border = 0;    //!< part of the volume's border that the region holds
  double voxels = 0;    //!< of the region
};

//! The level of the strongest mean edge. A level after the region has leaked into another one counts only if
//! its edge is much stronger. None if no region was large enough, or
//! if the growth was given up at the peak of its edge, so that a stronger one may lie ahead.
std::optional<RegionGrowthLevel> strongestLevel(const RegionGrowth& growth);

}  // namespace handlebody
