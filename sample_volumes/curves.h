#pragma once
// Distances that have no closed form: to a closed space curve, and to the zero of a smooth function.

#include <array>
#include <cstddef>

#include "core/geometry/vec.h"

namespace handlebody::phantoms {

//! A closed curve of period 2π with its derivatives by the angle.
struct ClosedCurve {
  Vec3 (*point)(double t) = nullptr;   //!< mm
  Vec3 (*first)(double t) = nullptr;   //!< mm per radian
  Vec3 (*second)(double t) = nullptr;  //!< mm per square radian
};

//! Distance of points to a closed curve, to 1e-9 mm: the best of 128 samples, then Newton's method between
//! its neighbours. The samples must lie so close that the distance has one minimum between three of them.
class CurveDistance {
 public:
  explicit CurveDistance(const ClosedCurve& curve);
  double operator()(const Vec3& p) const;

 private:
  static constexpr std::size_t kSamples = 128;
  double footDistance(const Vec3& p, std::size_t sample) const;

  ClosedCurve curve_;
  std::array<Vec3, kSamples> points_;
  double spacing_ = 0;  // the longest way from a sample to the next, mm
};

//! A smooth function and its gradient (per mm) at p.
using SmoothFunction = double (*)(const Vec3& p, Vec3* gradient);

//! Signed distance (mm) of p to the zero of a function that is negative inside. The foot of p is found by
//! repeated projection onto the tangent plane; the error shrinks by distance times curvature per turn.
//! Farther than `band` mm away only the first-order estimate is given, whose sign is right.
double implicitDistance(SmoothFunction function, const Vec3& p, double band);

}  // namespace handlebody::phantoms
