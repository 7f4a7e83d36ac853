#pragma once
// The equally spaced levels of a region growth, and the voxels that wait for each of them.

#include <algorithm>
#include <limits>
#include <vector>

#include "core/evolution/region_brick.h"
#include "core/indices.h"

namespace handlebody::region {

//! Signed levels. Of each, the bricks with voxels that wait, first in, first out; the voxels are in the
//! brick.
class LevelQueues {
 public:
  LevelQueues(double lowest, double step)
      : lowest_(lowest), step_(step), perStep_(1 / step), bricks_(kBins) {}

  //! Where the level that is taken in begins.
  double start() const { return start_; }
  float endOf(int level) const { return static_cast<float>(lowest_ + step_ * (level + 1)); }
  std::vector<Brick*>& bricksOf(int level) { return bricks_[level]; }

  //! This level is taken in from now on.
  void enter(int level) {
    earliest_ = level;
    start_ = lowest_ + step_ * level;
  }
  //! Voxels that are added from now on wait for this level at least.
  void waitUntil(int level) { earliest_ = level; }

  void add(Brick& brick, BrickVoxel place, float signedValue) {
    const double level = signedValue < start_ ? earliest_ : (signedValue - lowest_) * perStep_;
    if (!(level < kBins) || earliest_ >= kBins) return;
    const std::size_t target = idx(std::max(static_cast<int>(level), earliest_));
    std::vector<Entry>& waiting = brick.waiting[target];
    if (waiting.empty()) bricks_[target].push_back(&brick);
    waiting.push_back({place, signedValue});
  }

 private:
  double lowest_, step_, perStep_;
  int earliest_ = 0;
  double start_ = -std::numeric_limits<double>::infinity();
  std::vector<std::vector<Brick*>> bricks_;  // per level
};

}  // namespace handlebody::region
