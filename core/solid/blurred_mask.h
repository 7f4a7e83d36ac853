#pragma once
// A mask blurred: what a smooth surface follows.

#include <vector>

#include "core/solid/mask.h"

namespace handlebody {

//! Values on the mask's grid and some voxels around it.
class BlurredMask {
 public:
  //! Gaussian, standard deviations in voxels along each axis, each above 0. Takes 4 bytes per voxel, twice
  //! while it is made.
  BlurredMask(const Mask& mask, const Vec3& sigma);

  //! Between 0 and 1, trilinear, at a continuous index of the mask; beyond the outermost as there.
  double at(const Vec3& index) const;
  //! By central differences over a voxel, per voxel.
  Vec3 gradient(const Vec3& index) const;

 private:
  std::array<int, 3> size_, margin_;
  std::vector<float> values_;
};

}  // namespace handlebody
