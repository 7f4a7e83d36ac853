#pragma once
// Endings of files, and words in headers, count in any case.

#include <algorithm>
#include <cctype>
#include <string>

namespace handlebody {

//! ASCII letters in lower case.
inline std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace handlebody
