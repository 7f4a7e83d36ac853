#pragma once
// Light and dark colours of the whole program.

namespace handlebody::ui {

enum class Appearance { system, light, dark };

//! Sets Fusion and its palette for the whole program. Precondition: there is a QApplication. `system` is
//! light or dark as the desktop's own palette was at start.
void applyAppearance(Appearance appearance);

}  // namespace handlebody::ui
