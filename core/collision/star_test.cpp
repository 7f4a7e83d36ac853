#include "core/collision/star_test.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace handlebody {
namespace {

// Rounding errors, with u = 2^-53 and |e| the longest edge at v. An edge vector is a difference of two
// points: relative error u per component. Each component of a cross product of two such is off by at
// most 4.1u|e|², and the dot product with d (exact as given) by 3u|e|²|d|₁ more: below 8u|e|²|d|₁ together.
constexpr double kConeBound = 16 * 0x1p-53;
// h = d × g is off by 2.1u|d||g| per component, h·e by less than 10u|d||g||e|.
constexpr double kWindingBound = 32 * 0x1p-53;

// Below this (1e-60 mm, squared) products of four lengths come near the underflow and the bounds do not hold.
constexpr double kTiny = 1e-120;

// Any direction; an odd one, so that meshes with a symmetry do not have vertices on the line of the count.
const Vec3 kOdd(0.4217, -0.7353, 0.5306);

double norm1(const Vec3& v) { return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z()); }

}  // namespace

StarSize measureStar(std::span<const Vec3> points, int v, std::span<const Corner> corners) {
  const Vec3& centre = points[static_cast<std::size_t>(v)];
  StarSize size;
  for (const Corner& c : corners) {
    const Vec3& a = points[static_cast<std::size_t>(c.next)];
    const Vec3& b = points[static_cast<std::size_t>(c.prev)];
    size.spoke = std::max({size.spoke, (a - centre).squaredNorm(), (b - centre).squaredNorm()});
    size.edge = std::max(size.edge, (b - a).squaredNorm());
  }
  size.edge = std::max(size.edge, size.spoke);
  return size;
}

bool StarTest::isEmbedded(std::span<const Vec3> points, int v, std::span<const Corner> corners,
                          StarSize& size) {
  const std::size_t k = corners.size();
  if (edges_.size() < k + 1) {
    edges_.resize(k + 1);
    normals_.resize(k + 1);
  }
  const Vec3& centre = points[static_cast<std::size_t>(v)];
  double longest = 0;
  for (std::size_t i = 0; i < k; ++i) {
    edges_[i] = points[static_cast<std::size_t>(corners[i].next)] - centre;
    longest = std::max(longest, edges_[i].squaredNorm());
  }
  edges_[k] = edges_[0];
  size.spoke = longest;
  size.edge = longest;
  for (std::size_t i = 0; i < k; ++i) {
    size.edge = std::max(size.edge, (edges_[i + 1] - edges_[i]).squaredNorm());
  }
  if (longest < kTiny) return false;

  Vec3 up = Vec3::Zero();
  for (std::size_t i = 0; i < k; ++i) {
    normals_[i] = edges_[i].cross(edges_[i + 1]);
    up += normals_[i];
  }
  const double coneBound = kConeBound * longest * norm1(up);
  const Vec3 across = up.cross(kOdd);
  const double windingBound = kWindingBound * norm1(up) * norm1(kOdd) * std::sqrt(longest);
  int turns = 0;
  double before = across.dot(edges_[k - 1]);
  for (std::size_t i = 0; i < k; ++i) {
    if (!(normals_[i].dot(up) > coneBound)) return false;
    const double here = across.dot(edges_[i]);
    if (!(std::abs(here) > windingBound)) return false;
    turns += before < 0 && here > 0;
    before = here;
  }
  return turns == 1;
}

}  // namespace handlebody
