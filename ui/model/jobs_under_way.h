#pragma once
// A kind of job of which each counts: writing files.

#include <vector>

#include "ui/model/newest_job.h"

namespace handlebody::ui {

//! Knows which are under way, so that all of them can be cancelled. GUI thread.
class JobsUnderWay {
 public:
  //! One begins. Its flag is not set.
  StopFlag begin() {
    flags_.push_back(std::make_shared<std::atomic<bool>>(false));
    return flags_.back();
  }
  //! None of them is wanted any more; those that begin later are.
  void cancel() {
    for (const StopFlag& flag : flags_) *flag = true;
  }
  //! That one has ended, well or not.
  void end(const StopFlag& flag) { std::erase(flags_, flag); }

 private:
  std::vector<StopFlag> flags_;
};

}  // namespace handlebody::ui
