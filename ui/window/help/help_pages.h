#pragma once
// Pages of the help that are made from what the program knows.

#include <QString>

namespace handlebody::ui {

//! Every command with its keys, from the table of commands, and what the mouse does in the views. HTML.
QString shortcutsPage();
//! Version, purpose, licences of the libraries. HTML.
QString aboutPage();

}  // namespace handlebody::ui
