#include "core/evolution/object_image.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {
// The surface ends a little within the outer faces of the border voxels, so that their centres are inside.
constexpr double kBorder = 0.49;  // voxels
}  // namespace

double ObjectImage::inside(const Vec3& world) const {
  const double value = insideByIntensity(world);
  return neck_ ? std::min(value, neck_->barrier->openness(volume_->grid().toIndex(world))) : value;
}

double ObjectImage::insideByIntensity(const Vec3& world) const {
  const Grid& grid = volume_->grid();
  const Vec3 index = grid.toIndex(world);
  double border = 1;
  for (int a = 0; a < 3; ++a) {
    const double last = grid.size[static_cast<std::size_t>(a)] - 1.0;
    border = std::min({border, index[a] + kBorder, last + kBorder - index[a]});
  }
  const double value = volume_->sample(index);
  double low = range_.low, high = range_.high;
  if (levels_) (std::isfinite(high) ? high : low) = levels_->at(index);
  return std::min({(value - low) / scale_, (high - value) / scale_, border});
}

}  // namespace handlebody
