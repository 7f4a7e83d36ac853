#include "ui/view/significant_digits.h"

#include <algorithm>
#include <cmath>

namespace handlebody::ui {

QString significant(double value, int digits, const QLocale& locale) {
  constexpr double kSmallest = 1e-7, kTooLarge = 1e15;  // up to there every whole number is exact
  constexpr int kMaxDecimals = 10;                      // of the smallest, four digits
  const double size = std::abs(value);
  const bool isWrittenOut = size == 0 || (size >= kSmallest && size < kTooLarge);
  if (!isWrittenOut) return locale.toString(value, 'g', digits);
  const int magnitude = size == 0 ? 0 : static_cast<int>(std::floor(std::log10(size)));
  const int decimals = std::clamp(digits - 1 - magnitude, 0, kMaxDecimals);
  const double rounded = QString::number(value, 'f', decimals).toDouble();
  return locale.toString(rounded, 'f', QLocale::FloatingPointShortest);
}

}  // namespace handlebody::ui
