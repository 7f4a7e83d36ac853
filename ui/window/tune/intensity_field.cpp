#include "ui/window/tune/intensity_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handlebody::ui {

namespace {

constexpr int kFewestDecimals = 2;
constexpr double kOpen = 1e9;  // stands for an open end; no scanner writes such intensities

const QString kUnknown = QStringLiteral("–");

bool isInfinityText(const QString& text) {
  const QString bare = text.trimmed();
  return bare.endsWith(QStringLiteral("∞")) || bare.endsWith(QStringLiteral("inf"));
}

}  // namespace

IntensityField::IntensityField(QWidget* parent) : DecimalField(parent) {
  setRange(-kOpen, kOpen);
  setDecimals(kFewestDecimals);
  setKeyboardTracking(false);
}

double IntensityField::end() const {
  return std::abs(value()) < kOpen ? value()
                                   : std::copysign(std::numeric_limits<double>::infinity(), value());
}

void IntensityField::setEnd(double end) { setValue(std::clamp(end, -kOpen, kOpen)); }

// A thousandth of the width is told apart: less than a step.
void IntensityField::setScale(double width) {
  constexpr int kDecimals = 10;    // at most
  constexpr double kAcross = 200;  // steps
  const bool isKnown = width > 0 && std::isfinite(width);
  const double digits = isKnown ? 3 - std::floor(std::log10(width)) : 0;
  setDecimals(static_cast<int>(std::clamp<double>(digits, kFewestDecimals, kDecimals)));
  setSingleStep((isKnown ? width : 1) / kAcross);
}

void IntensityField::setKnown(bool known) {
  known_ = known;
  setValue(value());  // writes the text anew
}

QString IntensityField::textFromValue(double value) const {
  if (!known_) return kUnknown;
  if (std::abs(value) < kOpen) {
    const QString text = DecimalField::textFromValue(value);
    const bool whole = value == std::floor(value);
    return whole ? text.section(locale().decimalPoint(), 0, 0) : text;
  }
  return value < 0 ? QStringLiteral("−∞") : QStringLiteral("∞");
}

double IntensityField::valueFromText(const QString& text) const {
  if (text == kUnknown) return value();
  if (!isInfinityText(text)) return DecimalField::valueFromText(text);
  const QChar first = text.trimmed().front();
  return first == QLatin1Char('-') || first == QChar(0x2212) ? -kOpen : kOpen;
}

QValidator::State IntensityField::validate(QString& text, int& position) const {
  if (isInfinityText(text) || text == kUnknown) return QValidator::Acceptable;
  for (const QString& word : {QStringLiteral("inf"), QStringLiteral("-inf")})
    if (word.startsWith(text.trimmed())) return QValidator::Intermediate;
  return DecimalField::validate(text, position);
}

}  // namespace handlebody::ui
