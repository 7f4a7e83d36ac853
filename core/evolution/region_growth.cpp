#include "core/evolution/region_growth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/cancellation.h"
#include "core/evolution/region_brick.h"
#include "core/indices.h"

namespace handlebody {

namespace {

using namespace region;

// The growth goes on until it is this many voxels, or this many times what it was at its strongest edge: by
// then it has leaked, and nothing but time and memory is spent.
constexpr double kEnoughVoxels = 120'000;
constexpr double kEnoughTimes = 2;
// A region that has reached the faces of the volume with more than this part of them, and has touched a
// fifth of a large volume, is given up as a leak. What lies within the volume may fill any part of it.
constexpr double kReachesBorder = 3e-3;
constexpr std::size_t kFewBricks = 300;
constexpr std::size_t kPartOfVolume = 5;
// And so is one of which one level lets in more than this, and a fifth of the volume.
constexpr std::size_t kMaxVoxels = 2'000'000;
// If it has let in more than this part of the volume's border with it, it is the background: no level after
// it is that of an object.
constexpr double kBackground = 0.5;

// A level that lets in more than this is taken in by rows: looking at all rows of the bricks costs as much.
constexpr std::size_t kManyVoxels = 60'000;
constexpr std::size_t kAhead = 6;  // entries whose values are fetched from memory before their turn
constexpr std::size_t kBetweenLooks = 16384;  // voxels: a millisecond

bool isInside(const Grid& grid, const Voxel& v) {
  const auto& n = grid.size;
  return v.i >= 0 && v.j >= 0 && v.k >= 0 && v.i < n[0] && v.j < n[1] && v.k < n[2];
}

double voxelsOnFaces(const Grid& grid) {
  const auto& n = grid.size;
  return static_cast<double>(grid.voxelCount()) -
         std::max(0.0, n[0] - 2.0) * std::max(0.0, n[1] - 2.0) * std::max(0.0, n[2] - 2.0);
}

class Flood {
 public:
  //! `first`: the level of the lowest seed; up to it nothing grows.
  Flood(const SmoothedVolume& volume, double sign, double lowest, double highest, int first)
      : volume_(volume),
        sign_(static_cast<float>(sign)),
        lowest_(lowest),
        step_((highest - lowest) / kBins),
        perStep_(1 / step_),
        first_(first),
        queue_(kBins),
        sumGradient_(kBins, 0),
        sumSquared_(kBins, 0),
        mostVoxels_(std::max(kMaxVoxels, volume.grid().voxelCount() / kPartOfVolume)),
        borderVoxels_(voxelsOnFaces(volume.grid())),
        bricks_(volume.brickCount()) {
    startRows(first);
  }

  void start(const Voxel& v) {
    Brick& brick = brickOf({v.i >> kShift, v.j >> kShift, v.k >> kShift});
    reach(brick, placeOf(v) >> kShift, RowBits{1} << (v.i & kBrickMask));
  }

  RegionGrowth run() {
    RegionGrowth growth{lowest_, step_, {}, {}, {}};
    double count = 0, strongest = 0, enough = kEnoughVoxels;
    for (int bin = 0; bin < kBins && count < enough && !isLeak(count / 2); ++bin) {
      const std::size_t taken = bin < first_ ? 0 : bin == first_ ? drainByRows() : drain(bin);
      count += static_cast<double>(taken);
      growth.voxels.push_back(count);
      growth.border.push_back(border_ / borderVoxels_);
      if (taken >= mostVoxels_ && growth.border.back() > kBackground) break;
      const double edge = sumGradient_[bin] > 0 ? sumSquared_[bin] / sumGradient_[bin] : 0;
      if (edge <= strongest) continue;
      strongest = edge;
      enough = std::max(kEnoughVoxels, kEnoughTimes * count);
    }
    growth.whole = count >= enough || growth.voxels.size() == kBins;
    growth.edge = edgeStrength(growth.voxels.size());
    return growth;
  }

