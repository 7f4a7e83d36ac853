#include "app/cli/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
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
  constexpr std::size_t kMaxReserve = 1 << 30, kBlock = 16 << 20, kHugePage = 2 << 20;  // bytes
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  mallopt(M_TOP_PAD, static_cast<int>(std::min<rlim_t>(kMaxReserve, limit.rlim_cur / 4)));
  // More than the heap has yet: it grows by that and the padding.
  if (auto* const block = static_cast<char*>(std::malloc(kBlock))) {
    char* const from = block + (kHugePage - reinterpret_cast<std::uintptr_t>(block) % kHugePage);
    const auto* const end = static_cast<const char*>(sbrk(0));
    if (std::less<const char*>()(from, end))
      madvise(from, static_cast<std::size_t>(end - from), MADV_HUGEPAGE);
    std::free(block);
  }
  mallopt(M_TOP_PAD, kTopPad);
}

}  // namespace handlebody::cli
