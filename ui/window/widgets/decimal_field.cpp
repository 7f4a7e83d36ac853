#include "ui/window/widgets/decimal_field.h"

#include <algorithm>

namespace handlebody::ui {

namespace {

bool isDecimalPoint(QChar c) { return c == QLatin1Char('.') || c == QLatin1Char(','); }

bool isSign(QChar c) { return c == QLatin1Char('-') || c == QLatin1Char('+') || c == QChar(0x2212); }

}  // namespace

double DecimalField::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(withOwnPoint(text));
}

QValidator::State DecimalField::validate(QString& text, int& position) const {
  text = withOwnPoint(text);
  position = std::min(position, static_cast<int>(text.size()));
  return isNumber(text) ? QDoubleSpinBox::validate(text, position) : QValidator::Invalid;
}

//! The unit keeps its points, and is there once where it was pasted with the number.
QString DecimalField::withOwnPoint(const QString& text) const {
  QString number = text;
  for (const QString& unit : {suffix(), suffix().trimmed()})
    if (!unit.isEmpty() && number.endsWith(unit)) number.chop(unit.size());
  const bool hadUnit = number.size() < text.size();
  std::replace_if(number.begin(), number.end(), isDecimalPoint, locale().decimalPoint().front());
  return hadUnit ? number + suffix() : number;
}

//! Of what may be typed on the way to one, also nothing yet. Precondition: the point is the locale's.
bool DecimalField::isNumber(const QString& text) const {
  const QString number = text.chopped(text.endsWith(suffix()) ? suffix().size() : 0).trimmed();
  const auto points = number.count(locale().decimalPoint());
  return points <= (decimals() > 0 ? 1 : 0) && std::all_of(number.begin(), number.end(), [this](QChar c) {
           return c.isDigit() || isSign(c) || c == locale().decimalPoint().front();
         });
}

}  // namespace handlebody::ui
