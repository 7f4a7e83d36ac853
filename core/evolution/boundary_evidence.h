#pragma once
// How clearly the image shows a boundary, measured on that boundary.

#include <vector>

#include "core/evolution/object_range.h"

namespace handlebody {

struct BoundaryEvidence {
  //! The step across it, from half a voxel inside to one and a half outside, that nine of ten places exceed,
  //! over the median step. A surface that leaks lies without a step where it does. 0 if it encloses nothing.
  double weakest = 0;
  double noise = 0;   //!< standard deviation at the seeds, over the contrast
  double unseen = 0;  //!< part of it that lies on the border of the volume or against padding
  //! An edge all around, so high that nothing else can be meant.
  bool isBeyondDoubt() const;
  //! An edge all around.
  bool isClear() const;
  //! Not that, but enough to be believed where another method finds the same.
  bool isPlausible() const;
};

//! Of a boundary around seeds, without what closes a neck. Of the first three million voxels around the seeds
//! if it encloses more.
BoundaryEvidence evidenceOf(const ObjectChoice& choice, const std::vector<Seed>& seeds);

}  // namespace handlebody
