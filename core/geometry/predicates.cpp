#include "core/geometry/predicates.h"

#include <cmath>

#include "core/geometry/expansion.h"

namespace handlebody {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
// Shewchuk 1997, section 4: bounds of the plain evaluation relative to the permanent (the same expression
// with absolute values), the rounding of bound and permanent themselves included.
constexpr double kOrient2dBound = (3 + 16 * kUnitRoundoff) * kUnitRoundoff;
constexpr double kOrient3dBound = (7 + 56 * kUnitRoundoff) * kUnitRoundoff;

int signOf(double x) { return (x > 0) - (x < 0); }

}  // namespace

namespace detail {

int orient2dExact(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  using Difference = Expansion<2>;
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Expansion<16> det;
  det.addProduct(Difference::difference(b[i], a[i]), Difference::difference(c[j], a[j]));
  det.addProduct(Difference::difference(b[j], a[j]), Difference::difference(c[i], a[i]), -1);
  return det.sign();
}

int orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  using Difference = Expansion<2>;
  Difference u[3];
  Difference v[3];
  Difference w[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = Difference::difference(b[i], a[i]);
    v[i] = Difference::difference(c[i], a[i]);
    w[i] = Difference::difference(d[i], a[i]);
  }
  Expansion<192> det;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    Expansion<16> minor;
    minor.addProduct(u[j], v[k]);
    minor.addProduct(u[k], v[j], -1);
    det.addProduct(minor, w[i]);
  }
  return det.sign();
}

}  // namespace detail

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  const double left = (b[i] - a[i]) * (c[j] - a[j]);
  const double right = (b[j] - a[j]) * (c[i] - a[i]);
  const double det = left - right;
  const double bound = kOrient2dBound * (std::abs(left) + std::abs(right));
  if (det > bound || det < -bound) return signOf(det);
  if (left == 0 && right == 0) return 0;  // each product has a factor 0, which is exact
  return detail::orient2dExact(a, b, c, axis);
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
  const double vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
  const double wx = d.x() - a.x(), wy = d.y() - a.y(), wz = d.z() - a.z();
  const double uyvz = uy * vz, uzvy = uz * vy;
  const double uzvx = uz * vx, uxvz = ux * vz;
  const double uxvy = ux * vy, uyvx = uy * vx;
  const double det = wx * (uyvz - uzvy) + wy * (uzvx - uxvz) + wz * (uxvy - uyvx);
  const double permanent = std::abs(wx) * (std::abs(uyvz) + std::abs(uzvy)) +
                           std::abs(wy) * (std::abs(uzvx) + std::abs(uxvz)) +
                           std::abs(wz) * (std::abs(uxvy) + std::abs(uyvx));
  const double bound = kOrient3dBound * permanent;
  if (det > bound || det < -bound) return signOf(det);
  if (permanent == 0) return 0;  // every term has a factor 0, which is exact
  return detail::orient3dExact(a, b, c, d);
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(a, b, c, 0) == 0 && orient2d(a, b, c, 1) == 0 && orient2d(a, b, c, 2) == 0;
}

}  // namespace handlebody
