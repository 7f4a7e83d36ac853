#include "core/collision/near_points.h"

#include <algorithm>
#include <array>
#include <bit>

namespace handlebody {

namespace {
// The cubes are larger than asked for by this factor, so that rounding in scaled coordinates (relative error
// 2^-51 of at most kMaxBoxes) puts no point within the radius into an unmarked box.
constexpr double kMargin = 1 + 0x1p-18;
constexpr double kMaxBoxes = 0x1p30;
// Bits per marked box: one box in eight that should not be looked at is.
constexpr std::size_t kBitsPerVertex = 64;
}  // namespace

void NearPoints::build(std::span<const Vec3> points, std::span<const int> vertices, double radius) {
  low_ = high_ = points[vertices[0]];
  for (const int v : vertices) {
    low_ = low_.cwiseMin(points[v]);
    high_ = high_.cwiseMax(points[v]);
  }
  // So large boxes that they can be numbered.
  const double reach = std::max(radius * kMargin, (high_ - low_).maxCoeff() / kMaxBoxes);
  low_ -= Vec3::Constant(2 * reach);
  high_ += Vec3::Constant(2 * reach);
  scale_ = reach > 0 ? 1 / (2 * reach) : 0;
  const std::size_t size = std::bit_ceil(std::max<std::size_t>(64, kBitsPerVertex * vertices.size()));
  mask_ = static_cast<std::uint32_t>(size - 1);
  bits_.assign(size / 64, 0);
  for (const int v : vertices) {
    const Vec3 a = (points[v] - low_) * scale_;
    const Vec3 first = a - Vec3::Constant(0.5), last = a + Vec3::Constant(0.5);
    for (auto z = static_cast<std::int64_t>(first.z()); z <= static_cast<std::int64_t>(last.z()); ++z)
      for (auto y = static_cast<std::int64_t>(first.y()); y <= static_cast<std::int64_t>(last.y()); ++y)
        for (auto x = static_cast<std::int64_t>(first.x()); x <= static_cast<std::int64_t>(last.x()); ++x) {
          const std::uint32_t at = slot(x, y, z);
          bits_[at >> 6] |= std::uint64_t{1} << (at & 63);
        }
  }
}

}  // namespace handlebody
