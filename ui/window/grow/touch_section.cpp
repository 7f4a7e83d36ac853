#include "ui/window/grow/touch_section.h"

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

TouchSection::TouchSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  row->addWidget(toggleFor(commands[Command::pinByBrush], this, tr("Pin")));
  row->addWidget(toggleFor(commands[Command::unpinByBrush], this, tr("Unpin")));
  row->addWidget(toggleFor(commands[Command::smoothByBrush], this, tr("Smooth")));
  row->addWidget(toggleFor(commands[Command::pullByDragging], this, tr("Pull")));
  row->addWidget(toggleFor(commands[Command::cutByLine], this, tr("Cut line")));
  layout->addLayout(row);
  QFormLayout* form = panelForm();
  form->addRow(tr("Radius"), brushRadius(state.brush(), this));
  layout->addLayout(form);
  pins_ = value(tr("Number of pins"), this);
  layout->addWidget(pins_);
  layout->addWidget(new ActionButton(commands[Command::removePins], this));
  for (auto changed : {&Document::constraintsChanged, &Document::opened, &Document::activeObjectChanged})
    connect(&document_, changed, this, &TouchSection::showPins);
  showPins();
}

void TouchSection::showPins() {
  const auto count = static_cast<int>(document_.constraints().pins.size());
  pins_->setText(count == 0 ? tr("Nothing is pinned.") : tr("Balls pinned: %1").arg(count));
}

}  // namespace handlebody::ui
