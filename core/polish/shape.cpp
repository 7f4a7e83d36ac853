#include "core/polish/shape.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/geometry/triangle_angles.h"

namespace handlebody {

namespace {

constexpr double kMinFraction = 1e-4;  // below that all are alike, so that sums stay sums
constexpr double kClearly = 1e-3;      // of the sum: what rounding cannot make, so that it ends

}  // namespace

double WantedShape::ofFace(const Vec3& a, const Vec3& b, const Vec3& c) const {
  return std::min(1.0, leastAngle(a, b, c) / angle);
}

double WantedShape::ofEdge(const Vec3& p, const Vec3& q, const Vec3& c, const Vec3& d) const {
  // Most edges bend by less than a right angle, which the normals tell.
  const Vec3 e = q - p;
  if (e.cross(c - p).dot(e.cross(d - p)) < 0 && dihedral <= 90) return 1;
  return std::min(1.0, dihedralAngle(p, q, c, d) / dihedral);
}

void Badness::add(double part) {
  if (part >= 1) return;
  worst = std::min(worst, part);
  const double p = std::max(part, kMinFraction);
  sum += 1 / (p * p) - 1 + 0.1;
}

bool Badness::isBetterThan(const Badness& other) const {
  return sum < (1 - kClearly) * other.sum && worst >= other.worst;
}

}  // namespace handlebody
