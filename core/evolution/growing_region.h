#pragma once
// What the two ways of letting a level in, by rows and voxel by voxel, share.

#include "core/evolution/level_edges.h"
#include "core/evolution/level_queues.h"
#include "core/evolution/reached_bricks.h"

namespace handlebody::region {

//! A leak into noise spreads through this many bricks at least; smaller volumes may be smoothed whole.
inline constexpr std::size_t kFewBricks = 300;

//! When a region is given up as a leak: it would have all of a large volume smoothed and kept.
class LeakLimits {
 public:
  explicit LeakLimits(const SmoothedVolume& volume);

  //! Of the region, on the faces of the grid.
  void countBorderVoxel() { ++border_; }
  //! Part of the voxels on the faces of the grid that the region holds.
  double borderShare() const { return border_ / borderVoxels_; }
  //! `taken`: voxels of one level. Also by how much of the volume has been smoothed.
  bool isLeak(double taken) const {
    const bool isLarge = taken >= static_cast<double>(mostVoxels_) || volume_.bricksMade() > mostBricks_;
    return isLarge && border_ > mostBorder_;
  }
  //! True if one level has let in so much, and of the border, that none after it is that of an object.
  bool isBackground(std::size_t taken) const;

 private:
  const SmoothedVolume& volume_;
  std::size_t mostVoxels_;  // of one level
  std::size_t mostBricks_;
  double borderVoxels_;  // on the faces of the grid
  double mostBorder_;
  double border_ = 0;
};

struct GrowingRegion {
  GrowingRegion(const SmoothedVolume& volume, double sign, double lowest, double step)
      : bricks(volume, static_cast<float>(sign)), edges(bricks), queues(lowest, step), limits(volume) {}
  GrowingRegion(const GrowingRegion&) = delete;  // its parts know each other
  GrowingRegion& operator=(const GrowingRegion&) = delete;

  ReachedBricks bricks;
  LevelEdges edges;
  LevelQueues queues;
  LeakLimits limits;
};

}  // namespace handlebody::region
