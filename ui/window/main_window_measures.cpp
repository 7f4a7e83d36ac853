// Measures, rulers, angles and centre lines in the window.

#include <QDockWidget>

#include "ui/model/measurements.h"
#include "ui/model/measuring.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/measures/measures_panel.h"
#include "ui/window/measures/sensitivity_page.h"
#include "ui/window/open/file_work.h"
#include "ui/window/widgets/panel_area.h"

namespace handlebody::ui {

namespace {

constexpr int kUsualHeight = 250;  // pixels, of the panel when it is shown first

struct ToolCommand {
  Command command;
  MeasureTool::Mode mode;
};
constexpr ToolCommand kTools[] = {{Command::ruler, MeasureTool::Mode::ruler},
                                  {Command::angle, MeasureTool::Mode::angle},
                                  {Command::centreLine, MeasureTool::Mode::centreLine}};

}  // namespace

// Behind the timeline, and out of the way until it is asked for.
void MainWindow::buildMeasures() {
  measures_ = new MeasuresPanel(document_, state_, commands_);
  measuresDock_ = new QDockWidget(tr("Measures"), this);
  measuresDock_->setObjectName(QStringLiteral("measures"));
  measuresDock_->setWidget(new PanelArea(measures_));
  addDockWidget(Qt::BottomDockWidgetArea, measuresDock_);
  tabifyDockWidget(timelineDock_, measuresDock_);
  measuresDock_->hide();
}

//! The first time higher than the timeline, whose place it takes, if that has no room for a table.
void MainWindow::showMeasures() {
  const bool isFirst = measuresDock_->isHidden();
  measuresDock_->show();
  measuresDock_->raise();
  if (isFirst && timelineDock_->height() < kUsualHeight && !measuresDock_->isFloating())
    resizeDocks({measuresDock_}, {kUsualHeight}, Qt::Vertical);
}

void MainWindow::connectMeasureCommands() {
  on(Command::showMeasures, [this] {
    measures_->show(MeasuresPanel::Page::objects);
    showMeasures();
  });
  on(Command::sensitivity, [this] {
    measures_->show(MeasuresPanel::Page::sensitivity);
    showMeasures();
    measures_->sensitivity().start();
  });
  for (const ToolCommand& tool : kTools)
    connect(commands_[tool.command], &QAction::triggered, this, [this, mode = tool.mode](bool on) {
      state_.measure().setMode(on ? mode : MeasureTool::Mode::off);
      if (!on) return;
      state_.brush().setMode(Brush::Mode::off);  // one tool at a time has the left button
      state_.setWindowLevelTool(false);
      measures_->show(mode == MeasureTool::Mode::centreLine ? MeasuresPanel::Page::centreLine
                                                            : MeasuresPanel::Page::rulers);
    });
  connect(&state_.brush(), &Brush::changed, this, [this] {
    if (state_.brush().isOn()) state_.measure().setMode(MeasureTool::Mode::off);
  });
  connect(&state_.measure(), &MeasureTool::modeChanged, this, &MainWindow::updateMeasureCommands);
  connect(measures_, &MeasuresPanel::wanted, this, &MainWindow::showMeasures);
  connect(measures_, &MeasuresPanel::saveRequested, files_, &FileWork::saveText);
  connect(measures_, &MeasuresPanel::saveFileRequested, files_, &FileWork::saveFile);
  connect(export_, &ExportPanel::anonymousChanged, measures_, &MeasuresPanel::setAnonymous);
  updateMeasureCommands();
}

void MainWindow::updateMeasureCommands() {
  const bool open = document_.hasVolume();
  commands_[Command::sensitivity]->setEnabled(sensitivityFault(document_).isEmpty());
  for (const ToolCommand& tool : kTools) {
    commands_[tool.command]->setEnabled(
        open && (tool.mode != MeasureTool::Mode::centreLine || !shownSurfaces(document_).empty()));
    commands_[tool.command]->setChecked(state_.measure().mode() == tool.mode);
  }
}

}  // namespace handlebody::ui
