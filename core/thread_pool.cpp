#include "core/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "core/cancellation.h"

namespace handlebody {

namespace {

//! What one caller wants done. Helpers may come when he has gone: they find no piece left, and ask nothing of
//! his work.
class Job {
 public:
  explicit Job(const PooledWork& work) : work_(work), cancelled_(CancelScope::current()) {}

  //! Takes piece by piece until none is left.
  void help() {
    const CancelScope scope(cancelled_);
    // First it is counted as at work, then it takes a piece: so who has seen that no piece is left, and then
    // nobody at work, is the last.
    ++atWork_;
    for (std::size_t i = next_++; i < work_.pieces; i = next_++) doPiece(i);
    if (--atWork_ == 0) atWork_.notify_all();
  }
  //! Precondition: no piece is left.
  void wait() const {
    for (int n = atWork_; n != 0; n = atWork_) atWork_.wait(n);
  }
  void throwAgain() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }
  bool hasPieces() const { return next_ < work_.pieces; }

 private:
  void doPiece(std::size_t i) {
    try {
      work_.call(work_.context, i);
    } catch (...) {
      next_ = work_.pieces;
      const std::lock_guard lock(guard_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }

  const PooledWork work_;
  const std::atomic<bool>* const cancelled_;
  std::atomic<std::size_t> next_{0};
  std::atomic<int> atWork_{0};
  std::mutex guard_;
  std::exception_ptr thrown_;
};

class Pool {
 public:
  void run(const PooledWork& work) {
    const auto job = std::make_shared<Job>(work);
    call(job, std::min(static_cast<std::size_t>(work.threads), work.pieces) - 1);
    job->help();
    dismiss(job.get());
    job->wait();
    job->throwAgain();
  }

 private:
  void call(const std::shared_ptr<Job>& job, std::size_t helpers) {
    {
      const std::lock_guard lock(guard_);
      while (threads_ < helpers && makeThread()) ++threads_;
      helpers = std::min(helpers, threads_);
      jobs_.insert(jobs_.end(), helpers, job);
    }
    for (std::size_t i = 0; i < helpers; ++i) wanted_.notify_one();
  }
  //! False where the system gives no more: then there are fewer helpers.
  bool makeThread() {
    try {
      std::thread([this] { serve(); }).detach();
      return true;
    } catch (const std::system_error&) {
      return false;
    }
  }
  //! Nobody else needs to come.
  void dismiss(const Job* job) {
    const std::lock_guard lock(guard_);
    std::erase_if(jobs_, [job](const auto& j) { return j.get() == job; });
  }
  [[noreturn]] void serve() {
    for (;;) {
      std::shared_ptr<Job> job;
      {
        std::unique_lock lock(guard_);
        wanted_.wait(lock, [this] { return !jobs_.empty(); });
        job = std::move(jobs_.front());
        jobs_.pop_front();
      }
      if (job->hasPieces()) job->help();
    }
  }

  std::mutex guard_;
  std::condition_variable wanted_;
  std::deque<std::shared_ptr<Job>> jobs_;  // as often as helpers are wanted
  std::size_t threads_ = 0;
};

}  // namespace

void runOnPool(const PooledWork& work) {
  // Never destroyed: its threads end with the process. A process made by fork has none of them, and could not
  // wait for their end.
  static Pool& pool = *new Pool;
  pool.run(work);
}

}  // namespace handlebody
