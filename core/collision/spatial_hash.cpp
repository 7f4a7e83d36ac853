#include "core/collision/spatial_hash.h"

#include <bit>
#include <cmath>

namespace handlebody {
namespace {

// Half boxes are larger than the radius by this factor, so that rounding x/size (relative error 2^-51 of at
// most kMaxIndex) never puts two vertices within the radius into half boxes that are not neighbours.
constexpr double kMargin = 1 + 0x1p-18;
constexpr double kMaxIndex = 0x1p30;
static_assert(kMaxIndex * 0x1p-51 * 4 < kMargin - 1);

}  // namespace

bool SpatialHash::build(std::span<const Vec3> points, std::span<const int> vertices, double radius) {
  if (!(radius > 0) || vertices.empty()) return false;
  Vec3 low = points[static_cast<std::size_t>(vertices[0])];
  Vec3 high = low;
  for (const int v : vertices) {
    low = low.cwiseMin(points[static_cast<std::size_t>(v)]);
    high = high.cwiseMax(points[static_cast<std::size_t>(v)]);
  }
  const double scale = 1 / (radius * kMargin);
  if (!((high - low).maxCoeff() * scale < kMaxIndex)) return false;

  points_ = points;
  radiusSquared_ = radius * radius * (1 + 0x1p-40);
  // In half boxes the radius is below 1. Each coordinate difference is off by less than 2^-22 times the
  // largest coordinate (two roundings to single precision, one of the difference), the sum of squares by a
  // few 2^-24.
  const double off = std::sqrt(3.0) * 0x1p-22 * (high - low).maxCoeff() * scale;
  rejectBeyond_ = static_cast<float>((1 + off) * (1 + off) * (1 + 0x1p-20));
  const auto size =
      std::bit_ceil(std::max<std::uint32_t>(8, 2 * static_cast<std::uint32_t>(vertices.size())));
  mask_ = size - 1;
  start_.assign(size + 1, 0);
  unsorted_.resize(vertices.size());
  for (auto& c : unsortedAt_) c.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 a = (points[static_cast<std::size_t>(vertices[i])] - low) * scale;
    // Not negative, so truncation is the floor.
    const Entry e{vertices[i], static_cast<int>(a.x()), static_cast<int>(a.y()), static_cast<int>(a.z())};
    unsorted_[i] = e;
    for (std::size_t axis = 0; axis < 3; ++axis)
      unsortedAt_[axis][i] = static_cast<float>(a[static_cast<int>(axis)]);
    ++start_[bucket(e.x, e.y, e.z)];
  }
  double crowd = 0;
  std::uint32_t sum = 0;
  for (std::uint32_t& entry : start_) {
    crowd += static_cast<double>(entry) * static_cast<double>(entry);
    sum += entry;
    entry = sum;
  }
  if (crowd > kCrowd * static_cast<double>(vertices.size())) return false;
  sortByBucket(vertices.size());
  return true;
}

void SpatialHash::sortByBucket(std::size_t count) {
  constexpr float kFarAway = -4;
  entries_.resize(count);
  for (auto& c : at_) {
    c.resize(count);
    c.resize(count + kLanes, kFarAway);
  }
  for (std::size_t i = count; i-- > 0;) {
    const Entry& e = unsorted_[i];
    const std::uint32_t slot = --start_[bucket(e.x, e.y, e.z)];
    entries_[slot] = e;
    for (std::size_t axis = 0; axis < 3; ++axis) at_[axis][slot] = unsortedAt_[axis][i];
  }
}

}  // namespace handlebody
