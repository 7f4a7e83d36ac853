#include "core/geometry/triangle_intersection.h"

#include <array>
#include <utility>

#include "core/geometry/flat_intersection.h"
#include "core/geometry/predicates.h"

namespace handlebody {
namespace {

using detail::TrianglePoints;
using Signs = std::array<int, 3>;

//! Sides of the points of `t` with respect to the plane of `plane`.
Signs sidesOf(const TrianglePoints& plane, const TrianglePoints& t) {
  return {orient3d(*plane[0], *plane[1], *plane[2], *t[0]), orient3d(*plane[0], *plane[1], *plane[2], *t[1]),
          orient3d(*plane[0], *plane[1], *plane[2], *t[2])};
}

bool allZero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

bool strictlyOnOneSide(const Signs& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

//! Turns t until t[0] alone is above (true) or below (false) the two others, as seen from the other plane:
//! its two edges then cross that plane, each in one point.
bool loneVertexFirst(TrianglePoints& t, const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int lone = s[i];
    const int p = s[(i + 1) % 3];
    const int q = s[(i + 2) % 3];
    const bool above = (lone > 0 && p <= 0 && q <= 0) || (lone == 0 && p < 0 && q < 0);
    const bool below = (lone < 0 && p >= 0 && q >= 0) || (lone == 0 && p > 0 && q > 0);
    if (!above && !below) continue;
    t = {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
    return above;
  }
  return true;  // not reached: the signs are neither all zero nor strictly equal
}

}  // namespace

// After P. Guigue and O. Devillers, "Fast and robust triangle-triangle overlap test using orientation
// predicates", 2003: both triangles cut the line in which their planes meet in an interval, and the order of
// the ends of the intervals is the orientation of the edges they lie on.
bool trianglesIntersect(const Vec3& a0, const Vec3& a1, const Vec3& a2, const Vec3& b0, const Vec3& b1,
                        const Vec3& b2) {
  TrianglePoints a{&a0, &a1, &a2};
  TrianglePoints b{&b0, &b1, &b2};
  const Signs sidesA = sidesOf(b, a);
  if (strictlyOnOneSide(sidesA)) return false;
  const Signs sidesB = sidesOf(a, b);
  if (strictlyOnOneSide(sidesB)) return false;
  if (allZero(sidesA) || allZero(sidesB)) return detail::flatTrianglesIntersect(a, b);
  const bool aAbove = loneVertexFirst(a, sidesA);
  const bool bAbove = loneVertexFirst(b, sidesB);
  if (!aAbove) std::swap(b[1], b[2]);
  if (!bAbove) std::swap(a[1], a[2]);
  return orient3d(*a[0], *a[1], *b[0], *b[1]) <= 0 && orient3d(*a[0], *a[2], *b[2], *b[0]) <= 0;
}

bool trianglesIntersectSharedVertex(const Vec3& s, const Vec3& a1, const Vec3& a2, const Vec3& b1,
                                    const Vec3& b2) {
  const int sideA1 = orient3d(s, b1, b2, a1);
  const int sideA2 = orient3d(s, b1, b2, a2);
  if (sideA1 * sideA2 > 0) return false;
  const int sideB1 = orient3d(s, a1, a2, b1);
  const int sideB2 = orient3d(s, a1, a2, b2);
  if (sideB1 * sideB2 > 0) return false;
  if ((sideA1 == 0 && sideA2 == 0) || (sideB1 == 0 && sideB2 == 0)) {
    return detail::flatFansIntersect({&s, &a1, &a2}, {&s, &b1, &b2});
  }
  // With s as origin and A1 = det(b1,b2,a1) and so on, Cramer's rule reads A2·a1 - A1·a2 = B1·b2 - B2·b1: the
  // vector lies on the line where the planes meet; it, or its opposite, is in both sectors or not.
  return (sideA2 >= 0 && sideA1 <= 0 && sideB1 >= 0 && sideB2 <= 0) ||
         (sideA2 <= 0 && sideA1 >= 0 && sideB1 <= 0 && sideB2 >= 0);
}

bool trianglesIntersectSharedEdge(const Vec3& s, const Vec3& t, const Vec3& a, const Vec3& b) {
  return orient3d(s, t, a, b) == 0 && detail::flatHingeIntersects(s, t, a, b);
}

}  // namespace handlebody
