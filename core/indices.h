#pragma once
// Indices are int where they are kept: half the memory, and -1 for none.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace handlebody {

//! For products and sums that may not fit into an int, and for comparisons with a size. A container takes an
//! int as it is.
constexpr std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! In order, each once.
template <class T>
void sortUnique(std::vector<T>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace handlebody
