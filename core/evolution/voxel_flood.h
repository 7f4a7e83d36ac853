#pragma once
// A level of a region growth let in voxel by voxel, as most levels are.

#include <cstddef>

#include "core/evolution/row_flood.h"

namespace handlebody::region {

class VoxelFlood {
 public:
  //! `rows` takes over where a level lets in a great deal.
  VoxelFlood(GrowingRegion& region, RowFlood& rows) : region_(region), rows_(rows) {}

  //! Takes in all voxels that the level lets in, also those behind them that are lower. Brick by brick, so
  //! that what it touches stays in the cache; the bricks first in, first out, so that the region grows like a
  //! ball. Returns how many voxels.
  std::size_t drain(int level);

 private:
  void take(Brick& brick, const Entry& entry, int level);
  void reachAround(Brick& brick, const Voxel& at, BrickVoxel place);
  void reachWithin(Brick& brick, const Voxel& at, BrickVoxel place);

  GrowingRegion& region_;
  RowFlood& rows_;
};

}  // namespace handlebody::region
