#include "core/collision/half_boxes.h"

namespace handlebody {

namespace {

// Half boxes are larger than the radius by this factor, so that rounding x/size (relative error 2^-51 of at
// most kMaxIndex) never puts two vertices within the radius into half boxes that are not neighbours.
constexpr double kMargin = 1 + 0x1p-18;
constexpr double kMaxIndex = 0x1p30;
static_assert(kMaxIndex * 0x1p-51 * 4 < kMargin - 1);

}  // namespace

std::optional<HalfBoxes> halfBoxesFor(std::span<const Vec3> points, std::span<const int> vertices,
                                      double radius) {
  if (!(radius > 0) || vertices.empty()) return {};
  Vec3 low = points[vertices[0]];
  Vec3 high = low;
  for (const int v : vertices) {
    low = low.cwiseMin(points[v]);
    high = high.cwiseMax(points[v]);
  }
  const double scale = 1 / (radius * kMargin);
  const Vec3 extent = (high - low) * scale;
  if (!(extent.maxCoeff() < kMaxIndex)) return {};
  return HalfBoxes{low, scale, extent};
}

}  // namespace handlebody
