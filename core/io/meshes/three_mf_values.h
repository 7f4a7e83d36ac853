#pragma once
// Internal: the values of attributes of 3MF. Numbers may have blanks around them and a plus, whatever the
// locale. Nothing for what is none.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

namespace handlebody::three_mf {

//! Takes the first word off.
std::string_view nextWord(std::string_view& text);

//! Finite; null is none. In single precision, as the consortium's own library has coordinates: the digits
//! that it and we write are as many as tell those numbers apart, and any other number that they round to
//! moves a certified surface.
std::optional<float> coordinate(const char* text);

//! From 0 on; null is none.
std::optional<int> index(const char* text);

//! Twelve finite numbers: the rows of a matrix that a row vector is multiplied with, the last one the shift,
//! of a unit in mm.
std::optional<Eigen::Affine3d> transform(std::string_view text, double unit);

//! In mm.
std::optional<double> unitCalled(const std::string& name);

}  // namespace handlebody::three_mf
