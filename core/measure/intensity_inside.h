#pragma once

#include <cstddef>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Of the voxels whose centre lies inside of a mesh, in the volume's own intensities; all 0 if there is none.
struct IntensityInside {
  std::size_t voxels = 0;
  double mean = 0;
  double deviation = 0;  //!< standard deviation, divided by n - 1; 0 for one voxel
  double minimum = 0, maximum = 0;
  std::size_t withoutValue = 0;  //!< further voxels inside, that are NaN or infinite
  bool isWhole = true;           //!< no part of the mesh lies beyond the volume's voxels
};

//! What a label map on a grid has of a mesh.
struct VoxelsInside {
  std::size_t count = 0;  //!< voxels whose centre lies inside
  bool isWhole = true;    //!< no part of the mesh lies beyond the grid's voxels
};

//! Both need a byte per voxel of the mesh's box. Precondition: the mesh is closed.
VoxelsInside voxelsInside(const TriangleSoup& mesh, const Grid& grid);
IntensityInside intensityInside(const TriangleSoup& mesh, const Volume& volume);

}  // namespace handlebody
