// The cyst: a smooth irregular body without the needle that runs through it. x is lateral, y elevational
// (front to back), z the depth of an ultrasound probe at -z.

#include <algorithm>
#include <array>
#include <cmath>

#include "sample_volumes/curves.h"
#include "sample_volumes/distances.h"
#include "sample_volumes/shapes.h"

namespace handlebody::phantoms {
namespace {

const Vec3 kHalfAxes(64, 35, 49);  // mm
const Vec3 kNeedlePoint(14, 0, 4);
const Vec3 kNeedleAxis = Vec3(0.16, 1, 0.24).normalized();
constexpr double kNeedleRadius = 3.5;

struct Wave {
  double amplitude;
  Vec3 number;  // per mm
  double phase;
};
// Long waves only: the radius of curvature of the body stays above 8 mm.
const std::array<Wave, 3> kWaves{{{0.15, {0.070, 0.020, 0.045}, 0.4},
                                  {0.11, {-0.030, 0.060, 0.085}, 1.3},
                                  {0.07, {0.095, 0.070, -0.060}, 2.2}}};

// Negative inside the body: an ellipsoid with waves on it.
double bodyFunction(const Vec3& p, Vec3* gradient) {
  double value = p.cwiseQuotient(kHalfAxes).squaredNorm() - 1;
  *gradient = 2 * p.cwiseQuotient(kHalfAxes.cwiseAbs2());
  for (const Wave& wave : kWaves) {
    const double angle = wave.number.dot(p) + wave.phase;
    value += wave.amplitude * std::sin(angle);
    *gradient += wave.amplitude * std::cos(angle) * wave.number;
  }
  return value;
}

}  // namespace

double cystBodyDistance(const Vec3& p) {
  constexpr double kBand = 6;  // mm
  return implicitDistance(bodyFunction, p, kBand);
}

double cystNeedleDistance(const Vec3& p) {
  return cylinderDistance(p - kNeedlePoint, kNeedleAxis, kNeedleRadius);
}

double cystDistance(const Vec3& p) { return std::max(cystBodyDistance(p), -cystNeedleDistance(p)); }

double cystBrightness(const Vec3& p) {
  // 1 at the needle's surface, so that the half-way level lies there; brighter towards its core.
  const double t = std::clamp((-cystNeedleDistance(p) - 0.5) / 1.5, 0.0, 1.0);
  return 1 + 0.5 * t * t * (3 - 2 * t);
}

}  // namespace handlebody::phantoms
