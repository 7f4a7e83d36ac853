#pragma once
// What the smoothed image is like around the seeds.

#include <vector>

#include "core/evolution/parameters.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! Smoothed values at the voxels within `radius` mm of the seeds, and at the seeds.
std::vector<double> valuesNear(const SmoothedVolume& volume, const std::vector<Seed>& seeds, double radius);

//! The median of the absolute differences from the median, as the standard deviation of a normal distribution
//! that has it. Precondition: not empty.
double robustDeviation(std::vector<double> values);

//! Gradient (intensity per mm) of the noise within `radius` mm of the seeds, weighted as RegionGrowth::edge
//! is; 0 if nothing changes there.
double noiseEdge(const SmoothedVolume& volume, const std::vector<Seed>& seeds, double radius);

//! Radius (mm) in which the seeds' statistics are taken: the user's, but no more than a few voxels.
double statisticsRadius(const Grid& grid, const std::vector<Seed>& seeds);

}  // namespace handlebody
