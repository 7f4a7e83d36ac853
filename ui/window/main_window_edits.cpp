// What is said of an edit of the mesh when it was made.

#include "ui/window/main_window.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/message_bar.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

void MainWindow::tellOfEdit() {
  const Event *first = nullptr, *last = nullptr;
  int count = 0;
  for (const Event& e : document_.events()) {
    if (e.iteration != document_.iteration() || !e.edit) continue;
    if (!first) first = &e;
    last = &e;
    ++count;
  }
  if (!first) return;
  const QString what = count > 1 ? tr("%1 (%2)").arg(eventName(*first)).arg(count) : eventName(*first);
  messages_->show(MessageBar::Kind::information, tr("%1: %2, was %3.")
                                                     .arg(what, millilitres(last->edit->volumeAfter),
                                                          millilitres(first->edit->volumeBefore)));
}

}  // namespace handlebody::ui
