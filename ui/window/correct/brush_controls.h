#pragma once
// The control of the brush that several sections have.

class QDoubleSpinBox;
class QWidget;

namespace handlebody::ui {

class Brush;

//! Its radius, mm.
QDoubleSpinBox* brushRadius(Brush& brush, QWidget* parent);

}  // namespace handlebody::ui
