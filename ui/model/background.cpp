#include "ui/model/background.h"

namespace handlebody::ui {

Background::Background() : thread_([this](const std::stop_token& stop) { loop(stop); }) {}
Background::~Background() = default;

void Background::post(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void Background::postInstead(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.clear();
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void Background::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty() && !busy_; });
}

void Background::loop(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); }) && !stop.stop_requested()) {
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    busy_ = true;
    lock.unlock();
    job();
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

}  // namespace handlebody::ui
