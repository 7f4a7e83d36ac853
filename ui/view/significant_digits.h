#pragma once
// Numbers of any unit over the views.

#include <QLocale>
#include <QString>

namespace handlebody::ui {

//! `value` to so many significant digits, without zeros behind the last of them. From 1e-7 to below 1e15 it
//! is written out, with all digits before the point; else as a power of ten.
QString significant(double value, int digits, const QLocale& locale = QLocale());

}  // namespace handlebody::ui
