#include "core/object/rays.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/shapes.h"

namespace handlebody {

namespace {
// Distance on the unit sphere at which a ray's weight is halved, so that a direction on a ray is no
// exception.
constexpr double kOnRay = 0.02;
}  // namespace

Rays::Rays(double spacing) {
  const TriangleSoup sphere = icosphere(Vec3(0, 0, 0), 1, spacing);
  directions = sphere.points;
  for (const Triangle& t : sphere.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
      if (a < b) pairs.push_back({a, b});
    }
}

NearestRays nearestRays(const Rays& rays, const Vec3& direction) {
  std::array<double, 3> best{-2, -2, -2};  // cosines
  NearestRays out;
  for (std::size_t i = 0; i < rays.directions.size(); ++i) {
    const double d = rays.directions[i].dot(direction);
    if (d <= best[2]) continue;
    std::size_t k = 2;
    for (; k > 0 && d > best[k - 1]; --k) best[k] = best[k - 1], out.ray[k] = out.ray[k - 1];
    best[k] = d;
    out.ray[k] = i;
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += out.weight[k] = 1 / (std::sqrt(std::max(0.0, 2 - 2 * best[k])) + kOnRay);
  for (double& w : out.weight) w /= sum;
  return out;
}

}  // namespace handlebody
