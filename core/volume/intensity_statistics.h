#pragma once

#include <span>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! Of all voxels of a volume that have a value (not_a_number.h), in its own intensities.
struct IntensityStatistics {
  double minimum = 0;
  double maximum = 0;
  double mean = 0;
  std::vector<double> percentiles;  //!< one for each that was asked for
};

//! `percents` in [0, 100]: the percentile is the value at rank floor(p/100 · (n - 1)) of the sorted voxels,
//! so it is always a value that occurs. Voxels that were not a number in their file do not count.
//! Precondition: at least one voxel, none of them NaN.
IntensityStatistics intensityStatistics(const Volume& volume, std::span<const double> percents);

//! The value at rank floor(q · (n - 1)) of the sorted values, q in [0, 1]. Precondition: not empty, no NaN.
double quantile(std::vector<double> values, double q);
double quantile(std::vector<float> values, double q);

}  // namespace handlebody
