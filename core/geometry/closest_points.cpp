#include "core/geometry/closest_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace handlebody {

namespace {

Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length = ab.squaredNorm();
  return a + (length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0) * ab;
}

//! Keeps the nearest pair.
struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  std::array<Vec3, 2> pair{Vec3::Zero(), Vec3::Zero()};
  void offer(const Vec3& a, const Vec3& b) {
    const double d = (a - b).squaredNorm();
    if (!(d < squared)) return;
    squared = d;
    pair = {a, b};
  }
};

//! Of the lines through ab and cd, if both feet lie between the ends; else a corner is nearest.
void offerBetweenLines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Nearest& nearest) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return;
  const double s = (uv * vw - vv * uw) / area, t = (uu * vw - uv * uw) / area;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) nearest.offer(a + s * u, c + t * v);
}

}  // namespace

Vec3 closestPoint(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a, ac = c - a, ap = p - a, n = ab.cross(ac);
  const double area = n.squaredNorm();
  if (area > 0) {
    const double u = ab.cross(ap).dot(n), v = ap.cross(ac).dot(n);  // barycentric, times the area
    if (u >= 0 && v >= 0 && u + v <= area) return p - ap.dot(n) / area * n;
  }
  Nearest nearest;
  nearest.offer(p, closestOnSegment(p, a, b));
  nearest.offer(p, closestOnSegment(p, b, c));
  nearest.offer(p, closestOnSegment(p, c, a));
  return nearest.pair[1];
}

std::array<Vec3, 2> closestPoints(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  Nearest nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    nearest.offer(s[i], closestPoint(s[i], t));
    nearest.offer(closestPoint(t[i], s), t[i]);
    for (std::size_t j = 0; j < 3; ++j)
      offerBetweenLines(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3], nearest);
  }
  return nearest.pair;
}

}  // namespace handlebody
