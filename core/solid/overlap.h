#pragma once
// How much of two objects lies in the same place, counted on a lattice of points.

#include "core/solid/solid.h"

namespace handlebody {

struct Overlap {
  double a = 0, b = 0, both = 0;  //!< mm³: points inside, times the volume that each stands for
  Vec3 spacing{1, 1, 1};          //!< mm, of the lattice
  bool onVoxels = false;          //!< its points are the centres of a label map's voxels
};

//! A point is inside of a label map if the voxel around it is, and inside of a mesh if a ray from it crosses
//! the mesh an odd number of times. The lattice is that of the label map with the smaller voxels, carried on
//! as far as the objects reach; for two meshes a cubic one along the axes, of `spacing` mm if that is above
//! 0, else of 1/256 of the cube root of the larger object's box. Made coarser by twos while one box has more
//! than kMaxLatticePoints. Needs 32 MB besides the objects, more where one plane of the lattice does.
//! Precondition: both are closed and not empty.
Overlap overlapOf(const Solid& a, const Solid& b, double spacing = 0);

inline constexpr double kMaxLatticePoints = 0x1p28;

}  // namespace handlebody
