#pragma once
// The controls of the brush that several sections have.

class QAction;
class QDoubleSpinBox;
class QString;
class QWidget;

namespace handlebody::ui {

class Brush;
class ToggleButton;

//! Pressed and enabled as the action is. `text`: in place of the action's, which stays its name.
ToggleButton* brushToggle(QAction* action, const QString& text, QWidget* parent);
//! Its radius, mm.
QDoubleSpinBox* brushRadius(Brush& brush, QWidget* parent);

}  // namespace handlebody::ui
