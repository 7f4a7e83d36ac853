#include "core/evolution/reached_bricks.h"

#include <algorithm>
#include <array>

namespace handlebody::region {

ReachedBricks::ReachedBricks(const SmoothedVolume& volume, float sign)
    : volume_(volume), sign_(sign), bricks_(volume.brickCount()) {}

Brick* ReachedBricks::beyond(Brick& brick, int axis, int side) {
  Brick*& other = brick.neighbours[2 * axis + side];
  if (other) return other;
  std::array<int, 3> at{brick.first.i / kBrick, brick.first.j / kBrick, brick.first.k / kBrick};
  at[axis] += 2 * side - 1;
  if (at[axis] < 0 || at[axis] >= volume_.bricks()[axis]) return nullptr;
  return other = &brickAt({at[0], at[1], at[2]});
}

//! By the brick's place among the bricks.
Brick& ReachedBricks::brickAt(const Voxel& at) {
  const std::array<int, 3>& n = volume_.bricks();
  std::unique_ptr<Brick>& brick = bricks_[(at.k * n[1] + at.j) * n[0] + at.i];
  if (!brick) brick = made(at);
  return *brick;
}

std::unique_ptr<Brick> ReachedBricks::made(const Voxel& at) const {
  const std::array<int, 3>&n = volume_.bricks(), &size = volume_.grid().size;
  auto brick = std::make_unique<Brick>();
  brick->values = volume_.brick(at.i, at.j, at.k);
  brick->first = {at.i * kBrick, at.j * kBrick, at.k * kBrick};
  brick->last = {std::min(kBrickMask, size[0] - 1 - brick->first.i),
                 std::min(kBrickMask, size[1] - 1 - brick->first.j),
                 std::min(kBrickMask, size[2] - 1 - brick->first.k)};
  brick->onBorder =
      at.i == 0 || at.j == 0 || at.k == 0 || at.i == n[0] - 1 || at.j == n[1] - 1 || at.k == n[2] - 1;
  for (int row = 0; row < kRows; ++row) {
    const bool inGrid = (row & kBrickMask) <= brick->last.j && row >> kShift <= brick->last.k;
    brick->seen[row] = inGrid ? ~(~RowBits{0} >> (kBrickMask - brick->last.i)) : ~RowBits{0};
  }
  if (volume_.hasPadding()) markPadding(*brick);
  return brick;
}

//! Padding is never entered.
void ReachedBricks::markPadding(Brick& brick) const {
  for (int k = 0; k <= brick.last.k; ++k)
    for (int j = 0; j <= brick.last.j; ++j)
      for (int i = 0; i <= brick.last.i; ++i)
        if (isPadding(brick.inGrid({i, j, k}))) brick.visit(placeOf({i, j, k}));
}

bool ReachedBricks::isBesidePadding(const Voxel& v) const {
  for (int d : {-1, 1})
    for (const Voxel& w : {Voxel{v.i + d, v.j, v.k}, Voxel{v.i, v.j + d, v.k}, Voxel{v.i, v.j, v.k + d}})
      if (isInside(volume_.grid(), w) && isPadding(w)) return true;
  return false;
}

}  // namespace handlebody::region
