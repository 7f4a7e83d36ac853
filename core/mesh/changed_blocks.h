#pragma once
// Finding the few slots in which two large arrays differ.

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace handlebody {

//! Bit by bit.
template <typename T>
bool areSame(const T* a, const T* b, int count) {
  return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof(T)) == 0;
}

inline constexpr int kBlockOfSlots = 16;

//! Calls look(slot), ascending, for all slots of those blocks that are not the same: isSame(first, count).
//! Where nearly all are the same that costs a tenth of looking at each.
template <typename IsSame, typename Look>
void visitChangedBlocks(int slots, IsSame isSame, Look look) {
  for (int first = 0; first < slots; first += kBlockOfSlots) {
    const int count = std::min(kBlockOfSlots, slots - first);
    if (isSame(first, count)) continue;
    for (int slot = first; slot < first + count; ++slot) look(slot);
  }
}

}  // namespace handlebody
