#pragma once

#include <chrono>

#include "core/evolution/step_report.h"

namespace handlebody::cli {

//! One line on standard error, rewritten; nothing when that is not a terminal.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const StepReport& step);
  //! Takes the line away.
  void clear();

 private:
  bool on_ = false;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace handlebody::cli
