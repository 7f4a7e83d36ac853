#include "core/evolution/row_flood.h"

#include <bit>
#include <utility>

#include "core/cancellation.h"

namespace handlebody::region {

RowFlood::RowFlood(GrowingRegion& region, int level) : region_(region) { begin(level); }

void RowFlood::begin(int level) {
  level_ = level;
  end_ = region_.queues.endOf(level);
  region_.queues.waitUntil(level + 1);  // what this level does not let in
}

std::size_t RowFlood::drainRestOf(int level, std::size_t q, std::size_t taken) {
  begin(level);
  const std::vector<Brick*> begun = std::exchange(region_.queues.bricksOf(level), {});
  for (; q < begun.size(); ++q) {
    Brick& brick = *begun[q];
    const std::vector<Entry> waiting = std::exchange(brick.waiting[level], {});
    for (const Entry& entry : waiting) brick.forget(entry.place);
    for (const Entry& entry : waiting)
      reach(brick, entry.place >> kShift, RowBits{1} << (entry.place & kBrickMask));
  }
  return drain(taken);
}

//! Has the rows of a brick looked at for this level.
void RowFlood::look(Brick& brick) const {
  if (brick.rowLevel == level_) return;
  brick.rowLevel = level_;
  brick.taken = brick.todo = {};
  brick.rows.clear();
  for (int row = 0; row < kRows; ++row)
    brick.low[row] = rowBelow(brick.values + rowIndex(row), region_.bricks.sign(), end_);
}

void RowFlood::reach(Brick& brick, int row, RowBits bits) {
  look(brick);
  bits &= ~brick.seen[row];
  const RowBits low = bits & brick.low[row];
  for (RowBits high = bits & ~low; high != 0; high &= high - 1) {
    const auto place = static_cast<BrickVoxel>(row << kShift | std::countr_zero(high));
    brick.visit(place);
    region_.queues.add(brick, place, region_.bricks.value({&brick, place}));
  }
  if (low == 0) return;
  if (brick.rows.empty()) region_.queues.bricksOf(level_).push_back(&brick);
  if (brick.todo[row] == 0) brick.rows.push_back(row);
  brick.todo[row] |= low;
}

std::size_t RowFlood::drain(std::size_t taken) {
  std::vector<Brick*>& queue = region_.queues.bricksOf(level_);
  for (std::size_t q = 0; q < queue.size() && !region_.limits.isLeak(static_cast<double>(taken)); ++q) {
    giveUpIfCancelled();
    std::vector<int>& rows = queue[q]->rows;
    for (std::size_t r = 0; r < rows.size(); ++r) taken += takeRow(*queue[q], rows[r]);
    rows.clear();  // from here on the brick may come again
  }
  region_.queues.enter(level_);
  for (const auto& brick : region_.bricks.all())
    if (brick && brick->rowLevel == level_) addEdges(*brick);
  return taken;
}

std::size_t RowFlood::takeRow(Brick& brick, int row) {
  const RowBits free = brick.low[row] & ~brick.seen[row];
  const RowBits start = std::exchange(brick.todo[row], 0) & free;
  if (start == 0) return 0;
  const RowBits taken = fillRow(start, free);
  brick.seen[row] |= taken;
  brick.taken[row] |= taken;
  reachAround(brick, row, taken);
  if (brick.onBorder) countBorder(brick, row, taken);
  return static_cast<std::size_t>(std::popcount(taken));
}

//! The voxels beside those that were taken: along the row, and in the four rows beside it.
void RowFlood::reachAround(Brick& brick, int row, RowBits taken) {
  ReachedBricks& bricks = region_.bricks;
  reach(brick, row, taken << 1 | taken >> 1);
  if (Brick* before = taken & 1 ? bricks.beyond(brick, 0, 0) : nullptr)
    reach(*before, row, RowBits{1} << kBrickMask);
  if (Brick* after = taken >> kBrickMask ? bricks.beyond(brick, 0, 1) : nullptr) reach(*after, row, 1);
  const auto place = static_cast<BrickVoxel>(row << kShift);
  for (int axis : {1, 2})
    for (int side : {0, 1}) {
      // The row beside is the neighbour of its first voxel.
      const Neighbour n = bricks.neighbour(brick, inBrick(place), place, axis, side);
      if (n.brick) reach(*n.brick, n.place >> kShift, taken);
    }
}

void RowFlood::countBorder(const Brick& brick, int row, RowBits taken) {
  for (; taken != 0; taken &= taken - 1) {
    const Voxel at{std::countr_zero(taken), row & kBrickMask, row >> kShift};
    if (region_.bricks.isOnBorder(brick.inGrid(at))) region_.limits.countBorderVoxel();
  }
}

//! Only voxels at the level itself lie on the boundary.
void RowFlood::addEdges(Brick& brick) {
  const float sign = region_.bricks.sign();
  const auto start = static_cast<float>(region_.queues.start());
  for (int row = 0; row < kRows; ++row) {
    if (brick.taken[row] == 0) continue;
    const float* values = brick.values + rowIndex(row);
    RowBits edge = brick.taken[row] & ~rowBelow(values, sign, start);
    for (; edge != 0; edge &= edge - 1) {
      const int x = std::countr_zero(edge);
      region_.edges.add(brick, {static_cast<BrickVoxel>(row << kShift | x), sign * values[x]}, level_);
    }
  }
}

}  // namespace handlebody::region
