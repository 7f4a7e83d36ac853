#pragma once
// What is made on a thread of its own and of which only the newest counts.

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "ui/model/background.h"

namespace handlebody::ui {

//! Calls come from one thread.
template <typename T>
class NewestResult {
 public:
  //! `ready` is called on the worker's thread when what was asked for last is there.
  explicit NewestResult(std::function<void()> ready) : ready_(std::move(ready)) {}

  //! Returns at once; what was asked for before is not answered any more. `make` must not throw.
  void request(std::function<T()> make) {
    const int number = restart(nullptr);
    if (!background_) background_ = std::make_unique<Background>();
    background_->postInstead([this, make = std::move(make), number] {
      auto made = std::make_shared<const T>(make());
      {
        const std::lock_guard lock(mutex_);
        if (number != asked_) return;
        made_ = std::move(made);
      }
      ready_();
    });
  }
  //! In the place of what was asked for; without a word.
  void set(std::shared_ptr<const T> known) { restart(std::move(known)); }
  //! What was asked for last; null as long as it is being made.
  std::shared_ptr<const T> get() const {
    const std::lock_guard lock(mutex_);
    return made_;
  }
  //! The same, once.
  std::shared_ptr<const T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(made_, nullptr);
  }
  //! Waits until it is there.
  void finish() {
    if (background_) background_->finish();
  }

 private:
  int restart(std::shared_ptr<const T> known) {
    const std::lock_guard lock(mutex_);
    made_ = std::move(known);
    return ++asked_;
  }

  const std::function<void()> ready_;
  mutable std::mutex mutex_;
  int asked_ = 0;
  std::shared_ptr<const T> made_;
  std::unique_ptr<Background> background_;  // from the first request on; last: its job uses the others
};

}  // namespace handlebody::ui
