#include "core/collision/star_test.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/collision/lanes.h"

namespace handlebody {
namespace {

// Rounding errors, with u = 2^-53 (or 2^-24 in single precision) and |e| the longest edge at v. An edge
// vector is a difference of two points: relative error u per component. Each component of a cross product of
// two such is off by at most 4.1u|e|², and the dot product with d (exact as given) by 3u|e|²|d|₁ more: below
// 8u|e|²|d|₁ together.
constexpr double kConeBound = 16 * 0x1p-53;
constexpr float kConeBoundSingle = 16 * 0x1p-24f;
// h = d × g is off by 2.1u|d||g| per component, h·e by less than 10u|d||g||e|.
constexpr double kWindingBound = 32 * 0x1p-53;
constexpr float kWindingBoundSingle = 32 * 0x1p-24f;

// Below this (1e-60 mm, squared) products of four lengths come near the underflow and the bounds do not hold.
constexpr double kTiny = 1e-120;

// Any direction; an odd one, so that meshes with a symmetry do not have vertices on the line of the count.
const Vec3 kOdd(0.4217, -0.7353, 0.5306);

// In single precision edges must be neither so short nor so long, nor the faces together so small (all in
// parts of edge²), that the bounds above come within 2^9 of the smallest normal number: what underflow leaves
// out is far below them then.
constexpr float kSmallest = 1e-12f, kLargest = 1e12f, kThin = 1e-6f;
// Lengths from single precision are off by less than 13u.
constexpr double kLonger = 1 + 0x1p-19;

// The radius of a circle is computed where the face is not so thin that rounding spoils it; elsewhere a third
// of the squared longest edge will do for its square (Jung). Where the squared area vector is above
// kThinFace of the squared longest edge's square, all that comes from single precision is off by less than
// 2^-11.
constexpr float kThinFace = 0x1p-12f;
constexpr float kWider = 1 + 0x1p-10f;

//! Squared radius of the smallest circle around a triangle, not too small, by its squared edges and the
//! square of the cross product of two of them.
double enclosingCircleSquared(double a, double b, double c, double areaSquared) {
  const double longest = std::max({a, b, c});
  const bool isThin = !(areaSquared > static_cast<double>(kThinFace) * longest * longest);
  if (isThin || longest < kTiny) return longest / 3;
  if (a + b + c <= 2 * longest) return longest / 4;  // obtuse: the longest edge is a diameter
  return std::min(longest / 3, a * b / (4 * areaSquared) * c);
}

double norm1(const Vec3& v) { return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z()); }

//! Up to seven edges at a vertex, the first once more after the last, zeros from there on.
class FewEdges {
 public:
  static constexpr std::size_t kMaxEdges = 7;

  FewEdges(std::span<const Vec3> points, int v, std::span<const Corner> corners) : count_(corners.size()) {
    const Vec3& centre = points[v];
    const auto end = [&](std::size_t i) -> const Vec3& {
      const int next = corners[i < count_ ? i : 0].next;
      return points[i <= count_ ? next : v];
    };
    // Put together in registers: what is stored one by one cannot be loaded as a vector right away.
    for (const std::size_t half : {0, 1}) {
      const Vec3 &a = end(4 * half), &b = end(4 * half + 1), &c = end(4 * half + 2), &d = end(4 * half + 3);
      const auto lanes = [&](int axis) {
        const double o = centre[axis];
        return LaneFloats{static_cast<float>(a[axis] - o), static_cast<float>(b[axis] - o),
                          static_cast<float>(c[axis] - o), static_cast<float>(d[axis] - o)};
      };
      edges_[half] = {lanes(0), lanes(1), lanes(2)};
    }
  }

