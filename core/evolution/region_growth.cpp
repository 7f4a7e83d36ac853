#include "core/evolution/region_growth.h"

#include <algorithm>
#include <cmath>
#include <deque>

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

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

struct Voxel {
  int i, j, k;
};

struct Entry {
  Voxel voxel;
  double value;  // signed
};

class Flood {
 public:
  Flood(const SmoothedVolume& volume, double sign, double lowest, double highest)
      : volume_(volume),
        sign_(sign),
        lowest_(lowest),
        step_((highest - lowest) / kBins),
        queue_(kBins),
        sumGradient_(kBins, 0),
        sumSquared_(kBins, 0),
        seen_(volume.grid().voxelCount(), false) {}

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
  double value(const Voxel& v) const { return sign_ * static_cast<double>(volume_.at(v.i, v.j, v.k)); }

  void push(const Voxel& v, double signedValue) {
    const std::size_t at = indexOf(v);
    if (seen_[at] || volume_.isPadding(at)) return;
    seen_[at] = true;
    const int bin = std::max(0, static_cast<int>(std::floor((signedValue - lowest_) / step_)));
    if (bin < kBins) queue_[idx(std::max(bin, level_))].push_back({v, signedValue});
  }

  //! Takes in all voxels that the level of this bin lets in, also those behind them that are lower.
  std::size_t drain(int bin) {
    level_ = bin;
    std::size_t taken = 0;
    // First in, first out: the region grows like a ball, and the queue is never more than its surface.
    std::deque<Entry>& front = queue_[idx(bin)];
    while (!front.empty() && taken < kMostVoxels && !isFarSpread()) {
      const Entry entry = front.front();
      front.pop_front();
      ++taken;
      if (isOnBorder(entry.voxel)) ++border_;
      const double g = takeNeighbours(entry);
      // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
      // joined.
      if (g >= 0 && entry.value >= lowest_ + step_ * bin) {
        sumGradient_[idx(bin)] += g;
        sumSquared_[idx(bin)] += g * g;
      }
    }
    return taken;
  }

  //! Queues the neighbours; returns the gradient's length, or -1 beside padding: an edge there says nothing
  //! about the object.
  double takeNeighbours(const Entry& entry) {
    double squared = 0;
    bool atPadding = false;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 2> side{entry.value, entry.value};
      double span = 0;
      for (int d : {0, 1}) {
        Voxel w = entry.voxel;
        (axis == 0 ? w.i : axis == 1 ? w.j : w.k) += 2 * d - 1;
        if (!isInside(w)) continue;
        side[idx(d)] = value(w);
        span += volume_.grid().spacing[axis];
        atPadding = atPadding || volume_.isPadding(indexOf(w));
        push(w, side[idx(d)]);
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
  double sign_, lowest_, step_;
  double border_ = 0;  // voxels taken on the faces of the grid
  int level_ = 0;      // the bin that is being drained
  std::vector<std::deque<Entry>> queue_;
  std::vector<double> sumGradient_, sumSquared_;
  std::vector<bool> seen_;
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
