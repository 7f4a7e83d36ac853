// Where a growth pauses for its user: what is said, shown and offered where the surface came through a
// passage, or where a limit of the topology holds it back.

#include <algorithm>

#include "ui/model/finding_text.h"
#include "ui/window/grow/topology_section.h"
#include "ui/window/main_window.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::ui {

void MainWindow::showLeak(int index) {
  if (index < 0 || index >= static_cast<int>(document_.leaks().size())) return;
  const FoundLeak found = document_.leaks()[index];
  state_.setCrosshair(found.leak.place);
  const QString text = tr("A leak at iteration %1: %2.")
                           .arg(QString::number(found.leak.iteration), findingText(findingOf(found.leak)));
  const auto isStill = [this, index, found] {
    const auto& all = document_.leaks();
    return index < static_cast<int>(all.size()) && all[index].leak.iteration == found.leak.iteration;
  };
  const auto wall = [this, index, isStill] {
    if (!isStill()) return;
    document_.wallAt(index);
    document_.run();
  };
  const auto back = [this, found, isStill] {
    if (isStill()) document_.goTo(found.before);
  };
  const auto on = [this] { document_.run(); };
  messages_->show(MessageBar::Kind::warning, text,
                  {{tr("Wall here"), wall}, {tr("Go back"), back}, {tr("Go on"), on}});
}

//! What a limit of the topology holds, for somebody to decide.
void MainWindow::showQuestion() {
  const std::vector<HeldPlace> open = document_.openQuestions();
  if (open.empty()) return;
  const HeldPlace held = open.front();
  state_.setCrosshair(held.place);
  messages_->show(MessageBar::Kind::warning, questionText(held),
                  {{tr("Let it happen"), [this, held] { answerQuestion(held, true); }},
                   {tr("Hold it"), [this, held] { answerQuestion(held, false); }}});
}

//! Goes on after the last of them.
void MainWindow::answerQuestion(const HeldPlace& held, bool allows) {
  const std::vector<HeldPlace> open = document_.openQuestions();
  const auto isIt = [&](const HeldPlace& h) {
    return h.place == held.place && h.iteration == held.iteration;
  };
  if (std::none_of(open.begin(), open.end(), isIt)) return;
  if (allows)
    document_.allow(held);
  else
    document_.keepHeld(held);
  if (document_.openQuestions().empty())
    document_.run();
  else
    showQuestion();
}

//! The views stay with the object that the user is at.
void MainWindow::offerObject(int object, const QString& text, const std::function<void()>& show) {
  const std::string name = document_.objectInfo(object).label.name;
  const auto go = [this, object, name, show] {
    if (object >= document_.objectCount() || document_.objectInfo(object).label.name != name) return;
    document_.setActiveObject(object);
    show();
  };
  messages_->show(MessageBar::Kind::warning, text.arg(QString::fromStdString(name)), {{tr("Show it"), go}});
}

void MainWindow::tellLeakOf(int object) {
  offerObject(object, tr("“%1” came through a narrow passage."),
              [this] { showLeak(static_cast<int>(document_.leaks().size()) - 1); });
}

void MainWindow::tellQuestionOf(int object) {
  offerObject(object, tr("“%1” has paused: a change of its topology is held, for you to decide."),
              [this] { showQuestion(); });
}

}  // namespace handlebody::ui