 private:
  //! A leak into noise spreads thinly through the whole volume, and would have all of it smoothed and kept.
  bool isLeak(double taken) const {
    const bool isLarge = taken >= static_cast<double>(mostVoxels_) ||
                         volume_.bricksMade() > std::max(kFewBricks, volume_.brickCount() / kPartOfVolume);
    return isLarge && border_ > kReachesBorder * borderVoxels_;
  }
  std::size_t indexOf(const Voxel& v) const {
    const auto& size = volume_.grid().size;
    return (idx(v.k) * idx(size[1]) + idx(v.j)) * idx(size[0]) + idx(v.i);
  }
  bool isOnBorder(const Voxel& v) const {
    const auto& n = volume_.grid().size;
    return v.i == 0 || v.j == 0 || v.k == 0 || v.i == n[0] - 1 || v.j == n[1] - 1 || v.k == n[2] - 1;
  }
  bool isPadding(const Voxel& v) const { return volume_.isPadding(indexOf(v)); }

  //! By the brick's place among the bricks.
  Brick& brickOf(const Voxel& at) {
    const std::array<int, 3>& n = volume_.bricks();
    std::unique_ptr<Brick>& brick = bricks_[(at.k * n[1] + at.j) * n[0] + at.i];
    if (!brick) brick = makeBrick(at);
    return *brick;
  }
  std::unique_ptr<Brick> makeBrick(const Voxel& at) const {
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
  void markPadding(Brick& brick) const {
    for (int k = 0; k <= brick.last.k; ++k)
      for (int j = 0; j <= brick.last.j; ++j)
        for (int i = 0; i <= brick.last.i; ++i)
          if (isPadding(brick.inGrid({i, j, k}))) brick.visit(placeOf({i, j, k}));
  }

  //! The voxel before (side 0) or after (side 1) the given one along an axis. Null patch: outside the grid.
  struct Neighbour {
    Brick* brick;
    BrickVoxel place;
  };
  Neighbour neighbour(Brick& brick, const Voxel& at, BrickVoxel place, int axis, int side) {
    const int stride = kPlaceStride[axis];
    const int local = at.along(axis);
    if (side == 0 ? local > 0 : local < brick.last.along(axis))
      return {&brick, static_cast<BrickVoxel>(side == 0 ? place - stride : place + stride)};
    return {beyond(brick, axis, side), static_cast<BrickVoxel>(place ^ kBrickMask * stride)};
  }
  float value(const Neighbour& n) const { return sign_ * n.brick->values[valueIndex(inBrick(n.place))]; }

  Brick* beyond(Brick& brick, int axis, int side) {
    Brick*& other = brick.neighbours[2 * axis + side];
    if (other) return other;
    std::array<int, 3> at{brick.first.i / kBrick, brick.first.j / kBrick, brick.first.k / kBrick};
    at[axis] += 2 * side - 1;
    if (at[axis] < 0 || at[axis] >= volume_.bricks()[axis]) return nullptr;
    return other = &brickOf({at[0], at[1], at[2]});
  }

  //! Queues the voxel if it has not been seen before.
  void push(const Neighbour& n) {
    if (n.brick->visit(n.place)) queue(*n.brick, n.place, value(n));
  }
  void queue(Brick& brick, BrickVoxel place, float signedValue) {
    const double bin = signedValue < levelStart_ ? level_ : (signedValue - lowest_) * perStep_;
    if (!(bin < kBins) || level_ >= kBins) return;
    const std::size_t target = idx(std::max(static_cast<int>(bin), level_));
    std::vector<Entry>& waiting = brick.waiting[target];
    if (waiting.empty()) queue_[target].push_back(&brick);
    waiting.push_back({place, signedValue});
  }

  // The first level lets in half of the object at once, and of the opposite kind of object all around it; and
  // in noise there is one that joins most of the rest. Such levels are taken in a row of a brick at a time.

  void startRows(int bin) {
    rowLevel_ = bin;
    rowEnd_ = static_cast<float>(lowest_ + step_ * (bin + 1));
    level_ = bin + 1;  // what this level does not let in waits for the next one at least
  }

  //! Has the rows of a brick looked at for the level that is taken in by rows.
  void lookAtRows(Brick& brick) const {
    if (brick.rowLevel == rowLevel_) return;
    brick.rowLevel = rowLevel_;
    brick.taken = brick.todo = {};
    brick.rows.clear();
    for (int row = 0; row < kRows; ++row)
      brick.low[row] = rowBelow(brick.values + rowIndex(row), sign_, rowEnd_);
  }

  //! Voxels of a row beside voxels that were taken. Those above the level wait for theirs.
  void reach(Brick& brick, int row, RowBits bits) {
    lookAtRows(brick);
    bits &= ~brick.seen[row];
    const RowBits high = bits & ~brick.low[row];
    for (RowBits left = high; left != 0; left &= left - 1)
      push({&brick, static_cast<BrickVoxel>(row << kShift | std::countr_zero(left))});
    if ((bits & brick.low[row]) == 0) return;
    if (brick.rows.empty()) queue_[rowLevel_].push_back(&brick);
    if (brick.todo[row] == 0) brick.rows.push_back(row);
    brick.todo[row] |= bits & brick.low[row];
  }

  //! Takes in what the level lets in, brick by brick. `taken`: what it has let in already.
  std::size_t drainByRows(std::size_t taken = 0) {
    std::vector<Brick*>& queue = queue_[rowLevel_];
    for (std::size_t q = 0; q < queue.size() && !isLeak(static_cast<double>(taken)); ++q) {
      giveUpIfCancelled();
      std::vector<int>& rows = queue[q]->rows;
      for (std::size_t r = 0; r < rows.size(); ++r) taken += takeRow(*queue[q], rows[r]);
      rows.clear();  // from here on the brick may come again
    }
    level_ = rowLevel_;
    levelStart_ = lowest_ + step_ * level_;
    for (const auto& brick : bricks_)
      if (brick && brick->rowLevel == rowLevel_) addRowEdges(*brick);
    return taken;
  }

  //! Goes on by rows with a level that was begun voxel by voxel, from place q in its queue on.
  std::size_t drainRestByRows(std::size_t q, std::size_t taken) {
    startRows(level_);
    const std::vector<Brick*> begun = std::exchange(queue_[rowLevel_], {});
    for (; q < begun.size(); ++q) {
      Brick& brick = *begun[q];
      const std::vector<Entry> waiting = std::exchange(brick.waiting[rowLevel_], {});
      for (const Entry& entry : waiting) brick.forget(entry.place);
      for (const Entry& entry : waiting)
        reach(brick, entry.place >> kShift, RowBits{1} << (entry.place & kBrickMask));
    }
    return drainByRows(taken);
  }

  std::size_t takeRow(Brick& brick, int row) {
    const RowBits free = brick.low[row] & ~brick.seen[row];
    const RowBits start = std::exchange(brick.todo[row], 0) & free;
    if (start == 0) return 0;
    const RowBits taken = fillRow(start, free);
    brick.seen[row] |= taken;
    brick.taken[row] |= taken;
    reach(brick, row, taken << 1 | taken >> 1);
    if (Brick* before = taken & 1 ? beyond(brick, 0, 0) : nullptr)
      reach(*before, row, RowBits{1} << kBrickMask);
    if (Brick* after = taken >> kBrickMask ? beyond(brick, 0, 1) : nullptr) reach(*after, row, 1);
    for (int axis : {1, 2})
      for (int side : {0, 1}) {
        // The row beside is the neighbour of its first voxel.
        const auto place = static_cast<BrickVoxel>(row << kShift);
        const Neighbour n = neighbour(brick, inBrick(place), place, axis, side);
        if (n.brick) reach(*n.brick, n.place >> kShift, taken);
      }
    if (brick.onBorder) countBorder(brick, row, taken);
    return static_cast<std::size_t>(std::popcount(taken));
  }

  void countBorder(const Brick& brick, int row, RowBits taken) {
    for (; taken != 0; taken &= taken - 1)
      if (isOnBorder(brick.inGrid({std::countr_zero(taken), row & kBrickMask, row >> kShift}))) ++border_;
  }

  void addRowEdges(Brick& brick) {
    for (int row = 0; row < kRows; ++row) {
      if (brick.taken[row] == 0) continue;
      const float* values = brick.values + rowIndex(row);
      RowBits edge = brick.taken[row] & ~rowBelow(values, sign_, static_cast<float>(levelStart_));
      for (; edge != 0; edge &= edge - 1) {
        const int x = std::countr_zero(edge);
        const auto place = static_cast<BrickVoxel>(row << kShift | x);
        addEdge(brick, {place, sign_ * values[x]}, inBrick(place));
      }
    }
  }

  // Most levels: a voxel at a time.

  //! Takes in all voxels that the level of this bin lets in, also those behind them that are lower. Brick by
  //! brick, so that what it touches stays in the cache; the bricks first in, first out, so that the region
  //! grows like a ball.
  std::size_t drain(int bin) {
    level_ = bin;
    levelStart_ = lowest_ + step_ * bin;
    std::size_t taken = 0;
    for (std::size_t q = 0; q < queue_[bin].size(); ++q) {
      Brick& brick = *queue_[bin][q];
      std::vector<Entry>& waiting = brick.waiting[bin];
      for (std::size_t i = 0; i < waiting.size(); ++i, ++taken) {
        if (taken % kBetweenLooks == 0) giveUpIfCancelled();
        if (isLeak(static_cast<double>(taken))) return taken;
        if (taken == kManyVoxels) {
          waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(i));
          return drainRestByRows(q, taken);
        }
        if (i + kAhead < waiting.size()) prefetchAround(brick, waiting[i + kAhead].place);
        take(brick, Entry(waiting[i]));
      }
      waiting = {};  // from here on the brick may come again
    }
    return taken;
  }

