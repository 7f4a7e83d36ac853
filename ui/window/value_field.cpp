#include "ui/window/value_field.h"

#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/view/view_state.h"
#include "ui/window/icons.h"
#include "ui/window/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr qint64 kSameGesture = 1000;  // ms

QDoubleSpinBox* makeNumber(const ValueSpec& spec, QWidget* parent) {
  auto* number = new QDoubleSpinBox(parent);
  number->setDecimals(spec.decimals);
  number->setRange(spec.low, spec.high);
  number->setSingleStep(spec.step);
  number->setKeyboardTracking(false);
  if (!spec.unit.isEmpty()) number->setSuffix(QLatin1Char(' ') + spec.unit);
  describe(number, spec.name, spec.tip);
  ignoreWheelWithoutFocus(number);
  return number;
}

QToolButton* makeReset(const ValueSpec& spec, QWidget* parent) {
  auto* reset = new QToolButton(parent);
  reset->setFocusPolicy(Qt::TabFocus);
  if (spec.fallback) {
    reset->setIcon(icon(QStringLiteral("reset")));
    describe(reset, ValueField::tr("Reset %1").arg(spec.name),
             ValueField::tr("Back to the usual value, %1").arg(QLocale().toString(*spec.fallback)));
  } else {
    reset->setText(ValueField::tr("Auto"));
    reset->setCheckable(true);
    styleAsToggle(reset);
    describe(reset, ValueField::tr("%1: automatic").arg(spec.name),
             ValueField::tr("The value is chosen from the image around the seeds"));
  }
  return reset;
}

}  // namespace

int gestureOf(const QObject* owner) {
  static int gesture = -1;
  static const QObject* last = nullptr;
  static QElapsedTimer since;
  if (owner != last || !since.isValid() || since.elapsed() > kSameGesture) gesture = ViewState::nextGesture();
  last = owner;
  since.start();
  return gesture;
}

ValueField::ValueField(const ValueSpec& spec, QWidget* parent)
    : QWidget(parent), spec_(spec), number_(makeNumber(spec, this)), reset_(makeReset(spec, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(number_, 1);
  layout->addWidget(reset_);
  setFocusProxy(number_);
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { edit(value); });
  connect(reset_, &QToolButton::clicked, this, [this] {
    const bool automatic = !spec_.fallback && reset_->isChecked();
    edit(automatic ? std::nullopt : std::optional(spec_.fallback.value_or(number_->value())));
  });
}

void ValueField::edit(std::optional<double> value) { Q_EMIT edited(value, gestureOf(this)); }

void ValueField::show(std::optional<double> value, std::optional<double> automatic) {
  const QSignalBlocker quiet(number_);
  if (value || automatic) number_->setValue(value ? *value : *automatic);
  if (spec_.fallback)
    reset_->setEnabled(value && *value != *spec_.fallback);
  else
    reset_->setChecked(!value);
}

}  // namespace handlebody::ui
