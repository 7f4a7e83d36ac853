#include "app/cli/evolve.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>

#include "app/cli/progress.h"
#include "core/errors.h"
#include "core/evolution/history.h"
#include "core/io/growth_report.h"

namespace handlebody::cli {

void addOnLeak(CLI::App& command, OnLeak& onLeak) {
  const auto set = [&onLeak](const std::string& text) {
    if (text == "go-on")
      onLeak = OnLeak::goOn;
    else if (text == "pause")
      onLeak = OnLeak::pause;
    else if (text == "stop")
      onLeak = OnLeak::stop;
    else if (text == "wall")
      onLeak = OnLeak::wall;
    else
      throw UsageError("--on-leak: '" + text + "' is not go-on, pause, stop or wall.");
  };
  command
      .add_option_function<std::string>(
          "--on-leak", set,
          "When the surface comes through a passage much narrower than what lies on both sides: go-on "
          "(default) warns; stop ends with the mesh of before (exit code 6); wall puts a disc across and "
          "goes "
          "on; pause asks at the terminal, and is stop where there is none")
      ->type_name("go-on|pause|stop|wall");
}

namespace {

//! Nothing is kept to go back to.
ActiveContour goOn(ActiveContour contour, RunReport& report, bool quiet) {
  Progress progress(quiet);
  auto change = report.session.changes.begin();
  const int last = report.session.stopAt.value_or(std::numeric_limits<int>::max());
  while (contour.iteration() < last) {
    if (change != report.session.changes.end() && change->iteration == contour.iteration()) {
      contour.change(changed(contour.request(), *change));
      if (change->seeds && contour.correction())
        report.corrections.push_back({contour.iteration(), *contour.correction()});
      ++change;
    }
    if (contour.stopReason() != StopReason::running) break;
    StepReport step = contour.step();
    progress.show(step);
    std::move(step.events.begin(), step.events.end(), std::back_inserter(report.events));
    for (const Leak& leak : step.leaks) report.leaks.push_back({leak, LeakAnswer::goOn});
  }
  return contour;
}

LeakAnswer asked(const Leak& leak) {
  if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1) return LeakAnswer::stop;
  std::fprintf(stderr, "A leak at iteration %d: %s.\n", leak.iteration, sentence(leak).c_str());
  for (;;) {
    std::fputs("[w]all here, [s]top before it, [g]o on? ", stderr);
    std::string line;
    if (!std::getline(std::cin, line)) return LeakAnswer::stop;
    if (line == "w") return LeakAnswer::wall;
    if (line == "s") return LeakAnswer::stop;
    if (line == "g") return LeakAnswer::goOn;
  }
}

//! A disc across the passage, and from before the leak on. False where that cannot be: the surface would lie
//! across it. Discs that were put up later than where this one leads back to stay: else the surface would
//! come through their passages again.
bool wallIn(History& history, const Leak& leak) try {
  const int now = history.iteration();
  Request request{history.seeds(), history.parameters(), history.constraints()};
  request.constraints.walls.discs.push_back(leak.disc);
  history.goTo(history.lastBefore(leak));
  try {
    history.change(request);
  } catch (...) {
    history.goTo(now);
    throw;
  }
  return true;
} catch (const UsageError&) {
  return false;
}

//! True if a disc lies there already: it did not close the passage, and another would not either.
bool isWalled(const History& history, const Leak& leak) {
  const auto& discs = history.constraints().walls.discs;
  return std::any_of(discs.begin(), discs.end(), [&](const WallDisc& d) {
    return (d.centre - leak.disc.centre).norm() < 0.5 * leak.disc.radius;
  });
}

LeakAnswer answerTo(History& history, const Leak& leak, OnLeak onLeak) {
  LeakAnswer answer = onLeak == OnLeak::wall    ? LeakAnswer::wall
                      : onLeak == OnLeak::pause ? asked(leak)
                                                : LeakAnswer::stop;
  if (answer == LeakAnswer::wall && (isWalled(history, leak) || !wallIn(history, leak)))
    answer = LeakAnswer::goOn;
  if (answer == LeakAnswer::stop) history.goTo(history.lastBefore(leak));
  return answer;
}

ActiveContour watched(ActiveContour contour, RunReport& report, const EvolveSettings& settings) {
  Progress progress(settings.quiet);
  History history(std::move(contour));
  bool isStopped = false;
  while (!isStopped && history.stopReason() == StopReason::running) {
    history.advance();
    progress.show(history.steps().back());
    const std::vector<Leak> leaks = history.steps().back().leaks;
    for (const Leak& leak : leaks) {
      progress.clear();
      const LeakAnswer answer = answerTo(history, leak, settings.onLeak);
      report.leaks.push_back({leak, answer});
      isStopped = answer == LeakAnswer::stop;
      if (answer != LeakAnswer::goOn) break;  // the others are behind the shown iteration now
    }
  }
  const int end = history.iteration();
  for (const Event& e : history.events())
    if (e.iteration <= end) report.events.push_back(e);
  report.session.changes = history.changes();
  if (isStopped) {
    std::erase_if(report.session.changes, [&](const ParameterChange& c) { return c.iteration >= end; });
    report.session.stopAt = end;
    report.isStoppedAtLeak = true;
  }
  return history.shown();
}

}  // namespace

ActiveContour evolve(ActiveContour contour, RunReport& report, const EvolveSettings& settings) {
  // Traces are kept only when they will be written: they can be many times larger than the mesh.
  contour.recordTraces(settings.traces);
  ActiveContour end = settings.onLeak == OnLeak::goOn ? goOn(std::move(contour), report, settings.quiet)
                                                      : watched(std::move(contour), report, settings);
  requireNothingWaiting(end);
  tellState(end, report);
  return end;
}

}  // namespace handlebody::cli
