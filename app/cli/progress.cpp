#include "app/cli/progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace handlebody::cli {

namespace {

constexpr auto kBetweenLines = std::chrono::milliseconds(100);  // a terminal is slower than a step

bool isShown(bool quiet) { return !quiet && ::isatty(STDERR_FILENO) == 1; }

void eraseLine() {
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(bool quiet) : on_(isShown(quiet)) {}

void Progress::show(const StepReport& step) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && now - last_ < kBetweenLines) return;
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, "\r\033[Kiteration %d, %d vertices moving, %.3f ml", step.iteration,
               step.movedVertices, step.volume / 1000.0);
  std::fflush(stderr);
}

void Progress::clear() {
  if (!shown_) return;
  eraseLine();
  shown_ = false;
}

PhaseLine::PhaseLine(bool quiet) {
  if (!isShown(quiet)) return;
  scope_.emplace([this](const char* phase) { tell(phase); });
  ticks_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
}

void PhaseLine::tell(const char* phase) {
  const std::scoped_lock lock(mutex_);
  phase_ = phase;
  began_ = std::chrono::steady_clock::now();
  if (*phase_ == '\0') {
    if (*shown_ != '\0') eraseLine();
    shown_ = phase_;
  } else if (known_.insert(phase).second || began_ - drawn_ >= kBetweenLines) {
    draw();
  }
}

void PhaseLine::tick(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    sleeping_.wait_for(lock, stop, kBetweenLines, [] { return false; });
    if (*phase_ != '\0') draw();
  }
}

//! The lock is held.
void PhaseLine::draw() {
  const auto now = std::chrono::steady_clock::now();
  const long seconds = std::chrono::duration_cast<std::chrono::seconds>(now - began_).count();
  if (phase_ == shown_ && seconds == shownSeconds_) return;
  drawn_ = now;
  shown_ = phase_;
  shownSeconds_ = seconds;
  const std::string lasting = seconds > 0 ? ", " + std::to_string(seconds) + " s" : "";
  std::fprintf(stderr, "\r\033[K%s%s", phase_, lasting.c_str());
  std::fflush(stderr);
}

}  // namespace handlebody::cli
