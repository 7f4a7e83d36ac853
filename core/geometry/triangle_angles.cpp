#include "core/geometry/triangle_angles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace handlebody {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

double leastAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - b, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  // It faces the shortest edge.
  const double dot = uu <= vv && uu <= ww ? -v.dot(w) : vv <= ww ? -w.dot(u) : -u.dot(v);
  return std::atan2(u.cross(v).norm(), dot) * kDegrees;
}

double dihedralAngle(const Vec3& p, const Vec3& q, const Vec3& c, const Vec3& d) {
  const Vec3 along = (q - p).stableNormalized();
  const Vec3 u = (c - p) - (c - p).dot(along) * along, v = (d - p) - (d - p).dot(along) * along;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * kDegrees;
}

}  // namespace handlebody
