#pragma once
// A measured run in a process of its own: its time and its memory are nobody else's.

#include <chrono>
#include <functional>
#include <type_traits>

namespace handlebody::bench {

//! Of this process, since it was made.
class Measure {
 public:
  Measure();
  //! Processor time, user and system, of all threads.
  double seconds() const;
  double wallSeconds() const;
  //! Peak of the resident set less the resident set at the beginning. Only in a child that has not held more
  //! before.
  double peakMegabytes() const;

 private:
  double startSeconds_, startMegabytes_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

//! Runs `work` in a child; what it writes to `result` (size bytes) comes back. Throws std::runtime_error if
//! the child fails.
void runInChild(void* result, std::size_t size, const std::function<void()>& work);

template <typename T>
void runInChild(T& result, const std::function<void(T&)>& work) {
  static_assert(std::is_trivially_copyable_v<T>);
  runInChild(&result, sizeof(T), [&] { work(result); });
}

}  // namespace handlebody::bench