  //! The values that take() will ask for: a level has few voxels in each brick, which lie anywhere in it.
  static void prefetchAround(const Brick& brick, BrickVoxel place) {
    const float* here = brick.values + valueIndex(inBrick(place));
    __builtin_prefetch(here);
    for (const int stride : {kValueStride[1], kValueStride[2]})
      for (const int side : {-stride, stride}) __builtin_prefetch(here + side);
  }

  void take(Brick& brick, const Entry& entry) {
    const Voxel at = inBrick(entry.place);
    if (brick.onBorder && isOnBorder(brick.inGrid(at))) ++border_;
    if (isWithin(brick, at)) {
      pushWithin(brick, at, entry.place);
    } else {
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          const Neighbour n = neighbour(brick, at, entry.place, axis, side);
          if (n.brick) push(n);
        }
    }
    // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
    // joined.
    if (entry.value >= levelStart_) addEdge(brick, entry, at);
  }

  //! True if all neighbours of the voxel lie in its brick.
  static bool isWithin(const Brick& brick, const Voxel& at) {
    return at.i > 0 && at.j > 0 && at.k > 0 && at.i < brick.last.i && at.j < brick.last.j &&
           at.k < brick.last.k;
  }

  //! The neighbours of such a voxel, in the same order as of any other.
  void pushWithin(Brick& brick, const Voxel& at, BrickVoxel place) {
    const float* here = brick.values + valueIndex(at);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const auto beside = static_cast<BrickVoxel>(place + side * kPlaceStride[axis]);
        if (brick.visit(beside)) queue(brick, beside, sign_ * here[side * kValueStride[axis]]);
      }
  }

