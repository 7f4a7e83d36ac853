#include "ui/window/correct/brush_controls.h"

#include <QSignalBlocker>

#include "ui/model/translate.h"
#include "ui/view/brush.h"
#include "ui/view/length_decimals.h"
#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

QDoubleSpinBox* brushRadius(Brush& brush, QWidget* parent) {
  auto* field = new DecimalField(parent);
  field->setSuffix(tr(" mm"));
  field->setKeyboardTracking(false);
  describe(field, tr("Radius of the brush"),
           tr("The brush is a ball, the same for walls and for the surface; Ctrl+wheel changes it while it "
              "is on"));
  ignoreWheelWithoutFocus(field);
  const auto follow = [field, &brush] {
    const QSignalBlocker quiet(field);
    field->setDecimals(lengthDecimals(2 * brush.lowest()));
    field->setRange(brush.lowest(), brush.highest());
    field->setSingleStep(brush.lowest());
    field->setValue(brush.radius());
  };
  QObject::connect(field, &QDoubleSpinBox::valueChanged, &brush,
                   [&brush](double mm) { brush.setRadius(mm); });
  QObject::connect(&brush, &Brush::changed, field, follow);
  follow();
  return field;
}

}  // namespace handlebody::ui
