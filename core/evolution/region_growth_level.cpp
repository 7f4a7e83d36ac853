#include "core/evolution/region_growth_level.h"

namespace handlebody {

namespace {

// A jump of the region's size by this factor from one level to the next is a leak into another region.
constexpr double kLeakFactor = 4;
// A boundary found after a leak must be this much stronger than the best one before it.
constexpr double kLeakAdvantage = 2.5;
// Fewer voxels than this are no region yet.
constexpr double kMinRegion = 30;
// What is nearly as strong as the strongest edge belongs to the same boundary.
constexpr double kSamePeak = 0.85;

//! Weighted mean of the levels around the strongest bin whose edge is nearly as strong: on an ideal ramp the
//! half-way level, whatever the noise does to the top of the curve.
double centreOfPeak(const RegionGrowth& g, std::size_t best, std::size_t first, std::size_t last) {
  double sum = 0, weight = 0;
  const double least = kSamePeak * g.edge[best];
  for (std::size_t b = best; b + 1 > first && g.edge[b] >= least; --b) {
    sum += g.level(b) * (g.edge[b] - least);
    weight += g.edge[b] - least;
    if (b == 0) break;
  }
  for (std::size_t b = best + 1; b < last && g.edge[b] >= least; ++b) {
    sum += g.level(b) * (g.edge[b] - least);
    weight += g.edge[b] - least;
  }
  return weight > 0 ? sum / weight : g.level(best);
}

}  // namespace

std::optional<RegionGrowthLevel> strongestLevel(const RegionGrowth& g) {
  std::optional<RegionGrowthLevel> out;
  std::size_t first = 0;
  for (std::size_t b = 1; b <= g.edge.size(); ++b) {
    const bool leak =
        b < g.edge.size() && g.voxels[b - 1] >= kMinRegion && g.voxels[b] > kLeakFactor * g.voxels[b - 1];
    if (!leak && b < g.edge.size()) continue;
    std::size_t best = first;
    for (std::size_t c = first; c < b; ++c)
      if (g.voxels[c] >= kMinRegion && g.edge[c] > g.edge[best]) best = c;
    const double least = out ? kLeakAdvantage * out->strength : 0;
    if (g.voxels[best] >= kMinRegion && g.edge[best] > least)
      out = {centreOfPeak(g, best, first, b), g.edge[best], g.border[best], g.voxels[best]};
    first = b;
  }
  // Where the growth was given up at a peak, a stronger edge may lie ahead.
  if (out && !g.whole && g.edge.back() >= kSamePeak * out->strength) return {};
  return out;
}

}  // namespace handlebody
