#pragma once
// Independent pieces of work on several threads.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>

#include "core/thread_pool.h"

namespace handlebody {

//! As many threads as are asked for; 0: as many as the machine lets this process have.
inline int threadCount(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

//! One of several equal parts of some work.
struct Share {
  std::size_t part = 0, parts = 1;
  //! Of n pieces: the first, and the one behind the last.
  std::pair<std::size_t, std::size_t> of(std::size_t n) const {
    return {part * n / parts, (part + 1) * n / parts};
  }
};

//! How many shares of n pieces there are for up to `threads` threads, none of them of fewer than `least`
//! pieces unless it is the only one. More than threads, so that none waits long for another.
inline std::size_t sharesOf(std::size_t n, int threads, std::size_t least) {
  constexpr int kSharesPerThread = 4;
  if (threads < 2) return 1;
  return std::clamp<std::size_t>(n / std::max<std::size_t>(1, least), 1,
                                 static_cast<std::size_t>(kSharesPerThread * threads));
}

//! Calls f(i) once for each i below `n`, on up to `threads` threads, this one among them. What one of them
//! throws is thrown here once all have ended; those not begun by then are left out. All have the
//! stop token of this one (CancelScope). The other threads are kept from call to call (thread_pool.h): where
//! they are busy with something else, this one does all of it and waits for none of them.
template <typename F>
void forEachOnThreads(std::size_t n, int threads, F&& f) {
  if (n < 2 || threads < 2) {
    for (std::size_t i = 0; i < n; ++i) f(i);
    return;
  }
  using Work = std::remove_reference_t<F>;
  runOnPool({n, threads, const_cast<void*>(static_cast<const void*>(std::addressof(f))),
             [](void* work, std::size_t i) { (*static_cast<Work*>(work))(i); }});
}

//! Calls f(share) for each of sharesOf(n, threads, least), at the same time as far as there are threads.
template <typename F>
void forSharesOnThreads(std::size_t n, int threads, std::size_t least, F&& f) {
  const std::size_t parts = sharesOf(n, threads, least);
  forEachOnThreads(parts, threads, [&](std::size_t part) { f(Share{part, parts}); });
}

//! Calls f(from, to) for ranges that cover 0 to n, one for each share.
template <typename F>
void forRangesOnThreads(std::size_t n, int threads, std::size_t least, F&& f) {
  forSharesOnThreads(n, threads, least, [&](const Share& share) {
    const auto [from, to] = share.of(n);
    f(from, to);
  });
}

}  // namespace handlebody
