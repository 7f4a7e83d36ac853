// What the commands of the brush do, and the ways out of a wall over the surface.

#include "ui/window/main_window.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::ui {

namespace {

constexpr std::pair<Command, Brush::Mode> kTouching[] = {{Command::pinByBrush, Brush::Mode::pin},
                                                         {Command::unpinByBrush, Brush::Mode::unpin},
                                                         {Command::smoothByBrush, Brush::Mode::smooth},
                                                         {Command::pullByDragging, Brush::Mode::pull},
                                                         {Command::cutByLine, Brush::Mode::cut}};

}  // namespace

void MainWindow::connectCorrectCommands() {
  const auto use = [this](Command id, Brush::Mode mode) {
    connect(commands_[id], &QAction::triggered, this, [this, mode](bool on) {
      if (on) state_.setShowsConstraints(true);  // what it does is to be seen
      state_.brush().setMode(on ? mode : Brush::Mode::off);
    });
  };
  use(Command::paintWalls, Brush::Mode::paintWalls);
  use(Command::eraseWalls, Brush::Mode::eraseWalls);
  for (const auto& [id, mode] : kTouching) use(id, mode);
  on(Command::largerBrush, [this] { state_.brush().turnWheel(1); });
  on(Command::smallerBrush, [this] { state_.brush().turnWheel(-1); });
  on(Command::wallAtCrosshair, [this] { brushAtCrosshair(false); });
  on(Command::eraseAtCrosshair, [this] { brushAtCrosshair(true); });
  on(Command::goOnBeforeWalls, [this] { document_.goOnBeforeWalls(); });
  on(Command::removeWalls, [this] {
    Constraints after = document_.constraints();
    after.walls.balls.clear();
    document_.setConstraints(after, tr("Remove all walls"));
  });
  on(Command::removePins, [this] {
    Constraints after = document_.constraints();
    after.pins.clear();
    document_.setConstraints(after, tr("Remove all pins"));
  });
  connect(&state_.brush(), &Brush::changed, this, [this] {
    updateWallCommands();
    updateObjectCommands();  // of a locked one those of the brush cannot be given
  });
  connect(&document_, &Document::constraintsChanged, this, &MainWindow::updateCommands);
  connect(&document_, &Document::wallConflictChanged, this, &MainWindow::showWallConflict);
}

void MainWindow::brushAtCrosshair(bool erases) {
  const std::vector<WallBall> ball{{state_.crosshair(), state_.brush().radius()}};
  if (erases)
    document_.eraseWalls(ball);
  else
    document_.paintWalls(ball);
}

//! After a change of the walls, or where the growth could not go on with them.
void MainWindow::showWallConflict() {
  const auto& conflict = document_.wallConflict();
  const QString text = tr("The surface is already where the wall is.");
  if (!conflict) {
    if (messages_->text() == text) messages_->dismiss();  // undone, or gone back
    return;
  }
  const auto back = [this] {
    if (document_.wallConflict()) document_.goOnBeforeWalls();
  };
  const auto push = [this] { document_.run(); };
  std::vector<MessageBar::Answer> answers{{tr("Go back to before it came in here"), back}};
  if (conflict->canBePushedOut) answers.push_back({tr("Push it out"), push});
  messages_->show(MessageBar::Kind::warning, text, answers);
}

void MainWindow::updateWallCommands() {
  const Brush& brush = state_.brush();
  const bool open = document_.hasVolume();
  const WallList& walls = document_.constraints().walls;
  for (Command id : {Command::paintWalls, Command::eraseWalls, Command::largerBrush, Command::smallerBrush,
                     Command::wallAtCrosshair})
    commands_[id]->setEnabled(open);
  commands_[Command::eraseAtCrosshair]->setEnabled(open && !(walls.balls.empty() && walls.discs.empty()));
  commands_[Command::removeWalls]->setEnabled(open && !walls.balls.empty());
  commands_[Command::goOnBeforeWalls]->setEnabled(open && document_.iteration() > 0 && !walls.empty());
  const auto shown = document_.snapshot();
  const bool hasSurface = open && shown && !shown->mesh.triangles.empty();
  if (!hasSurface && state_.brush().isForSurface()) state_.brush().setMode(Brush::Mode::off);
  for (const auto& [id, mode] : kTouching) {
    commands_[id]->setEnabled(hasSurface);
    commands_[id]->setChecked(brush.mode() == mode);
  }
  commands_[Command::removePins]->setEnabled(open && !document_.constraints().pins.empty());
  commands_[Command::paintWalls]->setChecked(brush.mode() == Brush::Mode::paintWalls);
  commands_[Command::eraseWalls]->setChecked(brush.mode() == Brush::Mode::eraseWalls);
}

}  // namespace handlebody::ui
