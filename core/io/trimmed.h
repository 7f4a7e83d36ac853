#pragma once
// Words of headers, tables and options, as people and padding leave them.

#include <string_view>

namespace handlebody {

//! Without these characters at its ends. A part of `text`: it lives no longer than that.
inline std::string_view trimmed(std::string_view text, std::string_view of = " \t\r\n") {
  const auto first = text.find_first_not_of(of);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(of) - first + 1);
}

}  // namespace handlebody
