#pragma once
// A level of a region growth let in by rows of bricks. The first level lets in half of the object at once,
// and of the opposite kind of object all around it; and in noise there is one that joins most of the rest.

#include <cstddef>

#include "core/evolution/growing_region.h"

namespace handlebody::region {

//! A row at a time of the level that was begun last.
class RowFlood {
 public:
  RowFlood(GrowingRegion& region, int level);

  void begin(int level);
  //! Goes on with a level that was begun voxel by voxel, from place q in its queue on. Returns how many
  //! voxels it has let in, with the `taken` ones of before.
  std::size_t drainRestOf(int level, std::size_t q, std::size_t taken);
  //! Voxels of a row beside voxels that were taken. Those above the level wait for theirs.
  void reach(Brick& brick, int row, RowBits bits);
  //! Takes in what the level lets in, brick by brick. `taken`: what it has let in already.
  std::size_t drain(std::size_t taken = 0);

 private:
  void look(Brick& brick) const;
  std::size_t takeRow(Brick& brick, int row);
  void reachAround(Brick& brick, int row, RowBits taken);
  void countBorder(const Brick& brick, int row, RowBits taken);
  void addEdges(Brick& brick);

  GrowingRegion& region_;
  int level_ = 0;
  float end_ = 0;  // of the level
};

}  // namespace handlebody::region
