#include "core/measure/measurement.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace handlebody {

std::size_t pointsOf(MeasurementKind kind) { return kind == MeasurementKind::ruler ? 2 : 3; }

double valueOf(const Measurement& m) {
  if (m.kind == MeasurementKind::ruler) return (m.points.at(1) - m.points.at(0)).norm();
  const Vec3 a = m.points.at(0) - m.points.at(1), b = m.points.at(2) - m.points.at(1);
  // Not the arc cosine, which loses half of the digits where the legs are in line.
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace handlebody
