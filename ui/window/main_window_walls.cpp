// What the commands of walls do, and the ways out of a wall over the surface.

#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace handlebody::ui {

void MainWindow::connectCorrectCommands() {
  const auto use = [this](Command id, WallBrush::Mode mode) {
    connect(commands_[id], &QAction::triggered, this,
            [this, mode](bool on) { state_.brush().setMode(on ? mode : WallBrush::Mode::off); });
  };
  use(Command::paintWalls, WallBrush::Mode::paint);
  use(Command::eraseWalls, WallBrush::Mode::erase);
  constexpr double kTenth = 1.1;
  on(Command::largerBrush, [this] { state_.brush().setRadius(state_.brush().radius() * kTenth); });
  on(Command::smallerBrush, [this] { state_.brush().setRadius(state_.brush().radius() / kTenth); });
  on(Command::wallAtCrosshair, [this] { brushAtCrosshair(false); });
  on(Command::eraseAtCrosshair, [this] { brushAtCrosshair(true); });
  on(Command::goOnBeforeWalls, [this] { document_.goOnBeforeWalls(); });
  on(Command::removeWalls, [this] {
    Constraints after = document_.constraints();
    after.walls.balls.clear();
    document_.setConstraints(after, tr("Remove all walls"));
  });
  connect(&state_.brush(), &WallBrush::changed, this, &MainWindow::updateWallCommands);
  connect(&document_, &Document::constraintsChanged, this, &MainWindow::updateCommands);
  connect(&document_, &Document::constraintsChanged, this, &MainWindow::showWallConflict);
  connect(&document_, &Document::stateChanged, this, [this] {
    if (!document_.growthError().isEmpty()) showWallConflict();
  });
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
  const auto conflict = document_.wallConflict();
  if (!conflict) {
    if (std::exchange(paintedOver_, false)) messages_->dismiss();  // undone, or gone back
    return;
  }
  const auto back = [this] {
    if (document_.wallConflict()) document_.goOnBeforeWalls();
  };
  const auto push = [this] { document_.run(); };
  std::vector<MessageBar::Answer> answers{{tr("Go back to before it came in here"), back}};
  if (conflict->canBePushedOut) answers.push_back({tr("Push it out"), push});
  messages_->show(MessageBar::Kind::warning, tr("The surface is already where the wall is."), answers);
  paintedOver_ = true;
}

void MainWindow::updateWallCommands() {
  const WallBrush& brush = state_.brush();
  const bool open = document_.hasVolume();
  const WallList& walls = document_.constraints().walls;
  for (Command id : {Command::paintWalls, Command::eraseWalls, Command::largerBrush, Command::smallerBrush,
                     Command::wallAtCrosshair})
    commands_[id]->setEnabled(open);
  commands_[Command::eraseAtCrosshair]->setEnabled(open && !(walls.balls.empty() && walls.discs.empty()));
  commands_[Command::removeWalls]->setEnabled(open && !walls.balls.empty());
  commands_[Command::goOnBeforeWalls]->setEnabled(open && document_.iteration() > 0 && !walls.empty());
  commands_[Command::paintWalls]->setChecked(brush.mode() == WallBrush::Mode::paint);
  commands_[Command::eraseWalls]->setChecked(brush.mode() == WallBrush::Mode::erase);
}

}  // namespace handlebody::ui
