#pragma once
// The connected voxels that hold the seeds and lie inside of a boundary level.

#include <array>
#include <cstdint>
#include <vector>

#include "core/evolution/level_field.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

class Barrier;  // neck.h

//! Yes or no for each voxel of a box, or of a region in its order: 0 is no.
using VoxelMarks = std::vector<unsigned char>;

//! A connected region of voxels (face neighbours), and the faces between it and the rest of the volume.
struct ObjectRegion {
  using Voxel = std::array<std::int32_t, 3>;
  //! A face between a voxel of the region and its outer neighbour along `axis` (`step` = +1 or -1).
  struct Face {
    std::int32_t voxel;  //!< index into `voxels`: the inner side
    std::int8_t axis;
    std::int8_t step;
  };
  std::vector<Voxel> voxels;  //!< in the order in which the flood took them: a ball grows round each seed
  std::vector<Face> faces;    //!< without those towards padding and the border of the volume; voxel by voxel
  std::size_t againstPadding = 0;  //!< faces towards padding
  std::size_t atBorder = 0;        //!< faces on the border of the volume
  bool whole = true;               //!< false: ended at `mostVoxels`
};

//! Floods from the voxels around `seeds` (continuous indices) over voxels whose intensity times `sign` is
//! below the level there times `sign`: +1 for a dark object, -1 for a bright one. Padding is outside. What
//! `barrier` (may be null) closes is, too, and has no faces.
ObjectRegion floodObject(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                         const LevelField& levels, std::size_t mostVoxels, const Barrier* barrier = nullptr);

}  // namespace handlebody
