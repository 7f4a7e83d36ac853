#include "ui/window/widgets/value_field.h"

#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/view/length_decimals.h"
#include "ui/view/view_state.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

namespace {

constexpr qint64 kSameGesture = 1000;  // ms
const QString kNoNumber = QStringLiteral("–");

NumberField* makeNumber(const ValueSpec& spec, QWidget* parent) {
  auto* number = new NumberField(parent);
  number->setDecimals(spec.decimals);
  number->setRange(spec.low, spec.high);
  number->setSingleStep(spec.step);
  number->setKeyboardTracking(false);
  describe(number, spec.name, spec.tip);
  ignoreWheelWithoutFocus(number);
  return number;
}

struct LastGesture {
  int gesture = -1;
  const QObject* owner = nullptr;
  QElapsedTimer since;
};

//! There is one user, on the GUI thread, at whatever control.
LastGesture& lastGesture() {
  static LastGesture last;
  return last;
}

QToolButton* makeReset(const ValueSpec& spec, QWidget* parent) {
  if (spec.fallback) {
    auto* reset = new QToolButton(parent);
    reset->setFocusPolicy(Qt::TabFocus);
    reset->setIcon(icon(QStringLiteral("reset")));
    describe(reset, ValueField::tr("Reset %1").arg(spec.name),
             ValueField::tr("Back to the usual value, %1").arg(QLocale().toString(*spec.fallback)));
    return reset;
  }
  auto* automatic = new ToggleButton(ValueField::tr("Auto"), parent);
  describe(automatic, ValueField::tr("%1: automatic").arg(spec.name),
           ValueField::tr("The value is chosen from the image around the seeds"));
  return automatic;
}

}  // namespace

int gestureOf(const QObject* owner) {
  LastGesture& last = lastGesture();
  if (owner != last.owner || !last.since.isValid() || last.since.elapsed() > kSameGesture)
    last.gesture = ViewState::nextGesture();
  last.owner = owner;
  last.since.start();
  return last.gesture;
}

void endGesture() { lastGesture().owner = nullptr; }

void NumberField::setKnown(bool known, const QString& unit) {
  known_ = known;
  setSuffix(known && !unit.isEmpty() ? QLatin1Char(' ') + unit : QString());  // writes the text anew
}

QString NumberField::textFromValue(double value) const {
  return known_ ? DecimalField::textFromValue(value) : kNoNumber;
}

double NumberField::valueFromText(const QString& text) const {
  return text == kNoNumber ? value() : DecimalField::valueFromText(text);
}

QValidator::State NumberField::validate(QString& text, int& position) const {
  return text == kNoNumber ? QValidator::Acceptable : DecimalField::validate(text, position);
}

ValueField::ValueField(const ValueSpec& spec, QWidget* parent)
    : QWidget(parent), spec_(spec), number_(makeNumber(spec, this)), reset_(makeReset(spec, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(number_, 1);
  layout->addWidget(reset_);
  setFocusProxy(number_);
  number_->setKnown(false, spec_.unit);
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { edit(value); });
  connect(reset_, &QToolButton::clicked, this, [this] {
    const bool automatic = !spec_.fallback && reset_->isChecked();
    edit(automatic ? std::nullopt : std::optional(spec_.fallback.value_or(number_->value())));
  });
}

void ValueField::edit(std::optional<double> value) { Q_EMIT edited(value, gestureOf(this)); }

void ValueField::setLengths(const Grid& grid, bool fromZero, double high) {
  const QSignalBlocker quiet(number_);
  const int decimals = lengthDecimals(grid);
  number_->setDecimals(decimals);
  number_->setRange(fromZero ? 0 : std::pow(10, -decimals), high);
  number_->setSingleStep(std::min(spec_.step, grid.meanSpacing()));
}

void ValueField::show(std::optional<double> value, std::optional<double> automatic) {
  const QSignalBlocker quiet(number_);
  const bool known = value || automatic;
  if (known) number_->setValue(value ? *value : *automatic);
  number_->setKnown(known, spec_.unit);
  if (spec_.fallback)
    reset_->setEnabled(value && *value != *spec_.fallback);
  else
    reset_->setChecked(!value);
}

}  // namespace handlebody::ui
