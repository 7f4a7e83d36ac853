#pragma once
// Long work that somebody may no longer want.

#include <atomic>

namespace handlebody {

//! Thrown where the work notices; says nothing about what went wrong, since nothing did.
struct Cancelled {};

namespace detail {
inline thread_local const std::atomic<bool>* wish = nullptr;
}

//! While it lives, work on this thread gives up soon after `cancelled` has become true, by throwing
//! Cancelled.
class CancelScope {
 public:
  explicit CancelScope(const std::atomic<bool>& cancelled) : outer_(detail::wish) {
    detail::wish = &cancelled;
  }
  ~CancelScope() { detail::wish = outer_; }
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

 private:
  const std::atomic<bool>* outer_;
};

//! To be called every few milliseconds in work that takes long.
inline void giveUpIfCancelled() {
  if (detail::wish != nullptr && detail::wish->load(std::memory_order_relaxed)) throw Cancelled{};
}

}  // namespace handlebody
