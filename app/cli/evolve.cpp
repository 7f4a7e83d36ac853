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
#include "core/io/report/growth_report.h"
#include "core/io/report/option_error.h"

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
      throw OptionError("--on-leak", "'" + text + "' is not go-on, pause, stop or wall.");
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

void addOnHeld(CLI::App& command, OnHeld& onHeld) {
  const auto set = [&onHeld](const std::string& text) {
    if (text == "hold")
      onHeld = OnHeld::hold;
    else if (text == "pause")
      onHeld = OnHeld::pause;
    else if (text == "stop")
      onHeld = OnHeld::stop;
    else
      throw OptionError("--on-held", "'" + text + "' is not hold, pause or stop.");
  };
  command
      .add_option_function<std::string>(
          "--on-held", set,
          "When a change of topology comes that would break --components or --genus: hold (default) holds "
          "and lists it; stop ends with the mesh of before (exit code 6) and says which --allow or --hold "
          "answers; pause asks at the terminal each time, and is stop where there is none")
      ->type_name("hold|pause|stop");
}

bool letAsk(OnHeld onHeld, Constraints& constraints) {
  TopologyLimits& limits = constraints.topology;
  if (onHeld != OnHeld::hold && (limits.components || limits.genus)) limits.asks = true;
  return limits.asks;
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
    report.questions.insert(report.questions.end(), step.questions.begin(), step.questions.end());
  }
  return contour;
}

bool isAtTerminal() { return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1; }

//! The letter that a person chooses; the last of them where nobody answers.
char letterOf(const char* question, const std::string& letters) {
  for (;;) {
    std::fputs(question, stderr);
    std::string line;
    if (!std::getline(std::cin, line)) return letters.back();
    if (line.size() == 1 && letters.find(line[0]) != std::string::npos) return line[0];
  }
}

LeakAnswer asked(const Leak& leak) {
  if (!isAtTerminal()) return LeakAnswer::stop;
  std::fprintf(stderr, "A leak at iteration %d: %s.\n", leak.iteration, sentence(leak).c_str());
  const char letter = letterOf("[w]all here, [g]o on, [s]top before it? ", "wgs");
  return letter == 'w' ? LeakAnswer::wall : letter == 'g' ? LeakAnswer::goOn : LeakAnswer::stop;
}

//! Nothing: that is to be decided later.
std::optional<HeldAnswer> asked(const HeldPlace& held) {
  if (!isAtTerminal()) return std::nullopt;
  std::fprintf(stderr, "Held at iteration %d: %s.\n", held.iteration, sentence(held).c_str());
  const char letter = letterOf("[l]et it happen, [h]old it, [s]top here? ", "lhs");
  if (letter == 's') return std::nullopt;
  return letter == 'l' ? HeldAnswer::allow : HeldAnswer::hold;
}

//! False if it is to end here.
bool decide(History& history, const HeldPlace& held, OnHeld onHeld) {
  const std::optional<HeldAnswer> answer = onHeld == OnHeld::pause ? asked(held) : std::nullopt;
  if (!answer) return false;
  Request request{history.seeds(), history.parameters(), history.constraints()};
  TopologyLimits& limits = request.constraints.topology;
  (*answer == HeldAnswer::allow ? limits.allowed : limits.kept).push_back(held.place);
  history.change(request);
  return true;
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

//! What the step just made has told. True if it is to end at the shown iteration.
bool isStoppedByLeak(History& history, RunReport& report, OnLeak onLeak) {
  const std::vector<Leak> leaks = history.steps().back().leaks;
  for (const Leak& leak : leaks) {
    const LeakAnswer answer = onLeak == OnLeak::goOn ? LeakAnswer::goOn : answerTo(history, leak, onLeak);
    report.leaks.push_back({leak, answer});
    // The others are behind the shown iteration now.
    if (answer != LeakAnswer::goOn) return answer == LeakAnswer::stop;
  }
  return false;
}

bool isStoppedToAsk(History& history, RunReport& report, OnHeld onHeld) {
  const std::vector<HeldPlace> questions = history.steps().back().questions;
  for (const HeldPlace& held : questions) {
    report.questions.push_back(held);
    if (onHeld != OnHeld::hold && !decide(history, held, onHeld)) return true;
  }
  return false;
}

ActiveContour watched(ActiveContour contour, RunReport& report, const EvolveSettings& settings) {
  Progress progress(settings.quiet);
  History history(std::move(contour));
  bool isStopped = false;
  while (!isStopped && history.stopReason() == StopReason::running) {
    history.advance();
    progress.show(history.steps().back());
    const int made = history.iteration();
    const StepReport& step = history.steps().back();
    if (!step.leaks.empty() || !step.questions.empty()) progress.clear();
    isStopped = report.isStoppedAtLeak = isStoppedByLeak(history, report, settings.onLeak);
    if (!isStopped && history.iteration() == made)  // else what it asked is not there any more
      isStopped = report.isStoppedToAsk = isStoppedToAsk(history, report, settings.onHeld);
  }
  const int end = history.iteration();
  std::erase_if(report.questions, [&](const HeldPlace& h) { return h.iteration > end; });
  for (const Event& e : history.events())
    if (e.iteration <= end) report.events.push_back(e);
  report.session.changes = history.changes();
  if (isStopped) {
    std::erase_if(report.session.changes, [&](const ParameterChange& c) { return c.iteration >= end; });
    report.session.stopAt = end;
  }
  return history.shown();
}

}  // namespace

ActiveContour evolve(ActiveContour contour, RunReport& report, const EvolveSettings& settings) {
  // Traces are kept only when they will be written: they can be many times larger than the mesh.
  contour.recordTraces(settings.traces);
  const bool watches = settings.onLeak != OnLeak::goOn || settings.onHeld != OnHeld::hold;
  ActiveContour end = watches ? watched(std::move(contour), report, settings)
                              : goOn(std::move(contour), report, settings.quiet);
  requireNothingWaiting(end);
  tellState(end, report);
  return end;
}

}  // namespace handlebody::cli
