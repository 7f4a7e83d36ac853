#include "app/cli/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace handlebody::cli {

namespace {
constexpr int kTopPad = 16 << 20;  // bytes by which the heap grows at least
}  // namespace

void keepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that there is
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, kTopPad);
}

void reserveHeap() {
  constexpr std::uintptr_t kMaxReserve = 1 << 30, kBlock = 16 << 20, kHugePage = 2 << 20;  // bytes
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  mallopt(M_TOP_PAD, static_cast<int>(std::min<rlim_t>(kMaxReserve, limit.rlim_cur / 4)));
  void* const block = std::malloc(kBlock);  // more than the heap has yet: it grows by that and the padding
  const std::uintptr_t from = (reinterpret_cast<std::uintptr_t>(block) / kHugePage + 1) * kHugePage;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  if (block && from < end) madvise(reinterpret_cast<void*>(from), end - from, MADV_HUGEPAGE);
  std::free(block);
  mallopt(M_TOP_PAD, kTopPad);
}

}  // namespace handlebody::cli
