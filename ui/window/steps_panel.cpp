#include "ui/window/steps_panel.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace handlebody::ui {

namespace {

constexpr Command kSteps[] = {Command::stepOpen, Command::stepSeed, Command::stepTune, Command::stepGrow,
                              Command::stepExport};

QToolButton* stepButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setAccessibleName(StepsPanel::tr("Step %1").arg(action->text().remove(QLatin1Char('&'))));
  return button;
}

}  // namespace

StepsPanel::StepsPanel(const Commands& commands, QWidget* parent)
    : QWidget(parent), commands_(commands), pages_(new QStackedWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(4);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(6, 0, 6, 0);
  bar->setSpacing(2);
  for (Command step : kSteps) {
    bar->addWidget(stepButton(commands_[step], this));
    connect(commands_[step], &QAction::triggered, this, [this, step] { show(step); });
  }
  layout->addLayout(bar);
  layout->addWidget(pages_, 1);
  setMinimumWidth(290);
}

void StepsPanel::add(Command step, QWidget* panel) {
  auto* scroll = new QScrollArea(pages_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(panel);
  pages_->addWidget(scroll);
  steps_.push_back(step);
}

void StepsPanel::show(Command step) {
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (steps_[i] == step) pages_->setCurrentIndex(static_cast<int>(i));
  commands_[step]->setChecked(true);
}

Command StepsPanel::shown() const { return steps_[static_cast<std::size_t>(pages_->currentIndex())]; }

}  // namespace handlebody::ui
