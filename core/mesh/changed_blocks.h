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

inline constexpr int kLargestBlock = 512;
inline constexpr int kSmallestBlock = 8;

//! Calls look(slot), ascending, for some of the slots from first on, among them all that differ:
//! isSame(first, count) says of a block of at most kLargestBlock that none does.
template <typename IsSame, typename Look>
void visitChangedBlock(int first, int count, const IsSame& isSame, const Look& look) {
  if (isSame(first, count)) return;
  const int part = std::max(count / 4, kSmallestBlock), end = first + count;
  if (count <= kSmallestBlock)
    for (int slot = first; slot < end; ++slot) look(slot);
  else
    for (; first < end; first += part) visitChangedBlock(first, std::min(part, end - first), isSame, look);
}

//! The same of all slots from 0 on. Where nearly all are the same that costs a tenth of looking at each.
template <typename IsSame, typename Look>
void visitChangedBlocks(int slots, const IsSame& isSame, const Look& look) {
  for (int first = 0; first < slots; first += kLargestBlock)
    visitChangedBlock(first, std::min(kLargestBlock, slots - first), isSame, look);
}

}  // namespace handlebody
