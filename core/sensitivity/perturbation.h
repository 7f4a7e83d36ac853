#pragma once
// The same growth with everything a little different that might as well have been: where the user clicked,
// how much the image is smoothed, its noise.

#include <random>

#include "core/evolution/parameters.h"
#include "core/volume/volume.h"

namespace handlebody {

//! What may differ from one run to the next.
struct Perturbation {
  double clickVoxels = 1;  //!< clicks are moved by up to so many voxels along each axis
  double smoothing = 0.2;  //!< part by which the smoothing is less or more
  double noise = 0;        //!< intensities: standard deviation of what is added to each voxel
};

//! Standard deviation of the noise around a place (mm, LPS) of the volume, intensities.
double noiseNear(const Volume& volume, const Vec3& place);

//! The volume with white noise of that deviation added, rounded and clamped to its type; padding stays, and
//! voxels that were not a number are still known as such (not_a_number.h).
Volume withNoise(const Volume& volume, double deviation, std::mt19937_64& random);

//! `request` as it was used, with clicks, smoothing and the ends of a given range perturbed. On one thread.
Request perturbed(const Request& request, const ResolvedParameters& used, const Grid& grid,
                  const Perturbation& by, std::mt19937_64& random);

}  // namespace handlebody
