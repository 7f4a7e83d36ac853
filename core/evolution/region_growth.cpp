#include "core/evolution/region_growth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/cancellation.h"
#include "core/evolution/region_patch.h"
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
constexpr std::size_t kMostVoxels = 2'000'000;
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
        mostVoxels_(std::max(kMostVoxels, volume.grid().voxelCount() / kPartOfVolume)),
        borderVoxels_(voxelsOnFaces(volume.grid())),
        patches_(volume.brickCount()) {
    startRows(first);
  }

  void start(const Voxel& v) {
    Patch& patch = patchOf({v.i >> kShift, v.j >> kShift, v.k >> kShift});
    reach(patch, placeOf(v) >> kShift, Row{1} << (v.i & kBrickMask));
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
      const double edge = sumGradient_[idx(bin)] > 0 ? sumSquared_[idx(bin)] / sumGradient_[idx(bin)] : 0;
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
  Patch& patchOf(const Voxel& at) {
    const std::array<int, 3>& n = volume_.bricks();
    std::unique_ptr<Patch>& patch = patches_[idx((at.k * n[1] + at.j) * n[0] + at.i)];
    if (!patch) patch = makePatch(at);
    return *patch;
  }
  std::unique_ptr<Patch> makePatch(const Voxel& at) const {
    const std::array<int, 3>&n = volume_.bricks(), &size = volume_.grid().size;
    auto patch = std::make_unique<Patch>();
    patch->values = volume_.brick(at.i, at.j, at.k);
    patch->first = {at.i * kBrick, at.j * kBrick, at.k * kBrick};
    patch->last = {std::min(kBrickMask, size[0] - 1 - patch->first.i),
                   std::min(kBrickMask, size[1] - 1 - patch->first.j),
                   std::min(kBrickMask, size[2] - 1 - patch->first.k)};
    patch->onBorder =
        at.i == 0 || at.j == 0 || at.k == 0 || at.i == n[0] - 1 || at.j == n[1] - 1 || at.k == n[2] - 1;
    for (int row = 0; row < kRows; ++row) {
      const bool inGrid = (row & kBrickMask) <= patch->last.j && row >> kShift <= patch->last.k;
      patch->seen[idx(row)] = inGrid ? ~(~Row{0} >> (kBrickMask - patch->last.i)) : ~Row{0};
    }
    if (volume_.hasPadding()) markPadding(*patch);
    return patch;
  }
  //! Padding is never entered.
  void markPadding(Patch& patch) const {
    for (int k = 0; k <= patch.last.k; ++k)
      for (int j = 0; j <= patch.last.j; ++j)
        for (int i = 0; i <= patch.last.i; ++i)
          if (isPadding(patch.inGrid({i, j, k}))) patch.visit(placeOf({i, j, k}));
  }

  //! The voxel before (side 0) or after (side 1) the given one along an axis. Null patch: outside the grid.
  struct Neighbour {
    Patch* patch;
    Place place;
  };
  Neighbour neighbour(Patch& patch, const Voxel& at, Place place, int axis, int side) {
    const int stride = kPlaceStride[idx(axis)];
    const int local = at.along(axis);
    if (side == 0 ? local > 0 : local < patch.last.along(axis))
      return {&patch, static_cast<Place>(side == 0 ? place - stride : place + stride)};
    return {beyond(patch, axis, side), static_cast<Place>(place ^ kBrickMask * stride)};
  }
  float value(const Neighbour& n) const { return sign_ * n.patch->values[valueIndex(inBrick(n.place))]; }

  Patch* beyond(Patch& patch, int axis, int side) {
    Patch*& other = patch.neighbours[idx(2 * axis + side)];
    if (other) return other;
    std::array<int, 3> at{patch.first.i / kBrick, patch.first.j / kBrick, patch.first.k / kBrick};
    at[idx(axis)] += 2 * side - 1;
    if (at[idx(axis)] < 0 || at[idx(axis)] >= volume_.bricks()[idx(axis)]) return nullptr;
    return other = &patchOf({at[0], at[1], at[2]});
  }

  //! Queues the voxel if it has not been seen before.
  void push(const Neighbour& n) {
    if (n.patch->visit(n.place)) queue(*n.patch, n.place, value(n));
  }
  void queue(Patch& patch, Place place, float signedValue) {
    const double bin = signedValue < levelStart_ ? level_ : (signedValue - lowest_) * perStep_;
    if (!(bin < kBins) || level_ >= kBins) return;
    const std::size_t target = idx(std::max(static_cast<int>(bin), level_));
    std::vector<Entry>& waiting = patch.waiting[target];
    if (waiting.empty()) queue_[target].push_back(&patch);
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
  void lookAtRows(Patch& patch) const {
    if (patch.rowLevel == rowLevel_) return;
    patch.rowLevel = rowLevel_;
    patch.taken = patch.todo = {};
    patch.rows.clear();
    for (int row = 0; row < kRows; ++row)
      patch.low[idx(row)] = rowBelow(patch.values + rowIndex(row), sign_, rowEnd_);
  }

  //! Voxels of a row beside voxels that were taken. Those above the level wait for theirs.
  void reach(Patch& patch, int row, Row bits) {
    lookAtRows(patch);
    bits &= ~patch.seen[idx(row)];
    const Row high = bits & ~patch.low[idx(row)];
    for (Row left = high; left != 0; left &= left - 1)
      push({&patch, static_cast<Place>(row << kShift | std::countr_zero(left))});
    if ((bits & patch.low[idx(row)]) == 0) return;
    if (patch.rows.empty()) queue_[idx(rowLevel_)].push_back(&patch);
    if (patch.todo[idx(row)] == 0) patch.rows.push_back(row);
    patch.todo[idx(row)] |= bits & patch.low[idx(row)];
  }

  //! Takes in what the level lets in, brick by brick. `taken`: what it has let in already.
  std::size_t drainByRows(std::size_t taken = 0) {
    std::vector<Patch*>& queue = queue_[idx(rowLevel_)];
    for (std::size_t q = 0; q < queue.size() && !isLeak(static_cast<double>(taken)); ++q) {
      giveUpIfCancelled();
      std::vector<int>& rows = queue[q]->rows;
      for (std::size_t r = 0; r < rows.size(); ++r) taken += takeRow(*queue[q], rows[r]);
      rows.clear();  // from here on the brick may come again
    }
    level_ = rowLevel_;
    levelStart_ = lowest_ + step_ * level_;
    for (const auto& patch : patches_)
      if (patch && patch->rowLevel == rowLevel_) addRowEdges(*patch);
    return taken;
  }

  //! Goes on by rows with a level that was begun voxel by voxel, from place q in its queue on.
  std::size_t drainRestByRows(std::size_t q, std::size_t taken) {
    startRows(level_);
    const std::vector<Patch*> begun = std::exchange(queue_[idx(rowLevel_)], {});
    for (; q < begun.size(); ++q) {
      Patch& patch = *begun[q];
      const std::vector<Entry> waiting = std::exchange(patch.waiting[idx(rowLevel_)], {});
      for (const Entry& entry : waiting) patch.forget(entry.place);
      for (const Entry& entry : waiting)
        reach(patch, entry.place >> kShift, Row{1} << (entry.place & kBrickMask));
    }
    return drainByRows(taken);
  }

  std::size_t takeRow(Patch& patch, int row) {
    const Row free = patch.low[idx(row)] & ~patch.seen[idx(row)];
    const Row start = std::exchange(patch.todo[idx(row)], 0) & free;
    if (start == 0) return 0;
    const Row taken = fillRow(start, free);
    patch.seen[idx(row)] |= taken;
    patch.taken[idx(row)] |= taken;
    reach(patch, row, taken << 1 | taken >> 1);
    if (Patch* before = taken & 1 ? beyond(patch, 0, 0) : nullptr) reach(*before, row, Row{1} << kBrickMask);
    if (Patch* after = taken >> kBrickMask ? beyond(patch, 0, 1) : nullptr) reach(*after, row, 1);
    for (int axis : {1, 2})
      for (int side : {0, 1}) {
        // The row beside is the neighbour of its first voxel.
        const auto place = static_cast<Place>(row << kShift);
        const Neighbour n = neighbour(patch, inBrick(place), place, axis, side);
        if (n.patch) reach(*n.patch, n.place >> kShift, taken);
      }
    if (patch.onBorder) countBorder(patch, row, taken);
    return static_cast<std::size_t>(std::popcount(taken));
  }

  void countBorder(const Patch& patch, int row, Row taken) {
    for (; taken != 0; taken &= taken - 1)
      if (isOnBorder(patch.inGrid({std::countr_zero(taken), row & kBrickMask, row >> kShift}))) ++border_;
  }

  void addRowEdges(Patch& patch) {
    for (int row = 0; row < kRows; ++row) {
      if (patch.taken[idx(row)] == 0) continue;
      const float* values = patch.values + rowIndex(row);
      Row edge = patch.taken[idx(row)] & ~rowBelow(values, sign_, static_cast<float>(levelStart_));
      for (; edge != 0; edge &= edge - 1) {
        const int x = std::countr_zero(edge);
        const auto place = static_cast<Place>(row << kShift | x);
        addEdge(patch, {place, sign_ * values[x]}, inBrick(place));
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
    for (std::size_t q = 0; q < queue_[idx(bin)].size(); ++q) {
      Patch& patch = *queue_[idx(bin)][q];
      std::vector<Entry>& waiting = patch.waiting[idx(bin)];
      for (std::size_t i = 0; i < waiting.size(); ++i, ++taken) {
        if (taken % kBetweenLooks == 0) giveUpIfCancelled();
        if (isLeak(static_cast<double>(taken))) return taken;
        if (taken == kManyVoxels) {
          waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(i));
          return drainRestByRows(q, taken);
        }
        if (i + kAhead < waiting.size()) prefetchAround(patch, waiting[i + kAhead].place);
        take(patch, Entry(waiting[i]));
      }
      waiting = {};  // from here on the brick may come again
    }
    return taken;
  }

  //! The values that take() will ask for: a level has few voxels in each brick, which lie anywhere in it.
  static void prefetchAround(const Patch& patch, Place place) {
    const float* here = patch.values + valueIndex(inBrick(place));
    __builtin_prefetch(here);
    for (const int stride : {kValueStride[1], kValueStride[2]})
      for (const int side : {-stride, stride}) __builtin_prefetch(here + side);
  }

  void take(Patch& patch, const Entry& entry) {
    const Voxel at = inBrick(entry.place);
    if (patch.onBorder && isOnBorder(patch.inGrid(at))) ++border_;
    if (isWithin(patch, at)) {
      pushWithin(patch, at, entry.place);
    } else {
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          const Neighbour n = neighbour(patch, at, entry.place, axis, side);
          if (n.patch) push(n);
        }
    }
    // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
    // joined.
    if (entry.value >= levelStart_) addEdge(patch, entry, at);
  }

  //! True if all neighbours of the voxel lie in its brick.
  static bool isWithin(const Patch& patch, const Voxel& at) {
    return at.i > 0 && at.j > 0 && at.k > 0 && at.i < patch.last.i && at.j < patch.last.j &&
           at.k < patch.last.k;
  }

  //! The neighbours of such a voxel, in the same order as of any other.
  void pushWithin(Patch& patch, const Voxel& at, Place place) {
    const float* here = patch.values + valueIndex(at);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const auto beside = static_cast<Place>(place + side * kPlaceStride[axis]);
        if (patch.visit(beside)) queue(patch, beside, sign_ * here[side * kValueStride[axis]]);
      }
  }

  //! Square of the gradient at such a voxel.
  double squaredGradientWithin(const Patch& patch, const Voxel& at) const {
    const float* here = patch.values + valueIndex(at);
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = sign_ * here[-kValueStride[axis]], high = sign_ * here[kValueStride[axis]];
      const double span = volume_.grid().spacing[static_cast<int>(axis)] * 2;
      squared += (high - low) * (high - low) / (span * span);
    }
    return squared;
  }

  //! Counts the gradient at a voxel of the boundary. Beside padding an edge says nothing about the object.
  void addEdge(Patch& patch, const Entry& entry, const Voxel& at) {
    if (volume_.hasPadding() && isBesidePadding(patch.inGrid(at))) return;
    const double squared =
        isWithin(patch, at) ? squaredGradientWithin(patch, at) : squaredGradient(patch, entry, at);
    sumGradient_[idx(level_)] += std::sqrt(squared);
    sumSquared_[idx(level_)] += squared;
  }

  double squaredGradient(Patch& patch, const Entry& entry, const Voxel& at) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Neighbour before = neighbour(patch, at, entry.place, axis, 0);
      const Neighbour after = neighbour(patch, at, entry.place, axis, 1);
      const double low = before.patch ? value(before) : entry.value;
      const double high = after.patch ? value(after) : entry.value;
      const double span = volume_.grid().spacing[axis] * ((before.patch ? 1 : 0) + (after.patch ? 1 : 0));
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
        s1 += sumGradient_[idx(c)];
        s2 += sumSquared_[idx(c)];
      }
      edge[idx(b)] = s1 > 0 ? s2 / s1 : 0;
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
  std::vector<std::vector<Patch*>> queue_;                        // per bin: bricks with voxels that wait
  std::vector<double> sumGradient_, sumSquared_;
  std::size_t mostVoxels_;                       // of one level
  double borderVoxels_;                          // on the faces of the grid
  std::vector<std::unique_ptr<Patch>> patches_;  // per brick; null: not reached
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

}  // namespace handlebody
