#pragma once
// Indices are int where they are kept (half the memory, and -1 for none); containers want std::size_t.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace handlebody {

constexpr std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! In order, each once.
template <class T>
void sortUnique(std::vector<T>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace handlebody
