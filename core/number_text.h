#pragma once
// Numbers in sentences and tables, with a decimal point whatever the locale of the program that we are part
// of: what we say is read by programs as well, and is the same wherever it is said.

#include <array>
#include <charconv>
#include <string>

namespace handlebody {

inline std::string numberText(double value, std::chars_format format, int precision) {
  std::array<char, 400> text;  // the largest number has 309 digits before its point
  const std::to_chars_result end =
      std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
  return {text.data(), end.ptr};
}

//! With so many decimals, at most 80.
inline std::string fixedText(double value, int decimals) {
  return numberText(value, std::chars_format::fixed, decimals);
}

//! With up to so many digits.
inline std::string numberText(double value, int digits = 6) {
  return numberText(value, std::chars_format::general, digits);
}

//! "1 edge", "2 edges".
inline std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

}  // namespace handlebody
