#include "ui/window/tune/intensity_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handlebody::ui {

namespace {

constexpr double kOpen = 1e9;  // stands for an open end; no scanner writes such intensities

const QString kUnknown = QStringLiteral("–");

bool isInfinityText(const QString& text) {
  const QString bare = text.trimmed();
  return bare.endsWith(QStringLiteral("∞")) || bare.endsWith(QStringLiteral("inf"));
}

}  // namespace

IntensityField::IntensityField(QWidget* parent) : QDoubleSpinBox(parent) {
  setRange(-kOpen, kOpen);
  setDecimals(2);
  setKeyboardTracking(false);
}

double IntensityField::end() const {
  return std::abs(value()) < kOpen ? value()
                                   : std::copysign(std::numeric_limits<double>::infinity(), value());
}

void IntensityField::setEnd(double end) { setValue(std::clamp(end, -kOpen, kOpen)); }

void IntensityField::setKnown(bool known) {
  known_ = known;
  setValue(value());  // writes the text anew
}

QString IntensityField::textFromValue(double value) const {
  if (!known_) return kUnknown;
  if (std::abs(value) < kOpen) {
    QString text = QDoubleSpinBox::textFromValue(value);
    const bool whole = value == std::floor(value);
    return whole ? locale().toString(value, 'f', 0) : text;
  }
  return value < 0 ? QStringLiteral("−∞") : QStringLiteral("∞");
}

double IntensityField::valueFromText(const QString& text) const {
  if (text == kUnknown) return value();
  if (!isInfinityText(text)) return QDoubleSpinBox::valueFromText(text);
  const QChar first = text.trimmed().front();
  return first == QLatin1Char('-') || first == QChar(0x2212) ? -kOpen : kOpen;
}

QValidator::State IntensityField::validate(QString& text, int& position) const {
  if (isInfinityText(text) || text == kUnknown) return QValidator::Acceptable;
  for (const QString& word : {QStringLiteral("inf"), QStringLiteral("-inf")})
    if (word.startsWith(text.trimmed())) return QValidator::Intermediate;
  return QDoubleSpinBox::validate(text, position);
}

}  // namespace handlebody::ui
