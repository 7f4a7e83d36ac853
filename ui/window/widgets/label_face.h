#pragma once
// What a screen reader says of a label.

namespace handlebody::ui {

//! A label with an accessible name and a text is read as both, "Genus: 1"; Qt alone would read the name
//! without the value. For all labels of the program; to be called again does nothing more.
void readLabelsWithTheirValues();

}  // namespace handlebody::ui
