#pragma once
// Texts that belong to no class.

#include <QCoreApplication>
#include <QString>

namespace handlebody::ui {

//! In the language of the window. lupdate files what stands in a function of this namespace under its name.
inline QString tr(const char* text, const char* comment = nullptr, int n = -1) {
  return QCoreApplication::translate("handlebody::ui", text, comment, n);
}

}  // namespace handlebody::ui
