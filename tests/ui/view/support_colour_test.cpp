// The colours of the support by the image, as people with each kind of colour vision see them.

#include <QColor>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include "core/geometry/vec.h"
#include "tests/support/catch.h"
#include "ui/view/surface_scene.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

using Matrix = Eigen::Matrix3d;

//! Machado, Oliveira, Fernandes (2009), severity 1; of linear RGB.
Matrix vision(const char* kind) {
  Matrix m = Matrix::Identity();
  if (*kind == 'p')
    m << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  if (*kind == 'd')
    m << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  if (*kind == 't')
    m << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return m;
}

Vec3 linear(const QColor& c) {
  const auto channel = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return {channel(c.redF()), channel(c.greenF()), channel(c.blueF())};
}

//! CIE L*a*b* of linear sRGB, D65.
Vec3 lab(const Vec3& rgb) {
  Matrix toXyz;
  toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vec3 xyz = (toXyz * rgb.cwiseMax(0).cwiseMin(1)).cwiseQuotient(Vec3(0.9505, 1, 1.089));
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(xyz.y()) - 16, 500 * (f(xyz.x()) - f(xyz.y())), 200 * (f(xyz.y()) - f(xyz.z()))};
}

}  // namespace

TEST_CASE("What has no edge in the image is told apart by everyone, in light and in shadow", "[support]") {
  constexpr double kJustSeen = 2.3;  // CIE76
  const Vec3 none = linear(faceSupportColour(FaceSupport::none));
  for (const char* kind : {"normal", "protan", "deutan", "tritan"})
    for (FaceSupport other : {FaceSupport::edge, FaceSupport::border})
      for (double light : {0.25, 0.5, 1.0})
        for (double otherLight : {0.25, 0.5, 1.0}) {
          CAPTURE(kind, int(other), light, otherLight);
          const Vec3 a = lab(vision(kind) * (light * none));
          const Vec3 b = lab(vision(kind) * (otherLight * linear(faceSupportColour(other))));
          CHECK((a - b).norm() > 8 * kJustSeen);
        }
}
