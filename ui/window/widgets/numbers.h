#pragma once
// Numbers as the window shows them: always with their unit, in the user's locale, engine units in.

#include <QString>

#include "core/geometry/vec.h"

namespace handlebody::ui {

//! `value` with as many decimals as make `digits` significant digits, at most `digits` of them.
QString number(double value, int digits = 4);
//! mm³ in, "12.34 ml" out.
QString millilitres(double cubicMillimetres, int digits = 4);
//! mm² in, "45.6 cm²" out.
QString squareCentimetres(double squareMillimetres);
QString millimetres(double value);
//! "77.0, 49.0, 85.0 mm"
QString place(const Vec3& world);
//! "512 × 512 × 300"
QString times(const Vec3& numbers, int decimals);
QString bytes(double count);

}  // namespace handlebody::ui
