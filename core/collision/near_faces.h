#pragma once
// Quick rejection of a vertex and a triangle that are far from each other.

#include <algorithm>

#include "core/geometry/vec.h"

namespace handlebody {

//! True only if the distance of p from the triangle (u,a,b) is greater than the root of `radiusSquared`;
//! false if that is not shown. Cheap: tries the direction from u to p and the normals of the edges ua and ub.
inline bool isFarFrom(const Vec3& p, const Vec3& u, const Vec3& a, const Vec3& b, double radiusSquared) {
  // Everything is divided by radiusSquared, so that products of eight lengths stay representable.
  const double scale = 1 / radiusSquared;
  const Vec3 w = p - u;
  const Vec3 ea = a - u;
  const Vec3 eb = b - u;
  const double ww = w.squaredNorm() * scale;
  const double wa = w.dot(ea) * scale;
  const double wb = w.dot(eb) * scale;
  // Along w the triangle ends at max(0, wa, wb)/|w|, and p is at |w|. The slack covers rounding.
  constexpr double kSlack = 0x1p-36;
  const double aa = ea.squaredNorm() * scale;
  const double bb = eb.squaredNorm() * scale;
  const double alongW = ww - std::max({0.0, wa, wb}) - kSlack * (ww + aa + bb);
  if (alongW > 0 && alongW * alongW > ww) return true;
  // The part of w that is orthogonal to ea, times aa, is the direction q = aa·w - wa·ea with q·w = |q|²/aa.
  const double ab = ea.dot(eb) * scale;
  const double slack = kSlack * (ww + aa + bb);
  const double qa = aa * ww - wa * wa;
  const double acrossA = qa - std::max(0.0, aa * wb - wa * ab) - slack * aa;
  if (acrossA > 0 && acrossA * acrossA > aa * (qa + slack * aa)) return true;
  const double qb = bb * ww - wb * wb;
  const double acrossB = qb - std::max(0.0, bb * wa - wb * ab) - slack * bb;
  return acrossB > 0 && acrossB * acrossB > bb * (qb + slack * bb);
}

}  // namespace handlebody
