#include "core/geometry/flat_intersection.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace handlebody::detail {
namespace {

int compare(double x, double y) { return (x > y) - (x < y); }

//! First axis whose projection keeps the triangle a proper triangle (and so is one-to-one on its plane), or
//! -1 if the three points are collinear.
int faithfulAxis(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orient2d(a, b, c, axis) != 0) return axis;
  }
  return -1;
}

int faithfulAxis(const TrianglePoints& t) { return faithfulAxis(*t[0], *t[1], *t[2]); }

bool overlapAlong(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int axis) {
  return std::max(p[axis], q[axis]) >= std::min(r[axis], s[axis]) &&
         std::max(r[axis], s[axis]) >= std::min(p[axis], q[axis]);
}

//! Closed segments pq and rs in the projection along `axis`; points as segments too. If all four points are
//! collinear the boxes decide, because along a line every coordinate is monotone.
bool segmentsMeetInPlane(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int axis) {
  return overlapAlong(p, q, r, s, (axis + 1) % 3) && overlapAlong(p, q, r, s, (axis + 2) % 3) &&
         orient2d(p, q, r, axis) * orient2d(p, q, s, axis) <= 0 &&
         orient2d(r, s, p, axis) * orient2d(r, s, q, axis) <= 0;
}

bool inTriangleInPlane(const Vec3& p, const TrianglePoints& t, int axis) {
  const int o0 = orient2d(*t[0], *t[1], p, axis);
  const int o1 = orient2d(*t[1], *t[2], p, axis);
  const int o2 = orient2d(*t[2], *t[0], p, axis);
  return (o0 >= 0 && o1 >= 0 && o2 >= 0) || (o0 <= 0 && o1 <= 0 && o2 <= 0);
}

//! A segment in the plane of the proper triangle t; `axis` is faithful for t.
bool segmentMeetsTriangleInPlane(const Vec3& p, const Vec3& q, const TrianglePoints& t, int axis) {
  if (inTriangleInPlane(p, t, axis)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segmentsMeetInPlane(p, q, *t[i], *t[(i + 1) % 3], axis)) return true;
  }
  return false;
}

bool coplanarTrianglesIntersect(const TrianglePoints& a, const TrianglePoints& b, int axis) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segmentMeetsTriangleInPlane(*a[i], *a[(i + 1) % 3], b, axis)) return true;
  }
  return inTriangleInPlane(*b[0], a, axis);
}

struct Segment {
  const Vec3* p;
  const Vec3* q;
};

bool before(const Vec3* x, const Vec3* y) {
  return std::lexicographical_compare(x->data(), x->data() + 3, y->data(), y->data() + 3);
}

//! The point set of a degenerate triangle: along a line the lexicographic order is the order on the line.
Segment hull(const TrianglePoints& t) {
  const auto [low, high] = std::minmax_element(t.begin(), t.end(), before);
  return {*low, *high};
}

bool segmentMeetsTriangle(const Segment& s, const TrianglePoints& t, int axis) {
  const int op = orient3d(*t[0], *t[1], *t[2], *s.p);
  const int oq = orient3d(*t[0], *t[1], *t[2], *s.q);
  if (op * oq > 0) return false;
  if (op == 0 && oq == 0) return segmentMeetsTriangleInPlane(*s.p, *s.q, t, axis);
  // The line pq crosses the plane in one point: it is inside if pq passes all three edges on the same side.
  const int o0 = orient3d(*s.p, *s.q, *t[0], *t[1]);
  const int o1 = orient3d(*s.p, *s.q, *t[1], *t[2]);
  const int o2 = orient3d(*s.p, *s.q, *t[2], *t[0]);
  return (o0 >= 0 && o1 >= 0 && o2 >= 0) || (o0 <= 0 && o1 <= 0 && o2 <= 0);
}

