#include "core/evolution/region_growth.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {

constexpr int kBins = 200;
// The growth goes on until it is this many voxels, or this many times what it was at its strongest edge: by
// then it has leaked, and nothing but time and memory is spent.
constexpr double kEnoughVoxels = 250'000;
constexpr double kEnoughTimes = 4;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

struct Voxel {
  int i, j, k;
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

  void push(const Voxel& v) {
    if (!isInside(v)) return;
    const std::size_t at = indexOf(v);
    if (seen_[at] || volume_.isPadding(at)) return;
    seen_[at] = true;
    const int bin = std::max(0, static_cast<int>(std::floor((value(v) - lowest_) / step_)));
    if (bin < kBins) queue_[idx(std::max(bin, level_))].push_back(v);
  }

  RegionGrowth run() {
    RegionGrowth growth{lowest_, step_, {}, {}};
    double count = 0, strongest = 0, enough = kEnoughVoxels;
    for (int bin = 0; bin < kBins && count < enough; ++bin) {
      count += static_cast<double>(drain(bin));
      growth.voxels.push_back(count);
      const double edge = sumGradient_[idx(bin)] > 0 ? sumSquared_[idx(bin)] / sumGradient_[idx(bin)] : 0;
      if (edge <= strongest) continue;
      strongest = edge;
      enough = std::max(kEnoughVoxels, kEnoughTimes * count);
    }
    growth.edge = edgeStrength(growth.voxels.size());
    return growth;
  }

 private:
  bool isInside(const Voxel& v) const {
    const auto& size = volume_.grid().size;
    return v.i >= 0 && v.j >= 0 && v.k >= 0 && v.i < size[0] && v.j < size[1] && v.k < size[2];
  }
  std::size_t indexOf(const Voxel& v) const {
    const auto& size = volume_.grid().size;
    return (idx(v.k) * idx(size[1]) + idx(v.j)) * idx(size[0]) + idx(v.i);
  }
  bool isPadding(const Voxel& v) const { return isInside(v) && volume_.isPadding(indexOf(v)); }
  double value(const Voxel& v) const { return sign_ * static_cast<double>(volume_.at(v.i, v.j, v.k)); }

  //! Takes in all voxels that the level of this bin lets in, also those behind them that are lower.
  std::size_t drain(int bin) {
    level_ = bin;
    std::size_t taken = 0;
    std::vector<Voxel>& front = queue_[idx(bin)];
    while (!front.empty()) {
      const Voxel v = front.back();
      front.pop_back();
      ++taken;
      // Only voxels at the level itself lie on the boundary; lower ones are the inside of what has just been
      // joined.
      bool atPadding = false;  // an edge against the padding says nothing about the object
      for (const Voxel& w : {Voxel{v.i + 1, v.j, v.k}, Voxel{v.i - 1, v.j, v.k}, Voxel{v.i, v.j + 1, v.k},
                             Voxel{v.i, v.j - 1, v.k}, Voxel{v.i, v.j, v.k + 1}, Voxel{v.i, v.j, v.k - 1}}) {
        atPadding = atPadding || isPadding(w);
        push(w);
      }
      if (!atPadding && value(v) >= lowest_ + step_ * bin) {
        const double g = gradient(v);
        sumGradient_[idx(bin)] += g;
        sumSquared_[idx(bin)] += g * g;
      }
    }
    return taken;
  }

  double gradient(const Voxel& v) const {
    const Grid& grid = volume_.grid();
    const auto difference = [&](int axis, const Voxel& a, const Voxel& b, int span) {
      return span == 0 ? 0.0 : (value(b) - value(a)) / (span * grid.spacing[axis]);
    };
    const auto& n = grid.size;
    const int i0 = std::max(0, v.i - 1), i1 = std::min(n[0] - 1, v.i + 1), j0 = std::max(0, v.j - 1),
              j1 = std::min(n[1] - 1, v.j + 1), k0 = std::max(0, v.k - 1), k1 = std::min(n[2] - 1, v.k + 1);
    return Vec3(difference(0, {i0, v.j, v.k}, {i1, v.j, v.k}, i1 - i0),
                difference(1, {v.i, j0, v.k}, {v.i, j1, v.k}, j1 - j0),
                difference(2, {v.i, v.j, k0}, {v.i, v.j, k1}, k1 - k0))
        .norm();
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
  int level_ = 0;  // the bin that is being drained
  std::vector<std::vector<Voxel>> queue_;
  std::vector<double> sumGradient_, sumSquared_;
  std::vector<bool> seen_;
};

}  // namespace

RegionGrowth growRegion(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                        double lowest, double highest) {
  Flood flood(volume, sign, lowest, highest);
  for (const Vec3& s : seeds)
    flood.push({static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                static_cast<int>(std::lround(s[2]))});
  return flood.run();
}

}  // namespace handlebody
