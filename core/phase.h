#pragma once
// What long work is at, for somebody who waits for it.

#include <functional>
#include <utility>

namespace handlebody {

//! While it lives, `watch` is told what work on this thread is at: the name of a phase, which lives as long
//! as the program, or nothing (""). May be empty: nobody is told.
class PhaseScope {
 public:
  using Watch = std::function<void(const char*)>;
  explicit PhaseScope(Watch watch) : watch_(std::move(watch)), outer_(std::exchange(current_, this)) {}
  ~PhaseScope() { current_ = outer_; }
  PhaseScope(const PhaseScope&) = delete;
  PhaseScope& operator=(const PhaseScope&) = delete;

 private:
  friend class Phase;
  const char* change(const char* phase) {
    if (watch_) watch_(phase);
    return std::exchange(phase_, phase);
  }

  // Not an argument, as CancelScope is none: phases are found deep in what many share.
  static inline thread_local PhaseScope* current_ = nullptr;
  Watch watch_;
  PhaseScope* outer_;
  const char* phase_ = "";
};

//! A phase, from here to the end of the block; then that which it is a part of goes on. Must not outlive the
//! PhaseScope that it began in.
class Phase {
 public:
  explicit Phase(const char* name)
      : scope_(PhaseScope::current_), before_(scope_ ? scope_->change(name) : "") {}
  ~Phase() {
    if (scope_) scope_->change(before_);
  }
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

 private:
  PhaseScope* scope_;
  const char* before_;
};

}  // namespace handlebody
