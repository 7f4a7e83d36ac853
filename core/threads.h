#pragma once
// Independent pieces of work on several threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/cancellation.h"

namespace handlebody {

//! As many threads as are asked for; 0: as many as the machine lets this process have.
inline int threadCount(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

//! Calls f(i) once for each i below `n`, on up to `threads` threads, this one among them. What one of them
//! throws is thrown here once all have ended; those not begun by then are left out. All have the
//! stop token of this one (CancelScope).
template <typename F>
void forEachOnThreads(std::size_t n, int threads, F&& f) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < n; i = next++) f(i);
    } catch (...) {
      next = n;
      const std::lock_guard lock(guard);
      if (!thrown) thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t most = std::min(n, static_cast<std::size_t>(std::max(1, threads)));
    for (std::size_t t = 1; t < most; ++t)
      others.emplace_back([&work, cancelled = CancelScope::current()] {
        const CancelScope scope(cancelled);
        work();
      });
    work();
  }
  if (thrown) std::rethrow_exception(thrown);
}

//! Calls f(from, to) for ranges that cover 0 to n, one for each of up to `threads` threads, none of them of
//! fewer than `least` unless it is the only one.
template <typename F>
void forRangesOnThreads(std::size_t n, int threads, std::size_t least, F&& f) {
  const std::size_t parts = std::clamp<std::size_t>(n / std::max<std::size_t>(1, least), 1,
                                                    static_cast<std::size_t>(std::max(1, threads)));
  forEachOnThreads(parts, static_cast<int>(parts),
                   [&](std::size_t t) { f(t * n / parts, (t + 1) * n / parts); });
}

}  // namespace handlebody
