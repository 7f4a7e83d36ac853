#pragma once
// Beyond which lengths nothing of the image is left, or of the surface in it, and there is no end of memory.

#include "core/volume/volume.h"

namespace handlebody {

//! mm, at most.
struct ParameterLimits {
  double longestSide = 0;  //!< of the volume
  double smoothing = 0;    //!< a quarter of it
  double edgeLength = 0;   //!< half of it
};

ParameterLimits limitsFor(const Grid& grid);

}  // namespace handlebody
