#include "sample_volumes/distances.h"

#include <algorithm>
#include <cmath>

namespace handlebody::phantoms {

double ballDistance(const Vec3& p, double radius) { return p.norm() - radius; }

double cylinderDistance(const Vec3& p, const Vec3& axis, double radius) {
  return (p - p.dot(axis) * axis).norm() - radius;
}

double capsuleDistance(const Vec3& p, double halfLength, double radius) {
  return Vec3(p.x() - std::clamp(p.x(), -halfLength, halfLength), p.y(), p.z()).norm() - radius;
}

double torusDistance(const Vec3& p, const Vec3& axis, double ring, double tube) {
  const double height = p.dot(axis);
  const double radial = (p - height * axis).norm() - ring;
  return std::sqrt(radial * radial + height * height) - tube;
}

double boxDistance(const Vec3& p, const Vec3& half, double rounding) {
  const Vec3 q = p.cwiseAbs() - half + Vec3::Constant(rounding);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - rounding;
}

namespace {

// Distance of q (all coordinates >= 0) to the face x_a = half outside the circle that the ball cuts out.
double faceDistance(const Vec3& q, int a, double half, double circle) {
  double u = std::min(q[(a + 1) % 3], half);
  double v = std::min(q[(a + 2) % 3], half);
  const double length = std::hypot(u, v);
  if (length == 0) {
    u = circle;
  } else if (length < circle) {
    u *= circle / length;
    v *= circle / length;
  }
  return Vec3(q[a] - half, q[(a + 1) % 3] - u, q[(a + 2) % 3] - v).norm();
}

}  // namespace

double frameDistance(const Vec3& p, double half, double radius) {
  const Vec3 q = p.cwiseAbs();  // the nearest surface point lies in the same octant
  const double circle = std::sqrt(radius * radius - half * half);
  double distance = faceDistance(q, 0, half, circle);
  for (int a = 1; a < 3; ++a) distance = std::min(distance, faceDistance(q, a, half, circle));
  const double length = q.norm();
  // The sphere counts where the radial projection lies in the cube; elsewhere its nearest point is on a
  // circle.
  if (q.maxCoeff() * radius <= half * length) distance = std::min(distance, std::abs(length - radius));
  const bool inside = q.maxCoeff() < half && length > radius;
  return inside ? -distance : distance;
}

}  // namespace handlebody::phantoms
