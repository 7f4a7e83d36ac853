#include "core/evolution/region_growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

struct Voxel {
  int i, j, k;
  int& along(int axis) { return axis == 0 ? i : axis == 1 ? j : k; }
};

//! A voxel that waits: its brick, its place there (five bits per axis, x lowest) and its signed value.
struct Entry {
  int brick;
  std::uint16_t place;
  float value;
};

std::uint16_t placeOf(const Voxel& v) {
  constexpr int kShift = SmoothedVolume::kBrickShift;
  return static_cast<std::uint16_t>((v.k & kBrickMask) << 2 * kShift | (v.j & kBrickMask) << kShift |
                                    (v.i & kBrickMask));
}
Voxel inBrick(std::uint16_t place) {
  constexpr int kShift = SmoothedVolume::kBrickShift;
  return {place & kBrickMask, place >> kShift & kBrickMask, place >> 2 * kShift};
}

//! First in, first out. Memory follows what waits: what was taken is dropped when it is half of the array.
class Queue {
 public:
  bool empty() const { return head_ == entries_.size(); }
  void push(const Entry& e) { entries_.push_back(e); }
  Entry pop() {
    const Entry e = entries_[head_++];
    if (head_ >= kLeast && 2 * head_ >= entries_.size()) {
      entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(head_));
      head_ = 0;
    }
    return e;
  }

 private:
  static constexpr std::size_t kLeast = 4096;
  std::vector<Entry> entries_;
  std::size_t head_ = 0;
};

//! What the flood keeps of a brick that it has reached.
struct Patch {
  const float* values = nullptr;
  Voxel first{};  // voxel of the grid
  Voxel last{};   // in the brick: beyond it a neighbour lies in another brick or outside
  bool hasPadding = false;
  std::array<std::uint64_t, kBrick * kBrick * kBrick / 64> seen{};

  //! True the first time.
  bool visit(std::uint16_t place) {
    const std::uint64_t bit = std::uint64_t{1} << (place & 63);
    const bool fresh = (seen[place >> 6] & bit) == 0;
    seen[place >> 6] |= bit;
    return fresh;
  }
  //! All six neighbours lie in the brick and in the grid, and none is padding.
  bool isInner(const Voxel& v) const {
    return v.i > 0 && v.j > 0 && v.k > 0 && v.i < last.i && v.j < last.j && v.k < last.k && !hasPadding;
  }
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
        patches_(volume.brickCount()) {
    for (int a = 0; a < 3; ++a) span_[idx(a)] = 2 * volume.grid().spacing[a];
  }

