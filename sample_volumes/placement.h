#pragma once
// Where a phantom's shape lies in the world, and the grid that samples it.

#include "core/volume/volume.h"
#include "sample_volumes/phantom.h"
#include "sample_volumes/shapes.h"

namespace handlebody::phantoms {

struct Placement {
  Grid grid;
  Vec3 centre{0, 0, 0};  //!< world mm: centre of the volume, the shape's 0; the same for all options
  Vec3 corner{0, 0, 0};  //!< mm in the shape's frame: centre of voxel (0,0,0)
  Hole hole;

  Vec3 toWorld(const Vec3& p) const { return centre + grid.direction * p; }
  Vec3 toShape(const Vec3& world) const { return grid.direction.transpose() * (world - centre); }
};

//! Checks all options but `type`; throws UsageError for one without meaning.
Placement placeShape(const Shape& shape, const PhantomOptions& options);

inline double darkDistance(const Shape& shape, const Hole& hole, const Vec3& p) {
  return shape.dark ? shape.dark(p, hole) : shape.distance(p);
}

}  // namespace handlebody::phantoms
