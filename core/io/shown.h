#pragma once
// What a file says, in a sentence about it.

#include <string>

namespace handlebody {

//! The first 64 characters, of which each that is not printable ASCII is a question mark: what a damaged file
//! says may be anything.
inline std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 64;
  std::string plain = text.substr(0, kLongest);
  for (char& c : plain)
    if (c < ' ' || c > '~') c = '?';
  return plain;
}

}  // namespace handlebody
