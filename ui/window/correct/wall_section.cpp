#include "ui/window/correct/wall_section.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/model/document.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/correct/brush_controls.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

WallSection::WallSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  for (Command id : {Command::paintWalls, Command::eraseWalls}) row->addWidget(toggleFor(commands[id], this));
  layout->addLayout(row);
  QFormLayout* form = panelForm();
  form->addRow(tr("Radius"), brushRadius(state.brush(), this));
  layout->addLayout(form);
  walls_ = value(tr("Number of walls"), this);
  layout->addWidget(walls_);
  layout->addWidget(new ActionButton(commands[Command::goOnBeforeWalls], this));
  layout->addWidget(new ActionButton(commands[Command::removeWalls], this));
  for (auto changed : {&Document::constraintsChanged, &Document::opened, &Document::activeObjectChanged})
    connect(&document_, changed, this, &WallSection::showWalls);
  showWalls();
}

void WallSection::showWalls() {
  const auto count = static_cast<int>(document_.constraints().walls.balls.size());
  walls_->setText(count == 0 ? tr("Nothing is painted.") : tr("Balls painted: %1").arg(count));
}

}  // namespace handlebody::ui
