#pragma once
// A kind of job of which only the newest counts: opening a volume, opening objects.

#include <atomic>
#include <memory>

namespace handlebody::ui {

//! Set by whoever does not want the job any more; shared with the thread that does it.
using StopFlag = std::shared_ptr<std::atomic<bool>>;

//! Knows which is the newest of its kind, and whether that is wanted. GUI thread.
class NewestJob {
 public:
  //! One begins; those before it go on, unless they were cancelled. Its flag is not set.
  StopFlag begin() {
    ++number_;
    isUnderWay_ = true;
    return flag_ = std::make_shared<std::atomic<bool>>(false);
  }
  //! The newest is not wanted any more; nothing if there was none.
  void cancel() {
    if (flag_) *flag_ = true;
    isUnderWay_ = false;
  }
  //! The newest has done what it was to do.
  void end() { isUnderWay_ = false; }
  //! Of the newest, from 1 on; 0: there was none.
  int number() const { return number_; }
  bool isUnderWay() const { return isUnderWay_; }
  //! True if that one is under way, not cancelled, and no newer one has begun.
  bool isAwaited(int number) const { return isUnderWay_ && number == number_; }

 private:
  int number_ = 0;
  bool isUnderWay_ = false;
  StopFlag flag_;
};

}  // namespace handlebody::ui
