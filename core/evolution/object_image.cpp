#include "core/evolution/object_image.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {
// The surface ends a little within the outer faces of the border voxels, so that their centres are inside.
constexpr double kBorder = 0.49;  // voxels
// Units of the scale: what is nearer to a level is compared with the level of the place.
constexpr double kNear = 1e-6;
// Cells from what clicks have changed: up to the first nothing of what was before counts, from the second on
// nothing else.
constexpr double kChanged = 1, kUnchanged = 3;
// Cells from a click or its ball: up to the first the surface is the region's own, from the second on the
// levels have it.
constexpr double kHeld = 1, kFree = 3;

//! A limit that only one of the two has is that of the nearer.
double between(double a, double b, double share) {
  if (std::isfinite(a) && std::isfinite(b)) return a + share * (b - a);
  return share < 0.5 ? a : b;
}

//! From a (share 0) to b (1).
ObjectImage::Limits between(const ObjectImage::Limits& a, const ObjectImage::Limits& b, double share) {
  return {between(a.low, b.low, share), between(a.high, b.high, share), a.scale,
          between(a.most, b.most, share), between(a.least, b.least, share)};
}

}  // namespace

ObjectImage::Reading ObjectImage::read(const Vec3& world) const {
  const Vec3 index = volume_->grid().toIndex(world);
  Reading reading{volume_->sample(index), limitsWithin(index, world, true)};
  if (neck_) reading.limits.most = std::min(reading.limits.most, neck_->barrier->openness(index));
  if (walls_) reading.limits.most = std::min(reading.limits.most, walls_->room(world, index) / voxel_);
  return reading;
}

//! Most voxels are beyond all levels.
void ObjectImage::findBounds() {
  surely_ = maybe_ = range_;
  if (levels_ && std::isfinite(range_.high)) {
    surely_.high = levels_->lowest();
    maybe_.high = levels_->highest();
  } else if (levels_) {
    surely_.low = levels_->highest();
    maybe_.low = levels_->lowest();
  }
  const double near = kNear * scale_;
  surely_ = {surely_.low + near, surely_.high - near};
  maybe_ = {maybe_.low - near, maybe_.high + near};
}

bool ObjectImage::holds(const std::array<int, 3>& voxel) const {
  return holds(voxel, static_cast<double>(volume_->at(voxel[0], voxel[1], voxel[2])));
}

void ObjectImage::holdsRow(const std::array<int, 3>& first, int n, std::uint8_t* held) const {
  constexpr int kShift = SmoothedVolume::kBrickShift, kBrick = SmoothedVolume::kBrick, kMask = kBrick - 1;
  constexpr int kStored = SmoothedVolume::kStored;
  for (int i = 0; i < n;) {
    const int x = first[0] + i, end = std::min(n, i + kBrick - (x & kMask));
    const float* row = volume_->brick(x >> kShift, first[1] >> kShift, first[2] >> kShift) +
                       ((first[2] & kMask) * kStored + (first[1] & kMask)) * kStored - (x - (x & kMask));
    for (; i < end; ++i)
      held[i] = holds({first[0] + i, first[1], first[2]}, static_cast<double>(row[first[0] + i]));
  }
}

bool ObjectImage::holds(const std::array<int, 3>& voxel, double value) const {
  if (value < maybe_.low || value > maybe_.high) return false;
  if (!neck_ && value > surely_.low && value < surely_.high) return true;
  const Vec3 index(voxel[0], voxel[1], voxel[2]);
  Limits limits{range_.low, range_.high, scale_, 1};
  if (region_.field || levels_) {
    const Vec3 world = volume_->grid().toWorld(index);
    // Most voxels are too far from the region for any level; a side is no more than 1.
    if (region_.field && !before_ && region_.field->at(world) <= -region_.slack) return false;
    limits = limitsWithin(index, world, true);
  }
  if (neck_) limits.most = std::min(limits.most, neck_->barrier->openness(index));
  return limits.inside(value) > 0;
}

bool ObjectImage::holdsBox(const std::array<int, 3>& low, const std::array<int, 3>& high) const {
  float least = std::numeric_limits<float>::infinity(), most = -least;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        const float value = volume_->at(i, j, k);
        least = std::min(least, value);
        most = std::max(most, value);
      }
  const Vec3 middle(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]));
  Limits limits = limitsWithin(middle, volume_->grid().toWorld(middle), true);
  if (neck_) limits.most = std::min(limits.most, neck_->barrier->openness(middle));
  return limits.inside(static_cast<double>(least)) > 0 && limits.inside(static_cast<double>(most)) > 0;
}

ObjectImage::Limits ObjectImage::limitsWithin(const Vec3& index, const Vec3& world, bool held) const {
  const Grid& grid = volume_->grid();
  Limits limits{range_.low, range_.high, scale_, 1};
  for (int a = 0; a < 3; ++a) {
    const double last = grid.size[a] - 1.0;
    limits.most = std::min({limits.most, index[a] + kBorder, last + kBorder - index[a]});
  }
  const double share = before_ ? shareOfBefore(world) : 0;
  if (share == 1) return before_->limitsWithin(index, world, held);
  if (region_.field) limits = limitsOfRegion(world, held, limits);
  if (share > 0) return between(limits, before_->limitsWithin(index, world, held), share);
  if (levels_) (std::isfinite(limits.high) ? limits.high : limits.low) = levels_->at(index);
  return limits;
}

ObjectImage::Limits ObjectImage::limitsOfRegion(const Vec3& world, bool held, Limits limits) const {
  const Vec3 place = region_.levelGrid.toIndex(world);
  const double side = region_.side->at(place);
  (side > 0 ? limits.high : limits.low) = (side > 0 ? region_.high : region_.low)->at(place);
  if (!held) return limits;
  const double deep = region_.field->at(world), slack = std::abs(side) * slackAt(world);
  if (!region_.mayHaveHoles) limits.least = (deep - slack) / region_.cell;
  limits.most = std::min(limits.most, (deep + slack) / region_.cell);
  return limits;
}

double ObjectImage::slackAt(const Vec3& world) const {
  double share = 1;
  for (const ObjectClick& click : region_.clicks) {
    const double away = (click.place - world).norm() - click.radius.value_or(0);
    share = std::min(share, (away / region_.cell - kHeld) / (kFree - kHeld));
  }
  return std::max(share, 0.0) * region_.slack;
}

double ObjectImage::shareOfBefore(const Vec3& world) const {
  return std::clamp((-changes_->at(world) / region_.cell - kChanged) / (kUnchanged - kChanged), 0.0, 1.0);
}

}  // namespace handlebody
