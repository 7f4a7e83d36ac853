#pragma once
// Enumerators as indices.

#include <cstddef>
#include <type_traits>

namespace handlebody {

//! Of an array with one entry for each enumerator, in their order.
template <class Enum>
constexpr std::size_t indexOf(Enum enumerator) {
  static_assert(std::is_enum_v<Enum>);
  return static_cast<std::size_t>(enumerator);
}

}  // namespace handlebody
