#pragma once
// The bricks of a volume that a growing region has reached, and the way from voxel to voxel across them.

#include <memory>
#include <vector>

#include "core/evolution/region_brick.h"
#include "core/indices.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody::region {

//! A voxel beside another one. Null brick: outside the grid.
struct Neighbour {
  Brick* brick;
  BrickVoxel place;
};

inline bool isInside(const Grid& grid, const Voxel& v) {
  const auto& n = grid.size;
  return v.i >= 0 && v.j >= 0 && v.k >= 0 && v.i < n[0] && v.j < n[1] && v.k < n[2];
}

//! True if all neighbours of the voxel lie in its brick.
inline bool isWithin(const Brick& brick, const Voxel& at) {
  return at.i > 0 && at.j > 0 && at.k > 0 && at.i < brick.last.i && at.j < brick.last.j &&
         at.k < brick.last.k;
}

//! A brick is made when it is first asked for.
class ReachedBricks {
 public:
  //! `sign`, +1 or -1, is what values are multiplied by.
  ReachedBricks(const SmoothedVolume& volume, float sign);

  const SmoothedVolume& volume() const { return volume_; }
  float sign() const { return sign_; }
  //! By their place in the volume; null: not reached.
  const std::vector<std::unique_ptr<Brick>>& all() const { return bricks_; }
  //! The brick that holds a voxel of the grid.
  Brick& holding(const Voxel& v) { return brickAt({v.i >> kShift, v.j >> kShift, v.k >> kShift}); }

  //! The voxel before (side 0) or after (side 1) the given one along an axis.
  Neighbour neighbour(Brick& brick, const Voxel& at, BrickVoxel place, int axis, int side) {
    const int stride = kPlaceStride[axis];
    const int local = at.along(axis);
    if (side == 0 ? local > 0 : local < brick.last.along(axis))
      return {&brick, static_cast<BrickVoxel>(side == 0 ? place - stride : place + stride)};
    return {beyond(brick, axis, side), static_cast<BrickVoxel>(place ^ kBrickMask * stride)};
  }
  //! The brick before or after the given one; null: outside the grid.
  Brick* beyond(Brick& brick, int axis, int side);

  float value(const Neighbour& n) const { return sign_ * n.brick->values[valueIndex(inBrick(n.place))]; }
  bool isOnBorder(const Voxel& v) const {
    const auto& n = volume_.grid().size;
    return v.i == 0 || v.j == 0 || v.k == 0 || v.i == n[0] - 1 || v.j == n[1] - 1 || v.k == n[2] - 1;
  }
  bool isBesidePadding(const Voxel& v) const;

 private:
  Brick& brickAt(const Voxel& at);
  std::unique_ptr<Brick> made(const Voxel& at) const;
  void markPadding(Brick& brick) const;
  bool isPadding(const Voxel& v) const {
    const auto& size = volume_.grid().size;
    return volume_.isPadding((idx(v.k) * idx(size[1]) + idx(v.j)) * idx(size[0]) + idx(v.i));
  }

  const SmoothedVolume& volume_;
  float sign_;
  std::vector<std::unique_ptr<Brick>> bricks_;
};

}  // namespace handlebody::region
