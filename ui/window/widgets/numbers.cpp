#include "ui/window/widgets/numbers.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handlebody::ui {

QString number(double value, int digits) {
  if (std::isinf(value)) return value < 0 ? QStringLiteral("−∞") : QStringLiteral("∞");
  const int magnitude = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return QLocale().toString(value, 'f', std::clamp(digits - 1 - magnitude, 0, digits));
}

QString millilitres(double cubicMillimetres, int digits) {
  return number(cubicMillimetres / 1000, digits) + QStringLiteral(" ml");
}

QString squareCentimetres(double squareMillimetres) {
  return number(squareMillimetres / 100) + QStringLiteral(" cm²");
}

QString millimetres(double value) { return number(value, 3) + QStringLiteral(" mm"); }

QString place(const Vec3& world) {
  const QLocale locale;
  return QStringLiteral("%1, %2, %3 mm")
      .arg(locale.toString(world.x(), 'f', 1), locale.toString(world.y(), 'f', 1),
           locale.toString(world.z(), 'f', 1));
}

QString times(const Vec3& numbers, int decimals) {
  QStringList parts;
  for (int axis = 0; axis < 3; ++axis) parts << QLocale().toString(numbers[axis], 'f', decimals);
  return parts.join(QStringLiteral(" × "));
}

QString bytes(double count) { return QLocale().formattedDataSize(static_cast<qint64>(count), 1); }

}  // namespace handlebody::ui
