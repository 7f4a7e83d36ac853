#include <Eigen/Geometry>
#include <random>

#include "core/geometry/predicates.h"
#include "tests/collision_oracle/oracle.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

//! Points near a plane or line in general position: determinants that rounding cannot decide.
std::vector<Vec3> nearlyFlatPoints(std::mt19937& random, double scale) {
  const auto unit = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1; };
  const Vec3 o(unit(), unit(), unit()), u(unit(), unit(), unit()), v(unit(), unit(), unit());
  std::vector<Vec3> points;
  for (int i = 0; i < 4; ++i)
    points.push_back(scale * (o + unit() * u + (random() % 4 == 0 ? 0 : unit()) * v));
  return points;
}

int signByRounding(const std::vector<Vec3>& p) {
  const double det = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
  return (det > 0) - (det < 0);
}

}  // namespace

TEST_CASE("orientation signs agree with an exact kernel on nearly flat points of any scale") {
  std::mt19937 random(1);
  int misjudged = 0;
  for (const double scale : {1e-58, 1e-20, 1e-3, 1.0, 1e3, 1e20, 1e58}) {
    for (int i = 0; i < 1000; ++i) {
      const auto p = nearlyFlatPoints(random, scale);
      const int sign = oracle::orient3d(p[0], p[1], p[2], p[3]);
      misjudged += signByRounding(p) != sign;
      REQUIRE(orient3d(p[0], p[1], p[2], p[3]) == sign);
      REQUIRE(detail::orient3dExact(p[0], p[1], p[2], p[3]) == sign);
      for (int axis = 0; axis < 3; ++axis) {
        REQUIRE(orient2d(p[0], p[1], p[2], axis) == oracle::orient2d(p[0], p[1], p[2], axis));
        REQUIRE(detail::orient2dExact(p[0], p[1], p[2], axis) == oracle::orient2d(p[0], p[1], p[2], axis));
      }
    }
  }
  CHECK(misjudged > 100);  // so the filter is put to the test
}

TEST_CASE("orientation signs agree with an exact kernel when magnitudes are mixed") {
  std::mt19937 random(2);
  const auto coordinate = [&] {
    const double mantissa = 1 + static_cast<double>(random()) / 4294967296.0;
    const double sign = random() % 2 == 0 ? 1 : -1;
    return random() % 5 == 0 ? 0.0 : sign * std::ldexp(mantissa, static_cast<int>(random() % 390) - 195);
  };
  for (int i = 0; i < 3000; ++i) {
    Vec3 p[4];
    for (Vec3& q : p) q = Vec3(coordinate(), coordinate(), coordinate());
    if (i % 3 == 0) p[3] = p[random() % 3];
    REQUIRE(orient3d(p[0], p[1], p[2], p[3]) == oracle::orient3d(p[0], p[1], p[2], p[3]));
    REQUIRE(detail::orient3dExact(p[0], p[1], p[2], p[3]) == oracle::orient3d(p[0], p[1], p[2], p[3]));
  }
}
