#include "core/evolution/growing_region.h"

#include <algorithm>

#include "core/evolution/region_growth.h"

namespace handlebody::region {

namespace {

// A region that has reached the faces of the volume with more than this part of them, and has touched a
// fifth of a large volume, is given up as a leak. What lies within the volume may fill any part of it.
constexpr double kReachesBorder = 3e-3;
constexpr std::size_t kPartOfVolume = 5;
// And so is one of which one level lets in more than this, and a fifth of the volume.
constexpr std::size_t kMaxVoxels = 2'000'000;

double voxelsOnFaces(const Grid& grid) {
  const auto& n = grid.size;
  return static_cast<double>(grid.voxelCount()) -
         std::max(0.0, n[0] - 2.0) * std::max(0.0, n[1] - 2.0) * std::max(0.0, n[2] - 2.0);
}

}  // namespace

LeakLimits::LeakLimits(const SmoothedVolume& volume)
    : volume_(volume),
      mostVoxels_(std::max(kMaxVoxels, volume.grid().voxelCount() / kPartOfVolume)),
      mostBricks_(std::max(kFewBricks, volume.brickCount() / kPartOfVolume)),
      borderVoxels_(voxelsOnFaces(volume.grid())),
      mostBorder_(kReachesBorder * borderVoxels_) {}

bool LeakLimits::isBackground(std::size_t taken) const {
  return taken >= mostVoxels_ && borderShare() > kBackgroundBorder;
}

}  // namespace handlebody::region
