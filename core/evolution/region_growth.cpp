#include "core/evolution/region_growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

namespace handlebody {

namespace {

constexpr int kBins = 200;
// The growth goes on until it is this many voxels, or this many times what it was at its strongest edge: by
// then it has leaked, and nothing but time and memory is spent.
constexpr double kEnoughVoxels = 120'000;
constexpr double kEnoughTimes = 2;
// The growth ends when it has touched a quarter of a large volume.
constexpr std::size_t kFewBricks = 300;
constexpr std::size_t kPartOfBricks = 4;
// One level that lets in more than this is a leak, whatever it leads to.
constexpr std::size_t kMostVoxels = 2'000'000;

constexpr int kBrick = SmoothedVolume::kBrick;
constexpr int kStored = SmoothedVolume::kStored;
constexpr int kBrickMask = kBrick - 1;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

constexpr int kShift = SmoothedVolume::kBrickShift;

struct Voxel {
  int i, j, k;
  int along(int axis) const { return axis == 0 ? i : axis == 1 ? j : k; }
};

//! A voxel of a brick: five bits per axis, x lowest.
using Place = std::uint16_t;
constexpr std::array<int, 3> kPlaceStride{1, kBrick, kBrick* kBrick};
constexpr std::array<int, 3> kValueStride{1, kStored, kStored* kStored};

Place placeOf(const Voxel& v) {
  return static_cast<Place>((v.k & kBrickMask) << 2 * kShift | (v.j & kBrickMask) << kShift |
                            (v.i & kBrickMask));
}
Voxel inBrick(Place place) { return {place & kBrickMask, place >> kShift & kBrickMask, place >> 2 * kShift}; }
int valueIndex(const Voxel& v) { return (v.k * kStored + v.j) * kStored + v.i; }

//! A voxel that waits, and its signed value.
struct Entry {
  Place place;
  float value;
};

//! What the flood keeps of a brick that it has reached.
struct Patch {
  const float* values = nullptr;
  Voxel first{};  // voxel of the grid
  Voxel last{};   // in the brick: beyond it a neighbour lies in another brick or outside the grid
  bool onBorder = false;
  std::array<Patch*, 6> neighbours{};  // two per axis; null: not asked for yet, or outside
  std::array<std::uint64_t, kBrick * kBrick * kBrick / 64> seen{};
  std::array<std::vector<Entry>, kBins> waiting;  // per bin

  //! True the first time.
  bool visit(Place place) {
    const std::uint64_t bit = std::uint64_t{1} << (place & 63);
    const bool fresh = (seen[place >> 6] & bit) == 0;
    seen[place >> 6] |= bit;
    return fresh;
  }
  Voxel inGrid(const Voxel& local) const { return {first.i + local.i, first.j + local.j, first.k + local.k}; }
};

class Flood {
 public:
  Flood(const SmoothedVolume& volume, double sign, double lowest, double highest)
      : volume_(volume),
        sign_(static_cast<float>(sign)),
        lowest_(lowest),
        step_((highest - lowest) / kBins),
        queue_(kBins),
        sumGradient_(kBins, 0),
        sumSquared_(kBins, 0),
        patches_(volume.brickCount()) {}

  void start(const Voxel& v) {
    if (!isInside(v)) return;
    push({&patchOf({v.i >> kShift, v.j >> kShift, v.k >> kShift}), placeOf(v)});
  }

  RegionGrowth run() {
    RegionGrowth growth{lowest_, step_, {}, {}, {}};
    const auto& n = volume_.grid().size;
    const double borderVoxels =
        static_cast<double>(volume_.grid().voxelCount()) -
        std::max(0.0, n[0] - 2.0) * std::max(0.0, n[1] - 2.0) * std::max(0.0, n[2] - 2.0);
    double count = 0, strongest = 0, enough = kEnoughVoxels;
    for (int bin = 0; bin < kBins && count < std::min(enough, 2.0 * kMostVoxels) && !isFarSpread(); ++bin) {
      count += static_cast<double>(drain(bin));
      growth.voxels.push_back(count);
      growth.border.push_back(border_ / borderVoxels);
      const double edge = sumGradient_[idx(bin)] > 0 ? sumSquared_[idx(bin)] / sumGradient_[idx(bin)] : 0;
      if (edge <= strongest) continue;
      strongest = edge;
      enough = std::max(kEnoughVoxels, kEnoughTimes * count);
    }
    growth.edge = edgeStrength(growth.voxels.size());
    return growth;
  }