  bool isEmbedded(StarSize& size) const {
    LaneFloats longestEdge{}, enclosingCircle{};
    Lanes sum{};
    std::array<Lanes, 2> normals;
    for (const std::size_t half : {0, 1}) {
      const Lanes &a = edges_[half], beyond = half == 0 ? edges_[1] : Lanes{};
      const Lanes b{following(a.x, beyond.x), following(a.y, beyond.y), following(a.z, beyond.z)};
      const Lanes n = normals[half] = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
      sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
      const Lanes along{b.x - a.x, b.y - a.y, b.z - a.z};
      const LaneFloats aa = a.dot(a);
      const LaneBits isFace = (LaneBits{0, 1, 2, 3} + static_cast<int>(4 * half)) < static_cast<int>(count_);
      longestEdge = larger(longestEdge, aa);
      enclosingCircle =
          larger(enclosingCircle,
                 isFace ? enclosingCircleSquared(aa, b.dot(b), along.dot(along), n.dot(n)) : enclosingCircle);
    }
    const float longest = greatest(longestEdge);
    if (!(longest > kSmallest && longest < kLargest)) return false;
    size.longestEdge = kLonger * static_cast<double>(longest);
    size.enclosingCircle = static_cast<double>(kWider * greatest(enclosingCircle));

    const std::array<float, 3> up{total(sum.x), total(sum.y), total(sum.z)}, odd{0.4217f, -0.7353f, 0.5306f};
    const float up1 = std::abs(up[0]) + std::abs(up[1]) + std::abs(up[2]);
    if (!(up1 > kThin * longest)) return false;
    const std::array<float, 3> across{up[1] * odd[2] - up[2] * odd[1], up[2] * odd[0] - up[0] * odd[2],
                                      up[0] * odd[1] - up[1] * odd[0]};
    const float coneBound = kConeBoundSingle * longest * up1;
    const float windingBound = kWindingBoundSingle * up1 * 1.6877f * std::sqrt(longest);
    LaneBits upright{}, before{}, after{};  // bit i: face i looks up; edge i lies on either side of the count
    for (const int half : {0, 1}) {
      const LaneBits bits = LaneBits{1, 2, 4, 8} << 4 * half;
      const auto i = static_cast<std::size_t>(half);
      const LaneFloats side = edges_[i].dot(across);
      upright |= (normals[i].dot(up) > coneBound) & bits;
      before |= (side < -windingBound) & bits;
      after |= (side > windingBound) & bits;
    }
    const unsigned faces = (1u << count_) - 1;
    const unsigned left = anyLane(before) & faces, right = anyLane(after) & faces;
    if ((anyLane(upright) & faces) != faces || (left | right) != faces) return false;
    const unsigned leftBefore = left << 1 | left >> (count_ - 1);
    return std::popcount(leftBefore & right) == 1;
  }

 private:
  struct Lanes {
    LaneFloats x, y, z;
    LaneFloats dot(const Lanes& o) const { return x * o.x + y * o.y + z * o.z; }
    LaneFloats dot(const std::array<float, 3>& o) const { return x * o[0] + y * o[1] + z * o[2]; }
  };
  //! As above, in single precision.
  static LaneFloats enclosingCircleSquared(const LaneFloats& a, const LaneFloats& b, const LaneFloats& c,
                                           const LaneFloats& areaSquared) {
    const LaneFloats longest = larger(larger(a, b), c), third = longest * (1.0f / 3);
    const LaneFloats around = a * b / (4 * areaSquared) * c;  // only where that is no division by zero
    const LaneFloats wide = a + b + c <= 2 * longest ? longest * 0.25f : around < third ? around : third;
    return areaSquared > kThinFace * longest * longest ? wide : third;
  }
  //! Lanes 1, 2, 3 and then the first of `next`.
  static LaneFloats following(const LaneFloats& lanes, const LaneFloats& next) {
    return __builtin_shufflevector(lanes, next, 1, 2, 3, 4);
  }
  static LaneFloats larger(const LaneFloats& a, const LaneFloats& b) { return a > b ? a : b; }
  static float greatest(const LaneFloats& v) { return std::max({v[0], v[1], v[2], v[3]}); }
  static float total(const LaneFloats& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

  std::size_t count_;
  std::array<Lanes, 2> edges_;
};

}  // namespace

bool StarTest::isEmbedded(std::span<const Vec3> points, int v, std::span<const Corner> corners,
                          StarSize& size) {
  if (corners.size() <= FewEdges::kMaxEdges && FewEdges(points, v, corners).isEmbedded(size)) return true;
  return isEmbeddedInDouble(points, v, corners, size);
}

StarSize measureStar(std::span<const Vec3> points, int v, std::span<const Corner> corners) {
  const Vec3& centre = points[v];
  StarSize size;
  for (const Corner& c : corners) {
    const Vec3& a = points[c.next];
    const Vec3& b = points[c.prev];
    const Vec3 ea = a - centre, eb = b - centre;
    size.longestEdge = std::max({size.longestEdge, ea.squaredNorm(), eb.squaredNorm()});
    size.enclosingCircle = std::max(
        size.enclosingCircle, enclosingCircleSquared(ea.squaredNorm(), eb.squaredNorm(),
                                                     (b - a).squaredNorm(), ea.cross(eb).squaredNorm()));
  }
  size.enclosingCircle *= static_cast<double>(kWider);
  return size;
}

bool StarTest::isEmbeddedInDouble(std::span<const Vec3> points, int v, std::span<const Corner> corners,
                                  StarSize& size) {
  const std::size_t k = corners.size();
  if (edges_.size() < k + 1) {
    edges_.resize(k + 1);
    normals_.resize(k + 1);
  }
  const Vec3& centre = points[v];
  for (std::size_t i = 0; i < k; ++i) edges_[i] = points[corners[i].next] - centre;
  edges_[k] = edges_[0];
  size = measureStar(points, v, corners);
  const double longest = size.longestEdge;
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
