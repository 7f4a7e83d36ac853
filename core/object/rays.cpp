#include "core/object/rays.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/shapes.h"

namespace handlebody {

namespace {
// Distance on the unit sphere at which a ray's weight is halved, so that a direction on a ray is no
// exception.
constexpr double kOnRay = 0.02;
constexpr int kSquares = Rays::kSquares;
// The widest angle (radians) from the middle of a square to its corner.
constexpr double kWidest = 0.09;

//! The middle of a square, as a direction.
Vec3 middleOf(std::size_t square) {
  const int n = static_cast<int>(square), axis = n / (2 * kSquares * kSquares);
  const auto at = [](int i) { return (2 * i + 1.0) / kSquares - 1; };
  Vec3 out;
  out[axis] = n / (kSquares * kSquares) % 2 == 0 ? 1 : -1;
  out[(axis + 1) % 3] = at(n / kSquares % kSquares);
  out[(axis + 2) % 3] = at(n % kSquares);
  return out.normalized();
}

//! The rays that may be among the nearest three of a direction within an angle of this one.
std::vector<std::uint16_t> raysNear(const std::vector<Vec3>& rays, const Vec3& middle) {
  std::vector<double> angles;
  for (const Vec3& r : rays) angles.push_back(std::acos(std::clamp(r.dot(middle), -1.0, 1.0)));
  std::vector<double> sorted = angles;
  std::nth_element(sorted.begin(), sorted.begin() + 2, sorted.end());
  std::vector<std::uint16_t> out;
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (angles[i] <= sorted[2] + 2 * kWidest) out.push_back(static_cast<std::uint16_t>(i));
  return out;
}

}  // namespace

std::vector<Vec3> directionsOverSphere(double spacing) { return icosphere(Vec3(0, 0, 0), 1, spacing).points; }

Rays::Rays(double spacing) {
  const TriangleSoup sphere = icosphere(Vec3(0, 0, 0), 1, spacing);
  directions = sphere.points;
  for (const Triangle& t : sphere.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
      if (a < b) pairs.push_back({a, b});
    }
  for (std::size_t square = 0; square < kSquareCount; ++square)
    near_.push_back(raysNear(directions, middleOf(square)));
}

//! The square in which a direction meets the cube around the sphere.
std::size_t Rays::squareOf(const Vec3& direction) {
  Eigen::Index axis = 0;
  const double most = direction.cwiseAbs().maxCoeff(&axis);
  const auto square = [&](Eigen::Index a) {
    const double at = 0.5 + 0.5 * direction[a] / most;
    return std::clamp(static_cast<int>(at * kSquares), 0, kSquares - 1);
  };
  const int side = 2 * static_cast<int>(axis) + (direction[axis] < 0 ? 1 : 0);
  return static_cast<std::size_t>((side * kSquares + square((axis + 1) % 3)) * kSquares +
                                  square((axis + 2) % 3));
}

NearestRays nearestRays(const Rays& rays, const Vec3& direction) {
  std::array<double, 3> best{-2, -2, -2};  // cosines
  NearestRays out;
  for (const std::uint16_t i : rays.near(Rays::squareOf(direction))) {
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