  void start(const Voxel& v) {
    if (isInside(v)) push(v, value(v));
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
  //! Signed.
  float value(const Voxel& v) const { return sign_ * volume_.at(v.i, v.j, v.k); }

  int brickOf(const Voxel& v) const {
    constexpr int kShift = SmoothedVolume::kBrickShift;
    const std::array<int, 3>& n = volume_.bricks();
    return ((v.k >> kShift) * n[1] + (v.j >> kShift)) * n[0] + (v.i >> kShift);
  }
  Patch& patchOf(int brick) {
    std::unique_ptr<Patch>& patch = patches_[idx(brick)];
    if (!patch) patch = makePatch(brick);
    return *patch;
  }
  std::unique_ptr<Patch> makePatch(int brick) const {
    const std::array<int, 3>& n = volume_.bricks();
    const std::array<int, 3>& size = volume_.grid().size;
    const Voxel at{brick % n[0], brick / n[0] % n[1], brick / (n[0] * n[1])};
    auto patch = std::make_unique<Patch>();
    patch->values = volume_.brick(at.i, at.j, at.k);
    patch->first = {at.i * kBrick, at.j * kBrick, at.k * kBrick};
    patch->last = {std::min(kBrickMask, size[0] - 1 - patch->first.i),
                   std::min(kBrickMask, size[1] - 1 - patch->first.j),
                   std::min(kBrickMask, size[2] - 1 - patch->first.k)};
    if (volume_.hasPadding()) markPadding(*patch);
    return patch;
  }
  //! Padding is never entered.
  void markPadding(Patch& patch) const {
    for (int k = 0; k <= patch.last.k; ++k)
      for (int j = 0; j <= patch.last.j; ++j)
        for (int i = 0; i <= patch.last.i; ++i)
          if (volume_.isPadding(indexOf({patch.first.i + i, patch.first.j + j, patch.first.k + k})))
            patch.hasPadding = patch.visit(placeOf({i, j, k}));
  }

  void push(const Voxel& v, float signedValue) {
    const int brick = brickOf(v);
    push(patchOf(brick), brick, placeOf(v), signedValue);
  }
  void push(Patch& patch, int brick, std::uint16_t place, float signedValue) {
    if (!patch.visit(place)) return;
    const int bin = std::max(0, static_cast<int>(std::floor((signedValue - lowest_) / step_)));
    if (bin < kBins) queue_[idx(std::max(bin, level_))].push({brick, place, signedValue});
  }

  //! Takes in all voxels that the level of this bin lets in, also those behind them that are lower.
  std::size_t drain(int bin) {
    level_ = bin;
    std::size_t taken = 0;
    // First in, first out: the region grows like a ball, and the queue is never more than its surface.
    Queue& front = queue_[idx(bin)];
    while (!front.empty() && taken < kMostVoxels && !isFarSpread()) {
      const Entry entry = front.pop();
      ++taken;
      Patch& patch = *patches_[idx(entry.brick)];
      const Voxel local = inBrick(entry.place);
      const double g = patch.isInner(local) ? takeInnerNeighbours(patch, entry, local)
                                            : takeNeighbours(patch, entry, local);
      // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
      // joined.
      if (g >= 0 && entry.value >= lowest_ + step_ * bin) {
        sumGradient_[idx(bin)] += g;
        sumSquared_[idx(bin)] += g * g;
      }
    }
    return taken;
  }

  //! Queues the neighbours; returns the gradient's length.
  double takeInnerNeighbours(Patch& patch, const Entry& entry, const Voxel& at) {
    constexpr std::array<int, 3> kValueStride{1, kStored, kStored * kStored};
    constexpr std::array<int, 3> kPlaceStride{1, kBrick, kBrick * kBrick};
    const float* centre = patch.values + (at.k * kStored + at.j) * kStored + at.i;
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float before = sign_ * centre[-kValueStride[axis]], after = sign_ * centre[kValueStride[axis]];
      push(patch, entry.brick, static_cast<std::uint16_t>(entry.place - kPlaceStride[axis]), before);
      push(patch, entry.brick, static_cast<std::uint16_t>(entry.place + kPlaceStride[axis]), after);
      const double difference = static_cast<double>(after) - static_cast<double>(before);
      squared += difference * difference / (span_[axis] * span_[axis]);
    }
    return std::sqrt(squared);
  }

  //! The same anywhere in the grid; -1 beside padding: an edge there says nothing about the object.
  double takeNeighbours(const Patch& patch, const Entry& entry, const Voxel& local) {
    const Voxel voxel{patch.first.i + local.i, patch.first.j + local.j, patch.first.k + local.k};
    if (isOnBorder(voxel)) ++border_;
    double squared = 0;
    bool atPadding = false;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 2> side{entry.value, entry.value};
      double span = 0;
      for (int d : {0, 1}) {
        Voxel w = voxel;
        w.along(axis) += 2 * d - 1;
        if (!isInside(w)) continue;
        const float there = value(w);
        side[idx(d)] = there;
        span += volume_.grid().spacing[axis];
        atPadding = atPadding || (volume_.hasPadding() && volume_.isPadding(indexOf(w)));
        push(w, there);
      }
      if (span > 0) squared += (side[1] - side[0]) * (side[1] - side[0]) / (span * span);
    }
    return atPadding ? -1 : std::sqrt(squared);
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
  std::array<double, 3> span_;  // mm, over two voxels of each axis
  double border_ = 0;           // voxels taken on the faces of the grid
  int level_ = 0;               // the bin that is being drained
  std::vector<Queue> queue_;
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
