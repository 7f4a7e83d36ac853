#pragma once
// Numbers in sentences and tables.

#include <cstdarg>
#include <cstdio>
#include <string>

#include "core/decimal_point.h"

namespace handlebody {

//! As snprintf does it, with a decimal point whatever the locale: what we say is read by programs as well,
//! and is the same wherever it is said.
[[gnu::format(printf, 1, 2)]] inline std::string printed(const char* format, ...) {
  const DecimalPoint point;
  std::string text;
  std::va_list arguments;
  va_start(arguments, format);
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  if (length > 0) {
    text.resize(static_cast<std::size_t>(length));
    std::vsnprintf(text.data(), text.size() + 1, format, arguments);
  }
  va_end(arguments);
  return text;
}

//! With up to six digits.
inline std::string numberText(double value) { return printed("%.6g", value); }

}  // namespace handlebody
