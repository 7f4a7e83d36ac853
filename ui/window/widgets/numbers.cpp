#include "ui/window/widgets/numbers.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/view/length_decimals.h"

namespace handlebody::ui {

namespace {

constexpr int kMaxDecimals = 7;

QString written(double value, int digits, int mostDecimals) {
  if (std::isinf(value)) return value < 0 ? QStringLiteral("−∞") : QStringLiteral("∞");
  const int magnitude = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return QLocale().toString(value, 'f', std::clamp(digits - 1 - magnitude, 0, mostDecimals));
}

}  // namespace

QString number(double value, int digits) { return written(value, digits, digits); }

QString fineNumber(double value, int digits) {
  const bool isSeen = std::abs(value) >= std::pow(10, -kMaxDecimals);
  return written(value, digits, isSeen ? std::max(digits, kMaxDecimals) : digits);
}

QString millilitres(double cubicMillimetres, int digits) {
  constexpr double kSmall = 10;  // mm³
  if (cubicMillimetres != 0 && std::abs(cubicMillimetres) < kSmall)
    return fineNumber(cubicMillimetres, digits) + QStringLiteral(" mm³");
  return number(cubicMillimetres / 1000, digits) + QStringLiteral(" ml");
}

QString squareCentimetres(double squareMillimetres) {
  return fineNumber(squareMillimetres / 100) + QStringLiteral(" cm²");
}

QString millimetres(double value) { return fineNumber(value, 3) + QStringLiteral(" mm"); }

QString place(const Vec3& world, const Grid& grid) {
  const QLocale locale;
  const int decimals = placeDecimals(grid);
  QStringList parts;
  for (int axis = 0; axis < 3; ++axis) parts << locale.toString(world[axis], 'f', decimals);
  const bool hasCommas = locale.decimalPoint() == QLatin1String(",");
  return parts.join(hasCommas ? QStringLiteral("; ") : QStringLiteral(", ")) + QStringLiteral(" mm");
}

QString times(const Vec3& numbers, int decimals) {
  QStringList parts;
  for (int axis = 0; axis < 3; ++axis) parts << QLocale().toString(numbers[axis], 'f', decimals);
  return parts.join(QStringLiteral(" × "));
}

QString bytes(double count) { return QLocale().formattedDataSize(static_cast<qint64>(count), 1); }

}  // namespace handlebody::ui
