#pragma once
// One line on standard error, rewritten; nothing when that is not a terminal.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string_view>
#include <thread>

#include "core/evolution/step_report.h"
#include "core/phase.h"

namespace handlebody::cli {

//! The iteration of a growth, whose phases are not shown.
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
  PhaseScope noPhases_{{}};
};

//! While it lives: the phase that work on this thread is at, and for how many seconds. Each is there at least
//! once, however short; else the line changes no more than every tenth of a second. Between phases there
//! is no line, so that whatever else is to be said can be said there.
class PhaseLine {
 public:
  explicit PhaseLine(bool quiet);

 private:
  void tell(const char* phase);
  void tick(const std::stop_token& stop);
  void draw();

  std::mutex mutex_;
  std::condition_variable_any sleeping_;
  const char* phase_ = "";
  const char* shown_ = "";
  std::set<std::string_view> known_;  // phases that have been there
  long shownSeconds_ = 0;
  std::chrono::steady_clock::time_point began_{}, drawn_{};
  std::optional<PhaseScope> scope_;
  std::jthread ticks_;  // a phase that says nothing for long is seen to be alive
};

}  // namespace handlebody::cli
