#pragma once
// Long work that somebody may no longer want.

#include <atomic>
#include <utility>

namespace handlebody {

//! Thrown where the work notices; says nothing about what went wrong, since nothing did.
struct Cancelled {};

//! While it lives, work on this thread gives up soon after `cancelled` has become true, by throwing
//! Cancelled.
class CancelScope {
 public:
  explicit CancelScope(const std::atomic<bool>& cancelled) : CancelScope(&cancelled) {}
  //! The same; null: this work is not cancelled. A thread that helps another takes that one's current().
  explicit CancelScope(const std::atomic<bool>* cancelled) : outer_(std::exchange(current_, cancelled)) {}
  ~CancelScope() { current_ = outer_; }
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;
  //! Of the innermost scope on this thread; null: there is none, or its work is not cancelled.
  static const std::atomic<bool>* current() { return current_; }

 private:
  // Not an argument: what several threads share is made when first asked for (SmoothedVolume), so that every
  // sample of a voxel would hand it on. Not a std::stop_token: a signal's handler, which stops, may not lock.
  static inline thread_local const std::atomic<bool>* current_ = nullptr;
  const std::atomic<bool>* outer_;
};

//! To be called every few milliseconds in work that takes long.
inline void giveUpIfCancelled() {
  const std::atomic<bool>* cancelled = CancelScope::current();
  if (cancelled != nullptr && cancelled->load(std::memory_order_relaxed)) throw Cancelled{};
}

}  // namespace handlebody
