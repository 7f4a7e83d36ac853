#include "core/evolution/region_growth.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/growing_region.h"
#include "core/evolution/row_flood.h"
#include "core/evolution/voxel_flood.h"

namespace handlebody {

namespace {

using namespace region;

// The growth goes on until it is this many voxels, or this many times what it was at its strongest edge: by
// then it has leaked, and nothing but time and memory is spent.
constexpr double kEnoughVoxels = 120'000;
constexpr double kEnoughTimes = 2;

//! Voxels of the grid nearest to the seeds, and the level of the lowest: up to it nothing grows.
struct Starts {
  std::vector<Voxel> voxels;
  int level = 0;
};

Starts startsOf(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign, double lowest,
                double highest) {
  Starts starts;
  double least = highest;
  for (const Vec3& s : seeds) {
    const Voxel v{static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                  static_cast<int>(std::lround(s[2]))};
    if (!isInside(volume.grid(), v)) continue;
    starts.voxels.push_back(v);
    least = std::min(least, sign * static_cast<double>(volume.at(v.i, v.j, v.k)));
  }
  starts.level =
      static_cast<int>(std::clamp((least - lowest) / (highest - lowest) * kBins, 0.0, kBins - 1.0));
  return starts;
}

}  // namespace

RegionGrowth growRegion(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                        double lowest, double highest) {
  const Starts starts = startsOf(volume, seeds, sign, lowest, highest);
  RegionGrowth growth{lowest, (highest - lowest) / kBins, {}, {}, {}};
  GrowingRegion region(volume, sign, lowest, growth.step);
  RowFlood rows(region, starts.level);
  VoxelFlood voxels(region, rows);
  for (const Voxel& v : starts.voxels)
    rows.reach(region.bricks.holding(v), placeOf(v) >> kShift, RowBits{1} << (v.i & kBrickMask));

  double count = 0, strongest = 0, enough = kEnoughVoxels;
  for (int bin = 0; bin < kBins && count < enough && !region.limits.isLeak(count / 2); ++bin) {
    const std::size_t taken = bin < starts.level ? 0 : bin == starts.level ? rows.drain() : voxels.drain(bin);
    count += static_cast<double>(taken);
    growth.voxels.push_back(count);
    growth.border.push_back(region.limits.borderShare());
    if (region.limits.isBackground(taken)) break;
    const double edge = region.edges.of(bin);
    if (edge <= strongest) continue;
    strongest = edge;
    enough = std::max(kEnoughVoxels, kEnoughTimes * count);
  }
  growth.whole = count >= enough || growth.voxels.size() == kBins;
  growth.edge = region.edges.smoothed(growth.voxels.size());
  return growth;
}

bool growsByItself(const SmoothedVolume& volume) { return volume.brickCount() <= kFewBricks; }

}  // namespace handlebody
