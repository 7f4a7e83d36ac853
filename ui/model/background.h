#pragma once
// A thread that does jobs one after the other.

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace handlebody::ui {

class Background {
 public:
  Background();
  //! Waits for the job that runs; those that have not begun are dropped.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  //! `job` must not throw.
  void post(std::function<void()> job);
  //! Drops what has not begun and posts `job`: the newest wins.
  void postInstead(std::function<void()> job);
  //! Returns when every job that was posted is done.
  void finish();

 private:
  void loop(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<std::function<void()>> jobs_;
  bool busy_ = false;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace handlebody::ui
