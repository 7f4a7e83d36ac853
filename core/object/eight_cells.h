#pragma once
// Bytes of eight cells beside each other at once: most are as their neighbours are.

#include <cstdint>
#include <cstring>

namespace handlebody {

//! As one number, which is only good for comparing.
inline std::uint64_t eightCells(const std::uint8_t* first) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, first, sizeof eight);
  return eight;
}

}  // namespace handlebody
