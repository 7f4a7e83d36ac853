#include "core/io/dicom/cie_lab.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/geometry/vec.h"

namespace handlebody::dicom {

namespace {

constexpr double kLargest = 65535;
constexpr double kEdge = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;  // where the cube root becomes a line

//! sRGB to XYZ adapted to D50 (Bradford), each row over the white point's coordinate.
const Eigen::Matrix3d& toRelativeXyz() {
  static const Eigen::Matrix3d matrix =
      (Eigen::Matrix3d() << 0.4360747 / 0.9642, 0.3850649 / 0.9642, 0.1430804 / 0.9642, 0.2225045, 0.7168786,
       0.0606169, 0.0139322 / 0.8249, 0.0971045 / 0.8249, 0.7141733 / 0.8249)
          .finished();
  return matrix;
}

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double gammaOf(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

double lightness(double t) { return t > kEdge ? std::cbrt(t) : (kSlope * t + 16) / 116; }
double fromLightness(double f) { return f * f * f > kEdge ? f * f * f : (116 * f - 16) / kSlope; }

}  // namespace

CieLab cieLab(const Colour& colour) {
  const Vec3 rgb(linear(colour[0] / 255.0), linear(colour[1] / 255.0), linear(colour[2] / 255.0));
  const Vec3 f = (toRelativeXyz() * rgb).unaryExpr(&lightness);
  const auto scaled = [](double part) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * kLargest));
  };
  return {scaled((116 * f[1] - 16) / 100), scaled((500 * (f[0] - f[1]) + 128) / 255),
          scaled((200 * (f[1] - f[2]) + 128) / 255)};
}

Colour colourOf(const CieLab& lab) {
  const double y = (lab[0] / kLargest * 100 + 16) / 116;
  const Vec3 f(y + (lab[1] / kLargest * 255 - 128) / 500, y, y - (lab[2] / kLargest * 255 - 128) / 200);
  const Vec3 rgb = toRelativeXyz().inverse() * Vec3(f.unaryExpr(&fromLightness));
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(gammaOf(rgb[static_cast<int>(i)]), 0.0, 1.0)));
  return colour;
}

}  // namespace handlebody::dicom
