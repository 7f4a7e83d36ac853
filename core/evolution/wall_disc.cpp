#include "core/evolution/wall_disc.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/triangle_distance.h"
#include "core/geometry/triangle_intersection.h"

namespace handlebody {

namespace {
constexpr double kRounding = 1e-9;  // of the radius: the polygon is that much wider than it had to be
}

DiscShape::DiscShape(const WallDisc& disc)
    : centre_(disc.centre), normal_(disc.normal.normalized()), radius_(disc.radius) {
  const Vec3 u = normal_.unitOrthogonal(), v = normal_.cross(u);
  const double step = 2 * std::numbers::pi / kCorners;
  const double wide = radius_ * (1 + kRounding) / std::cos(step / 2);
  for (std::size_t k = 0; k < kCorners; ++k) {
    const double angle = static_cast<double>(k) * step;
    corners_[k] = centre_ + wide * (std::cos(angle) * u + std::sin(angle) * v);
  }
}

Vec3 DiscShape::nearest(const Vec3& p) const {
  const Vec3 away = p - centre_;
  const Vec3 flat = away - away.dot(normal_) * normal_;
  const double length = flat.norm();
  return centre_ + (length > radius_ ? radius_ / length : 1.0) * flat;
}

double DiscShape::distance(const Vec3& p) const { return (p - nearest(p)).norm(); }

Vec3 DiscShape::halfBox() const {
  Vec3 half;
  for (int a = 0; a < 3; ++a) half[a] = radius_ * std::sqrt(std::max(0.0, 1 - normal_[a] * normal_[a]));
  return half;
}

//! True if that is plain from the side of the plane, or the distance, of the corners.
bool DiscShape::isFar(const std::array<Vec3, 3>& t, double clearance) const {
  const double a = (t[0] - centre_).dot(normal_), b = (t[1] - centre_).dot(normal_),
               c = (t[2] - centre_).dot(normal_), room = clearance + 1e-6 * radius_;
  if (std::min({a, b, c}) > room || std::max({a, b, c}) < -room) return true;
  const double size = std::sqrt(std::max((t[1] - t[0]).squaredNorm(), (t[2] - t[0]).squaredNorm()));
  return (t[0] - centre_).norm() > size + 1.01 * radius_ + room;
}

template <typename F>
bool DiscShape::anyPart(F&& f) const {
  for (std::size_t k = 0; k < kCorners; ++k)
    if (f(corners_[k], corners_[(k + 1) % kCorners])) return true;
  return false;
}

bool DiscShape::meets(const std::array<Vec3, 3>& t) const {
  if (isFar(t, 0)) return false;
  return anyPart(
      [&](const Vec3& a, const Vec3& b) { return trianglesIntersect(t[0], t[1], t[2], centre_, a, b); });
}

bool DiscShape::clears(const std::array<Vec3, 3>& t, double clearance) const {
  if (isFar(t, clearance)) return true;
  return !anyPart([&](const Vec3& a, const Vec3& b) {
    return squaredDistance(t, {centre_, a, b}) <= clearance * clearance ||
           trianglesIntersect(t[0], t[1], t[2], centre_, a, b);
  });
}

}  // namespace handlebody
