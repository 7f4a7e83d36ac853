#pragma once
// Numbers as the window shows them: always with their unit, in the user's locale, engine units in.

#include <QString>

#include "core/volume/volume.h"

namespace handlebody::ui {

//! `value` with as many decimals as make `digits` significant digits, at most `digits` of them.
QString number(double value, int digits = 4);
//! `value` with `digits` significant digits also where that is small in its unit: with up to seven decimals.
//! What is smaller than all of them is written as by number().
QString fineNumber(double value, int digits = 4);
//! mm³ in, "12.34 ml" out, or "1.234 mm³" below a hundredth of a millilitre.
QString millilitres(double cubicMillimetres, int digits = 4);
//! mm² in, "45.6 cm²" out.
QString squareCentimetres(double squareMillimetres);
QString millimetres(double value);
//! "77.0, 49.0, 85.0 mm", with more decimals where the voxels are finer than 0.1 mm.
QString place(const Vec3& world, const Grid& grid);
//! "512 × 512 × 300"
QString times(const Vec3& numbers, int decimals);
QString bytes(double count);

}  // namespace handlebody::ui
