#include "core/measure/inscribed_balls.h"

#include "core/geometry/closest_points.h"

namespace handlebody {

namespace {

// A facet that bulges inwards by this part of the radius does not stop a ball: that of edges as long as 0.4
// radii.
constexpr double kFacetTolerance = 0.02;
constexpr int kHalvings = 30;

}  // namespace

Vec3 InscribedBalls::foot(const Vec3& p) {
  nearest_.distance(p, &hint_);
  const Triangle& t = mesh_.triangles[hint_];
  const auto corner = [&](std::size_t c) { return mesh_.points[t[c]]; };
  return closestPoint(p, {corner(0), corner(1), corner(2)});
}

Vec3 InscribedBalls::medialCentre(const Vec3& p) {
  const Vec3 q = foot(p);
  const double begin = (p - q).norm();
  if (!(begin > 0)) return p;
  const Vec3 away = (p - q) / begin;
  const auto fits = [&](double t) { return radius(q + t * away) >= (1 - kFacetTolerance) * t; };
  double low = begin, high = 2 * begin;
  while (fits(high)) {  // ends: no ball is larger than the body
    low = high;
    high *= 2;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return q + low * away;
}

}  // namespace handlebody