  //! Square of the gradient at such a voxel.
  double squaredGradientWithin(const Brick& brick, const Voxel& at) const {
    const float* here = brick.values + valueIndex(at);
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = sign_ * here[-kValueStride[axis]], high = sign_ * here[kValueStride[axis]];
      const double span = volume_.grid().spacing[static_cast<int>(axis)] * 2;
      squared += (high - low) * (high - low) / (span * span);
    }
    return squared;
  }

  //! Counts the gradient at a voxel of the boundary. Beside padding an edge says nothing about the object.
  void addEdge(Brick& brick, const Entry& entry, const Voxel& at) {
    if (volume_.hasPadding() && isBesidePadding(brick.inGrid(at))) return;
    const double squared =
        isWithin(brick, at) ? squaredGradientWithin(brick, at) : squaredGradient(brick, entry, at);
    sumGradient_[level_] += std::sqrt(squared);
    sumSquared_[level_] += squared;
  }

  double squaredGradient(Brick& brick, const Entry& entry, const Voxel& at) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Neighbour before = neighbour(brick, at, entry.place, axis, 0);
      const Neighbour after = neighbour(brick, at, entry.place, axis, 1);
      const double low = before.brick ? value(before) : entry.value;
      const double high = after.brick ? value(after) : entry.value;
      const double span = volume_.grid().spacing[axis] * ((before.brick ? 1 : 0) + (after.brick ? 1 : 0));
      if (span > 0) squared += (high - low) * (high - low) / (span * span);
    }
    return squared;
  }

  bool isBesidePadding(const Voxel& v) const {
    for (int d : {-1, 1})
      for (const Voxel& w : {Voxel{v.i + d, v.j, v.k}, Voxel{v.i, v.j + d, v.k}, Voxel{v.i, v.j, v.k + d}})
        if (isInside(volume_.grid(), w) && isPadding(w)) return true;
    return false;
  }

  //! The voxels of one bin fill a shell whose thickness is inverse to the gradient: weighting them with the
  //! gradient gives the mean over the surface. Averaged over a few bins against noise.
  std::vector<double> edgeStrength(std::size_t bins) const {
    constexpr int kHalfWidth = 4;
    std::vector<double> edge(bins, 0);
    for (int b = 0; b < static_cast<int>(bins); ++b) {
      double s1 = 0, s2 = 0;
      for (int c = std::max(0, b - kHalfWidth); c <= std::min(static_cast<int>(bins) - 1, b + kHalfWidth);
           ++c) {
        s1 += sumGradient_[c];
        s2 += sumSquared_[c];
      }
      edge[b] = s1 > 0 ? s2 / s1 : 0;
    }
    return edge;
  }

  const SmoothedVolume& volume_;
  float sign_;  // exact: +1 or -1
  double lowest_, step_, perStep_;
  int first_;                                                     // the first level that takes in anything
  int rowLevel_;                                                  // the one that is taken in by rows
  float rowEnd_;                                                  // and where it ends
  double border_ = 0;                                             // voxels taken on the faces of the grid
  int level_;                                                     // the bin that is being drained
  double levelStart_ = -std::numeric_limits<double>::infinity();  // its signed level
  std::vector<std::vector<Brick*>> queue_;                        // per bin: bricks with voxels that wait
  std::vector<double> sumGradient_, sumSquared_;
  std::size_t mostVoxels_;                      // of one level
  double borderVoxels_;                         // on the faces of the grid
  std::vector<std::unique_ptr<Brick>> bricks_;  // per brick; null: not reached
};

}  // namespace

RegionGrowth growRegion(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                        double lowest, double highest) {
  std::vector<Voxel> voxels;
  double least = highest;
  for (const Vec3& s : seeds) {
    const Voxel v{static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                  static_cast<int>(std::lround(s[2]))};
    if (!isInside(volume.grid(), v)) continue;
    voxels.push_back(v);
    least = std::min(least, sign * static_cast<double>(volume.at(v.i, v.j, v.k)));
  }
  const double level = std::clamp((least - lowest) / (highest - lowest) * kBins, 0.0, kBins - 1.0);
  Flood flood(volume, sign, lowest, highest, static_cast<int>(level));
  for (const Voxel& v : voxels) flood.start(v);
  return flood.run();
}

bool growsByItself(const SmoothedVolume& volume) { return volume.brickCount() <= kFewBricks; }

}  // namespace handlebody
