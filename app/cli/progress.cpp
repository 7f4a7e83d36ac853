#include "app/cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace handlebody::cli {

Progress::Progress(bool quiet) : on_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

void Progress::show(const StepReport& step) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && now - last_ < std::chrono::milliseconds(100)) return;  // a terminal is slower than a step
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, "\r\033[Kiteration %d, %d vertices moving, %.3f ml", step.iteration,
               step.movedVertices, step.volume / 1000.0);
  std::fflush(stderr);
}

void Progress::clear() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace handlebody::cli
