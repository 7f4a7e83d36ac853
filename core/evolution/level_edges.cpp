#include "core/evolution/level_edges.h"

#include <algorithm>
#include <cmath>

namespace handlebody::region {

LevelEdges::LevelEdges(ReachedBricks& bricks)
    : bricks_(bricks), sumGradient_(kBins, 0), sumSquared_(kBins, 0) {}

void LevelEdges::add(Brick& brick, const Entry& entry, int level) {
  const Voxel at = inBrick(entry.place);
  if (bricks_.volume().hasPadding() && bricks_.isBesidePadding(brick.inGrid(at))) return;
  const double squared =
      isWithin(brick, at) ? squaredGradientWithin(brick, at) : squaredGradient(brick, entry, at);
  sumGradient_[level] += std::sqrt(squared);
  sumSquared_[level] += squared;
}

//! Square of the gradient at a voxel all of whose neighbours lie in its brick.
double LevelEdges::squaredGradientWithin(const Brick& brick, const Voxel& at) const {
  const float* here = brick.values + valueIndex(at);
  const float sign = bricks_.sign();
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = sign * here[-kValueStride[axis]], high = sign * here[kValueStride[axis]];
    const double span = bricks_.volume().grid().spacing[static_cast<int>(axis)] * 2;
    squared += (high - low) * (high - low) / (span * span);
  }
  return squared;
}

double LevelEdges::squaredGradient(Brick& brick, const Entry& entry, const Voxel& at) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Neighbour before = bricks_.neighbour(brick, at, entry.place, axis, 0);
    const Neighbour after = bricks_.neighbour(brick, at, entry.place, axis, 1);
    const double low = before.brick ? bricks_.value(before) : entry.value;
    const double high = after.brick ? bricks_.value(after) : entry.value;
    const double span =
        bricks_.volume().grid().spacing[axis] * ((before.brick ? 1 : 0) + (after.brick ? 1 : 0));
    if (span > 0) squared += (high - low) * (high - low) / (span * span);
  }
  return squared;
}

double LevelEdges::of(int level) const {
  return sumGradient_[level] > 0 ? sumSquared_[level] / sumGradient_[level] : 0;
}

std::vector<double> LevelEdges::smoothed(std::size_t levels) const {
  constexpr int kHalfWidth = 4;
  const int count = static_cast<int>(levels);
  std::vector<double> edge(levels, 0);
  for (int b = 0; b < count; ++b) {
    double s1 = 0, s2 = 0;
    for (int c = std::max(0, b - kHalfWidth); c <= std::min(count - 1, b + kHalfWidth); ++c) {
      s1 += sumGradient_[c];
      s2 += sumSquared_[c];
    }
    edge[b] = s1 > 0 ? s2 / s1 : 0;
  }
  return edge;
}

}  // namespace handlebody::region
