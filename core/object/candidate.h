#pragma once
// What a click may mean: a region of the image that hangs together, and on what grounds it is offered.

#include <limits>

namespace handlebody {

//! One of the objects that the clicks may mean.
struct ObjectCandidate {
  double volume = 0;      //!< mm³, of its voxels
  double neckRadius = 0;  //!< mm: passages narrower than this are cut; 0 = none is
  double low = -std::numeric_limits<double>::infinity();  //!< intensities at the clicks: both ends included
  double high = std::numeric_limits<double>::infinity();
  double score = 0;  //!< expected Dice with the object that is meant, whichever it is; 0 to 1
};

}  // namespace handlebody
