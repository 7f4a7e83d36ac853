// Where a growth pauses for its user: what is said, shown and offered where the surface came through a
// passage, or where a limit of the topology holds it back.

#include <algorithm>

#include "ui/model/finding_text.h"
#include "ui/window/grow/topology_section.h"
#include "ui/window/main_window.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::ui {

//! Answers may come when the user is at another object: what they do is about this one. False: it is gone.
bool MainWindow::goToObject(const std::weak_ptr<const void>& object) {
  document_.setActiveObject(document_.indexOfObject(object));
  return document_.objectKey(document_.activeObject()).lock() == object.lock();
}

void MainWindow::showLeak(int index) {
  if (index < 0 || index >= static_cast<int>(document_.leaks().size())) return;
  const FoundLeak found = document_.leaks()[index];
  state_.setCrosshair(found.leak.place);
  const QString text = tr("A leak at iteration %1: %2.")
                           .arg(QString::number(found.leak.iteration), findingText(findingOf(found.leak)));
  const auto goToLeak = [this, index, found, object = document_.objectKey(document_.activeObject())] {
    if (!goToObject(object)) return false;
    const auto& all = document_.leaks();
    return index < static_cast<int>(all.size()) && all[index].leak.iteration == found.leak.iteration;
  };
  const auto wall = [this, index, goToLeak] {
    if (!goToLeak()) return;
    document_.wallAt(index);
    document_.run();
  };
  const auto back = [this, found, goToLeak] {
    if (goToLeak()) document_.goTo(found.before);
  };
  const auto on = [this, object = document_.objectKey(document_.activeObject())] {
    if (goToObject(object)) document_.run();
  };
  messages_->show(MessageBar::Kind::warning, text,
                  {{tr("Wall here"), wall}, {tr("Go back"), back}, {tr("Go on"), on}});
}

//! What a limit of the topology holds, for somebody to decide.
void MainWindow::showQuestion() {
  const std::vector<HeldPlace> open = document_.openQuestions();
  if (open.empty()) return;
  const HeldPlace held = open.front();
  state_.setCrosshair(held.place);
  const auto answer = [this, held, object = document_.objectKey(document_.activeObject())](bool allows) {
    if (goToObject(object)) answerQuestion(held, allows);
  };
  messages_->show(
      MessageBar::Kind::warning, questionText(held),
      {{tr("Let it happen"), [answer] { answer(true); }}, {tr("Hold it"), [answer] { answer(false); }}});
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
  const auto go = [this, key = document_.objectKey(object), show] {
    if (goToObject(key)) show();
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
