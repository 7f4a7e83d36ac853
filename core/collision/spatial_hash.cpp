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

  radiusSquared_ = radius * radius * (1 + 0x1p-40);
  const auto size =
      std::bit_ceil(std::max<std::uint32_t>(8, 2 * static_cast<std::uint32_t>(vertices.size())));
  mask_ = size - 1;
  start_.assign(size + 1, 0);
  unsorted_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Entry& e = unsorted_[i];
    e.vertex = vertices[i];
    e.point = points[static_cast<std::size_t>(e.vertex)];
    const Vec3 a = (e.point - low) * scale;  // not negative, so truncation is the floor
    e.x = static_cast<int>(a.x());
    e.y = static_cast<int>(a.y());
    e.z = static_cast<int>(a.z());
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
  entries_.resize(vertices.size());
  entries_.resize(vertices.size() + kLanes, Entry{Vec3::Zero(), -1, 0, 0, 0});
  for (std::size_t i = unsorted_.size(); i-- > 0;) {
    const Entry& e = unsorted_[i];
    entries_[--start_[bucket(e.x, e.y, e.z)]] = e;
  }
  return true;
}

}  // namespace handlebody
