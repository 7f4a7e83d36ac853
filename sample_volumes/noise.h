#pragma once
// Random fields for phantoms. Counter-based: the value of a voxel depends on its index and the seed alone,
// and on no generator of the standard library, so that it is the same on every platform (up to the last bit
// of log, sin and cos).

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody::phantoms {

//! Two independent standard normal numbers (Box and Muller) of a seed and a counter.
std::pair<double, double> normalPair(std::uint64_t seed, std::uint64_t counter);

//! Envelope of fully developed speckle: the magnitude of complex white Gaussian noise convolved with a
//! Gaussian point spread function whose standard deviations are `spread` (mm along each axis of the grid).
//! Rayleigh distributed with mean square 1; the field is periodic.
std::vector<float> speckleEnvelope(const Grid& grid, const Vec3& spread, std::uint64_t seed);

//! Log-compressed envelope, shifted and scaled to mean 0 and standard deviation 1: 20·log10 of a Rayleigh
//! amplitude with mean square 1 has mean -2.507 dB and standard deviation 5.570 dB.
double compressedSpeckle(double envelope);

}  // namespace handlebody::phantoms
