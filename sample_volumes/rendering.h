#pragma once
// From a signal in contrasts (0 = object, 1 = background) to a volume: partial voxels, noise, intensities.

#include <cstdint>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody::phantoms {

inline constexpr double kDisplayLow = -0.5;  //!< grey 0 and 255 of the uint8 scale, in contrasts
inline constexpr double kDisplayHigh = 1.625;

//! Part of a voxel that is inside, for the signed distance d (mm, negative inside) and unit normal n of a
//! surface at its centre. A voxel's width along n has the variance sum(n_a² h_a²)/12 whatever n is; the
//! smooth step has that variance too, and is 1/2 at distance 0.
double coveredPart(double d, const Vec3& normal, const Vec3& spacing);

enum class NoiseKind {
  white,   //!< Gaussian
  speckle  //!< log-compressed Rayleigh, of an ultrasound image
};

//! Adds noise of that standard deviation, in contrasts.
void addNoise(NoiseKind kind, const Grid& grid, double deviation, std::uint64_t seed,
              std::vector<float>& signal);

//! Throws UsageError for a type that phantoms do not have (uint8, int16 and float32).
void requirePhantomType(VoxelType type);

//! Precondition: requirePhantomType.
Volume toVolume(const Grid& grid, VoxelType type, const std::vector<float>& signal);

}  // namespace handlebody::phantoms
