// The leak alarm in the window: what is said, shown and offered where the surface came through a passage.

#include "ui/model/finding_text.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace handlebody::ui {

void MainWindow::showLeak(int index) {
  if (index < 0 || index >= static_cast<int>(document_.leaks().size())) return;
  const FoundLeak found = document_.leaks()[static_cast<std::size_t>(index)];
  state_.setCrosshair(found.leak.place);
  const QString text = tr("A leak at iteration %1: %2.")
                           .arg(QString::number(found.leak.iteration), findingText(findingOf(found.leak)));
  const auto isStill = [this, index, found] {
    const auto& all = document_.leaks();
    return index < static_cast<int>(all.size()) &&
           all[static_cast<std::size_t>(index)].leak.iteration == found.leak.iteration;
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

//! The views stay with the object that the user is at.
void MainWindow::tellLeakOf(int object) {
  const std::string name = document_.objectInfo(object).label.name;
  const auto show = [this, object, name] {
    if (object >= document_.objectCount() || document_.objectInfo(object).label.name != name) return;
    document_.setActiveObject(object);
    showLeak(static_cast<int>(document_.leaks().size()) - 1);
  };
  messages_->show(MessageBar::Kind::warning,
                  tr("“%1” came through a narrow passage.").arg(QString::fromStdString(name)),
                  {{tr("Show it"), show}});
}

}  // namespace handlebody::ui
