#pragma once
// How often each intensity occurs: what the range of the object is chosen from.

#include <vector>

#include "core/volume/volume.h"

namespace handlebody::ui {

struct Histogram {
  double low = 0, high = 1;      //!< intensities that the bins cover
  bool whole = false;            //!< the type has whole numbers only
  std::vector<double> counts{};  //!< of equal width; the outer ones hold what lies beyond, too
};

//! Of at most about two million voxels, evenly spread. Whole-numbered types get bins of whole numbers. A long
//! thin tail (0.1 % of the voxels on either side) does not widen the bins. Precondition: the volume has
//! voxels.
Histogram histogramOf(const Volume& volume, int bins = 256);

}  // namespace handlebody::ui