 private:
  //! A leak into noise spreads thinly through the whole volume, and would have all of it smoothed and kept.
  bool isFarSpread() const {
    return volume_.bricksMade() > std::max(kFewBricks, volume_.brickCount() / kPartOfBricks);
  }
  bool isInside(const Voxel& v) const {
    const auto& size = volume_.grid().size;
    return v.i >= 0 && v.j >= 0 && v.k >= 0 && v.i < size[0] && v.j < size[1] && v.k < size[2];
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
    if (!n.patch->visit(n.place)) return;
    const float signedValue = value(n);
    const double bin = signedValue < levelStart_ ? level_ : (signedValue - lowest_) / step_;
    if (!(bin < kBins)) return;
    const std::size_t target = idx(std::max(static_cast<int>(bin), level_));
    std::vector<Entry>& waiting = n.patch->waiting[target];
    if (waiting.empty()) queue_[target].push_back(n.patch);
    waiting.push_back({n.place, signedValue});
  }

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
        if (taken >= kMostVoxels || isFarSpread()) return taken;
        take(patch, Entry(waiting[i]));
      }
      waiting = {};  // from here on the brick may come again
    }
    return taken;
  }

  void take(Patch& patch, const Entry& entry) {
    const Voxel at = inBrick(entry.place);
    if (patch.onBorder && isOnBorder(patch.inGrid(at))) ++border_;
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        const Neighbour n = neighbour(patch, at, entry.place, axis, side);
        if (n.patch) push(n);
      }
    // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
    // joined.
    if (entry.value >= levelStart_) addEdge(patch, entry, at);
  }

  //! Counts the gradient at a voxel of the boundary. Beside padding an edge says nothing about the object.
  void addEdge(Patch& patch, const Entry& entry, const Voxel& at) {
    if (volume_.hasPadding() && isBesidePadding(patch.inGrid(at))) return;
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Neighbour before = neighbour(patch, at, entry.place, axis, 0);
      const Neighbour after = neighbour(patch, at, entry.place, axis, 1);
      const double low = before.patch ? value(before) : entry.value;
      const double high = after.patch ? value(after) : entry.value;
      const double span = volume_.grid().spacing[axis] * ((before.patch ? 1 : 0) + (after.patch ? 1 : 0));
      if (span > 0) squared += (high - low) * (high - low) / (span * span);
    }
    sumGradient_[idx(level_)] += std::sqrt(squared);
    sumSquared_[idx(level_)] += squared;
  }

  bool isBesidePadding(const Voxel& v) const {
    for (int d : {-1, 1})
      for (const Voxel& w : {Voxel{v.i + d, v.j, v.k}, Voxel{v.i, v.j + d, v.k}, Voxel{v.i, v.j, v.k + d}})
        if (isInside(w) && isPadding(w)) return true;
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
  double lowest_, step_;
  double border_ = 0;                                             // voxels taken on the faces of the grid
  int level_ = 0;                                                 // the bin that is being drained
  double levelStart_ = -std::numeric_limits<double>::infinity();  // its signed level
  std::vector<std::vector<Patch*>> queue_;                        // per bin: bricks with voxels that wait
  std::vector<double> sumGradient_, sumSquared_;
  std::vector<std::unique_ptr<Patch>> patches_;  // per brick; null: not reached
};

}  // namespace

RegionGrowth growRegion(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                        double lowest, double highest) {
  Flood flood(volume, sign, lowest, highest);
  for (const Vec3& s : seeds)
    flood.start({static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                 static_cast<int>(std::lround(s[2]))});
  return flood.run();
}

}  // namespace handlebody
