#include "core/geometry/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handlebody {

namespace {

double squaredToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).squaredNorm();
}

//! Of the segments ab and cd (Ericson, 5.1.9). Where a foot lies beyond an end, a corner and an edge are
//! nearest, which the caller looks at besides.
double squaredBetweenLines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  const double s = (uv * vw - vv * uw) / area, t = (uu * vw - uv * uw) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::numeric_limits<double>::infinity();
  return (w + s * u - t * v).squaredNorm();
}

bool apartAlong(const Vec3& axis, const std::array<Vec3, 3>& t, const Vec3& half) {
  const double reach = half.dot(axis.cwiseAbs());
  const double x = axis.dot(t[0]), y = axis.dot(t[1]), z = axis.dot(t[2]);
  return std::min({x, y, z}) > reach || std::max({x, y, z}) < -reach;
}

}  // namespace

double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, n = ab.cross(ac);
  const double area = n.squaredNorm();
  const double byEdges =
      std::min({squaredToSegment(p, a, b), squaredToSegment(p, b, c), squaredToSegment(p, c, a)});
  if (!(area > 0)) return byEdges;
  const Vec3 ap = p - a;
  const double u = ab.cross(ap).dot(n), v = ap.cross(ac).dot(n);  // barycentric, times the area
  if (u < 0 || v < 0 || u + v > area) return byEdges;
  const double height = ap.dot(n);
  return std::min(height * height / area, byEdges);
}

double squaredDistance(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least =
        std::min({least, squaredDistance(s[i], t[0], t[1], t[2]), squaredDistance(t[i], s[0], s[1], s[2])});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, squaredBetweenLines(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return least;
}

bool meetsBox(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) {
  const std::array<Vec3, 3> t{a, b, c};
  for (int i = 0; i < 3; ++i)
    if (apartAlong(Vec3::Unit(i), t, half)) return false;
  const std::array<Vec3, 3> edges{b - a, c - b, a - c};
  if (apartAlong(edges[0].cross(edges[1]), t, half)) return false;
  for (const Vec3& e : edges)
    for (int i = 0; i < 3; ++i)
      if (apartAlong(Vec3::Unit(i).cross(e), t, half)) return false;
  return true;
}

}  // namespace handlebody
