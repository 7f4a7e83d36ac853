// What the commands of the list of objects do.

#include <QSignalBlocker>

#include "ui/window/main_window.h"
#include "ui/window/objects/object_dialog.h"
#include "ui/window/widgets/message_bar.h"
#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

void MainWindow::connectObjectCommands() {
  on(Command::addObject, [this] {
    document_.addObject();
    showStep(Command::stepSeed);
  });
  on(Command::duplicateObject, [this] {
    document_.duplicateObject(document_.activeObject());
    showStep(Command::stepSeed);
  });
  on(Command::deleteObject, [this] { document_.removeObject(document_.activeObject()); });
  on(Command::editObject, [this] { (new ObjectDialog(document_, this))->open(); });
  const auto move = [this](int by) {
    document_.moveObject(document_.activeObject(), document_.activeObject() + by);
  };
  on(Command::moveObjectUp, [move] { move(-1); });
  on(Command::moveObjectDown, [move] { move(1); });
  on(Command::nextObject, [this] { document_.setActiveObject(document_.activeObject() + 1); });
  on(Command::previousObject, [this] { document_.setActiveObject(document_.activeObject() - 1); });
  on(Command::growAll, [this] { document_.runAll(); });
  connect(commands_[Command::objectVisible], &QAction::triggered, this,
          [this](bool on) { document_.setObjectVisible(document_.activeObject(), on); });
  connect(commands_[Command::objectLocked], &QAction::triggered, this,
          [this](bool on) { document_.setObjectLocked(document_.activeObject(), on); });
  connect(&document_, &Document::activeObjectChanged, this, &MainWindow::showObject);
  connect(&document_, &Document::objectsChanged, this, &MainWindow::updateCommands);
  connect(&document_, &Document::refused, this,
          [this](const QString& sentence) { messages_->show(MessageBar::Kind::warning, sentence); });
}

//! The crosshair goes to a seed of it, so that the slices show it; of work that was just opened it stays.
void MainWindow::showObject() {
  seekingEvent_ = false;
  endGesture();
  if (std::exchange(justOpened_, false)) return;
  if (document_.seeds().empty()) return;
  if (document_.selectedSeed() < 0) document_.selectSeed(0);
  state_.setCrosshair(document_.seeds()[document_.selectedSeed()].centre);
}

void MainWindow::updateObjectCommands() {
  const bool open = document_.hasVolume();
  const int count = document_.objectCount(), active = document_.activeObject();
  const ObjectInfo info = document_.objectInfo(active);
  const auto enable = [this](Command id, bool on) { commands_[id]->setEnabled(on); };
  for (Command id : {Command::addObject, Command::duplicateObject, Command::editObject,
                     Command::objectVisible, Command::objectLocked})
    enable(id, open);
  bool toGrow = false;
  for (int i = 0; i < count; ++i) {
    const ObjectInfo other = document_.objectInfo(i);
    toGrow = toGrow || (other.seeded && !other.locked && other.state != GrowthState::finished);
  }
  enable(Command::growAll, open && toGrow);
  enable(Command::deleteObject, open && count > 1);
  enable(Command::moveObjectUp, active > 0);
  enable(Command::moveObjectDown, active + 1 < count);
  enable(Command::nextObject, active + 1 < count);
  enable(Command::previousObject, active > 0);
  commands_[Command::objectVisible]->setChecked(info.visible);
  commands_[Command::objectLocked]->setChecked(info.locked);
  if (!info.locked) return;
  for (Command id :
       {Command::addSeed,     Command::addOutside,      Command::deleteSeed,       Command::growSeed,
        Command::shrinkSeed,  Command::smallerObject,   Command::largerObject,     Command::paintWalls,
        Command::eraseWalls,  Command::wallAtCrosshair, Command::eraseAtCrosshair, Command::removeWalls,
        Command::pinByBrush,  Command::unpinByBrush,    Command::smoothByBrush,    Command::pullByDragging,
        Command::cutByLine,   Command::removePins,      Command::goOnBeforeWalls,  Command::run,
        Command::stepForward, Command::stepBack,        Command::nextEvent,        Command::previousEvent,
        Command::toStart,     Command::toEnd,           Command::deleteObject})
    enable(id, false);
}

}  // namespace handlebody::ui