bool segmentsMeet(const Segment& a, const Segment& b) {
  if (orient3d(*a.p, *a.q, *b.p, *b.q) != 0) return false;
  int axis = faithfulAxis(*a.p, *a.q, *b.p);
  if (axis < 0) axis = faithfulAxis(*a.p, *a.q, *b.q);
  if (axis < 0) axis = faithfulAxis(*b.p, *b.q, *a.p);
  if (axis < 0) axis = faithfulAxis(*b.p, *b.q, *a.q);
  if (axis >= 0) return segmentsMeetInPlane(*a.p, *a.q, *b.p, *b.q, axis);
  return overlapAlong(*a.p, *a.q, *b.p, *b.q, 0) && overlapAlong(*a.p, *a.q, *b.p, *b.q, 1) &&
         overlapAlong(*a.p, *a.q, *b.p, *b.q, 2);
}

//! True if the ray from t[0] to p ≠ t[0] starts into the proper triangle t.
bool rayEntersTriangle(const Vec3& p, const TrianglePoints& t, int axis) {
  if (orient3d(*t[0], *t[1], *t[2], p) != 0) return false;
  const int side = orient2d(*t[0], *t[1], *t[2], axis);
  return side * orient2d(*t[0], *t[1], p, axis) >= 0 && side * orient2d(*t[0], p, *t[2], axis) >= 0;
}

//! True if p ≠ s and q ≠ s lie in the same direction from s.
bool sameDirection(const Vec3& s, const Vec3& p, const Vec3& q) {
  if (!collinear(s, p, q)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] != s[axis]) return compare(p[axis], s[axis]) == compare(q[axis], s[axis]);
  }
  return false;
}

//! The degenerate triangle a is the union of the segments a0a1 and a0a2; b shares its first point.
bool degenerateFanIntersects(const TrianglePoints& a, const TrianglePoints& b, int axisB) {
  const Vec3& s = *a[0];
  for (std::size_t i = 1; i < 3; ++i) {
    if (*a[i] == s) continue;
    if (axisB >= 0) {
      if (rayEntersTriangle(*a[i], b, axisB)) return true;
      continue;
    }
    for (std::size_t j = 1; j < 3; ++j) {
      if (*b[j] != s && sameDirection(s, *a[i], *b[j])) return true;
    }
  }
  return false;
}

}  // namespace

bool flatTrianglesIntersect(const TrianglePoints& a, const TrianglePoints& b) {
  const int axisA = faithfulAxis(a);
  const int axisB = faithfulAxis(b);
  if (axisA >= 0 && axisB >= 0) return coplanarTrianglesIntersect(a, b, axisA);
  if (axisA >= 0) return segmentMeetsTriangle(hull(b), a, axisA);
  if (axisB >= 0) return segmentMeetsTriangle(hull(a), b, axisB);
  return segmentsMeet(hull(a), hull(b));
}

bool flatFansIntersect(const TrianglePoints& a, const TrianglePoints& b) {
  const int axisA = faithfulAxis(a);
  const int axisB = faithfulAxis(b);
  if (axisA < 0) return degenerateFanIntersects(a, b, axisB);
  if (axisB < 0) return degenerateFanIntersects(b, a, axisA);
  // Two coplanar sectors of less than a half turn: they overlap if a side of one lies in the other.
  return rayEntersTriangle(*a[1], b, axisB) || rayEntersTriangle(*a[2], b, axisB) ||
         rayEntersTriangle(*b[1], a, axisA) || rayEntersTriangle(*b[2], a, axisA);
}

bool flatHingeIntersects(const Vec3& s, const Vec3& t, const Vec3& a, const Vec3& b) {
  if (s == t) return a != s && b != s && sameDirection(s, a, b);
  const int axisA = faithfulAxis(s, t, a);
  if (axisA >= 0) return orient2d(s, t, a, axisA) * orient2d(s, t, b, axisA) > 0;
  if (faithfulAxis(s, t, b) >= 0) return false;  // a lies on the line st, which b's triangle meets in st only
  // All on one line: both go beyond the same end, or they have nothing but st in common.
  return (a != t && b != t && !sameDirection(t, s, a) && !sameDirection(t, s, b)) ||
         (a != s && b != s && !sameDirection(s, t, a) && !sameDirection(s, t, b));
}

}  // namespace handlebody::detail
