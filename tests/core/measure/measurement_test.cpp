// Rulers and angles whose values are known.

#include "core/measure/measurement.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("A ruler is as long as the way between its ends", "[measure]") {
  CHECK(valueOf({MeasurementKind::ruler, {Vec3(1, 2, 3), Vec3(4, 6, 15)}}) == 13);
  CHECK(valueOf({MeasurementKind::ruler, {Vec3(1, 2, 3), Vec3(1, 2, 3)}}) == 0);
}

TEST_CASE("An angle is that between its legs, whatever their lengths, and however it lies", "[measure]") {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-0.4, Vec3::UnitX()))
          .toRotationMatrix();
  const Vec3 vertex(-12, 7, 30);
  for (const double degrees : {1e-6, 0.5, 30.0, 90.0, 120.0, 179.999999}) {
    const double a = degrees * std::numbers::pi / 180;
    const Vec3 one = turn * Vec3(5, 0, 0), other = turn * (40 * Vec3(std::cos(a), std::sin(a), 0));
    const Measurement m{MeasurementKind::angle, {vertex + one, vertex, vertex + other}};
    CHECK(std::abs(valueOf(m) - degrees) < 1e-10);
  }
  CHECK(valueOf({MeasurementKind::angle, {vertex, vertex, Vec3::Zero()}}) == 0);
}
