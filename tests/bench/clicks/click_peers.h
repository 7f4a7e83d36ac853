#pragma once
// What other programs make of the same clicks, each set up as its users find it.

#include <cstdint>
#include <vector>

#include "core/volume/volume.h"
#include "tests/bench/clicks/labelled_case.h"

namespace handlebody::bench {

//! itk::CurvatureFlowImageFilter (5 iterations of 0.125) and itk::ConfidenceConnectedImageFilter as in ITK's
//! own example: multiplier 2.5, 5 iterations, neighbourhoods of 2 voxels around the seeds. It knows no clicks
//! outside.
Mask confidenceConnected(const Volume& volume, const std::vector<UserClick>& clicks);

//! 3D Slicer's "Grow from seeds" (FastGrowCut: Zhu et al. 2014, "An effective interactive medical image
//! segmentation method using fast GrowCut"; no seed locality): every voxel belongs to the seed from which the
//! path with the least sum of intensity differences leads. Clicks are 3x3x3 voxels. Slicer asks for a
//! background: as long as there is no click outside, it is the border of the volume.
Mask growFromSeeds(const Volume& volume, const std::vector<UserClick>& clicks);

}  // namespace handlebody::bench
