#include "core/evolution/voxel_flood.h"

#include "core/cancellation.h"

namespace handlebody::region {

namespace {

// A level that lets in more than this is taken in by rows: looking at all rows of the bricks costs as much.
constexpr std::size_t kManyVoxels = 60'000;
constexpr std::size_t kAhead = 6;  // entries whose values are fetched from memory before their turn
constexpr std::size_t kBetweenLooks = 16384;  // voxels: a millisecond

//! The values that take() will ask for: a level has few voxels in each brick, which lie anywhere in it.
void prefetchAround(const Brick& brick, BrickVoxel place) {
  const float* here = brick.values + valueIndex(inBrick(place));
  __builtin_prefetch(here);
  for (const int stride : {kValueStride[1], kValueStride[2]})
    for (const int side : {-stride, stride}) __builtin_prefetch(here + side);
}

}  // namespace

std::size_t VoxelFlood::drain(int level) {
  region_.queues.enter(level);
  std::vector<Brick*>& queue = region_.queues.bricksOf(level);
  std::size_t taken = 0;
  for (std::size_t q = 0; q < queue.size(); ++q) {
    Brick& brick = *queue[q];
    std::vector<Entry>& waiting = brick.waiting[level];
    for (std::size_t i = 0; i < waiting.size(); ++i, ++taken) {
      if (taken % kBetweenLooks == 0) giveUpIfCancelled();
      if (region_.limits.isLeak(static_cast<double>(taken))) return taken;
      if (taken == kManyVoxels) {
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(i));
        return rows_.drainRestOf(level, q, taken);
      }
      if (i + kAhead < waiting.size()) prefetchAround(brick, waiting[i + kAhead].place);
      take(brick, Entry(waiting[i]), level);  // a copy: more come to those that wait
    }
    waiting = {};  // from here on the brick may come again
  }
  return taken;
}

void VoxelFlood::take(Brick& brick, const Entry& entry, int level) {
  const Voxel at = inBrick(entry.place);
  if (brick.onBorder && region_.bricks.isOnBorder(brick.inGrid(at))) region_.limits.countBorderVoxel();
  if (isWithin(brick, at))
    reachWithin(brick, at, entry.place);
  else
    reachAround(brick, at, entry.place);
  // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
  // joined.
  if (entry.value >= region_.queues.start()) region_.edges.add(brick, entry, level);
}

//! Queues the neighbours that have not been seen before.
void VoxelFlood::reachAround(Brick& brick, const Voxel& at, BrickVoxel place) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, 1}) {
      const Neighbour n = region_.bricks.neighbour(brick, at, place, axis, side);
      if (n.brick && n.brick->visit(n.place)) region_.queues.add(*n.brick, n.place, region_.bricks.value(n));
    }
}

//! The same, in the same order, of a voxel all of whose neighbours lie in its brick.
void VoxelFlood::reachWithin(Brick& brick, const Voxel& at, BrickVoxel place) {
  const float* here = brick.values + valueIndex(at);
  const float sign = region_.bricks.sign();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const auto beside = static_cast<BrickVoxel>(place + side * kPlaceStride[axis]);
      const int apart = side * kValueStride[axis];
      if (brick.visit(beside)) region_.queues.add(brick, beside, sign * here[apart]);
    }
}

}  // namespace handlebody::region
