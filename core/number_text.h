#pragma once
// Numbers in sentences of errors that are no findings.

#include <cstdio>
#include <string>

namespace handlebody {

//! With up to six digits.
inline std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace handlebody
