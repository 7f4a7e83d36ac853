// Time in the window: the bar under the views, what is carried over it, its commands.

#include <QDockWidget>

#include "ui/model/time_series.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/open/file_work.h"
#include "ui/window/time/over_time_panel.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/panel_area.h"

namespace handlebody::ui {

namespace {

constexpr int kUsualFrameHeight = 310;  // pixels, of the panel when it is shown first

}  // namespace

// Behind the timeline, and out of the way until it is asked for.
void MainWindow::buildTime() {
  overTime_ = new OverTimePanel(document_, commands_);
  overTimeDock_ = new QDockWidget(tr("Over time"), this);
  overTimeDock_->setObjectName(QStringLiteral("overTime"));
  overTimeDock_->setWidget(new PanelArea(overTime_));
  addDockWidget(Qt::BottomDockWidgetArea, overTimeDock_);
  tabifyDockWidget(timelineDock_, overTimeDock_);
  overTimeDock_->hide();
}

void MainWindow::showOverTime() {
  const bool isFirst = overTimeDock_->isHidden();
  overTimeDock_->show();
  overTimeDock_->raise();
  if (isFirst && timelineDock_->height() < kUsualFrameHeight && !overTimeDock_->isFloating())
    resizeDocks({overTimeDock_}, {kUsualFrameHeight}, Qt::Vertical);
}

void MainWindow::connectTimeCommands() {
  TimeSeries& time = document_.time();
  on(Command::playFrames, [&time] { time.play(!time.isPlaying()); });
  on(Command::previousFrame, [&time] { time.show(time.wantedFrame() - 1); });
  on(Command::nextFrame, [&time] { time.show(time.wantedFrame() + 1); });
  on(Command::toGrownFrame, [&time] { time.show(time.grownFrame()); });
  on(Command::growHere, [this] { growHere(); });
  on(Command::correctFrame, [this] {
    document_.correctShownFrame();
    showStep(Command::stepCorrect);
  });
  on(Command::endCorrection, [this] { document_.endCorrection(true); });
  on(Command::leaveCorrection, [this] { document_.endCorrection(false); });
  on(Command::showOverTime, [this] { showOverTime(); });
  on(Command::carryOverTime, [this, &time] {
    showOverTime();
    if (time.isCarrying())
      time.cancel();
    else
      document_.carryOverTime();
  });
  on(Command::exportFrameMeshes, [this] { files_->exportFrames(false); });
  on(Command::exportFrameLabels, [this] { files_->exportFrames(true); });
  connect(overTime_, &OverTimePanel::saveRequested, files_, &FileWork::saveText);
  connect(export_, &ExportPanel::anonymousChanged, overTime_, &OverTimePanel::setAnonymous);
  for (auto changed : {&TimeSeries::shownChanged, &TimeSeries::wantedChanged, &TimeSeries::playingChanged,
                       &TimeSeries::carriedChanged, &TimeSeries::carryingChanged})
    connect(&time, changed, this, &MainWindow::updateTimeCommands);
  updateTimeCommands();
}

//! What the active object has grown to is meant to go, and what that is is seen; of others it is not.
void MainWindow::growHere() {
  TimeSeries& time = document_.time();
  time.play(false);
  const int frame = time.shownFrame();
  const QStringList lost = document_.lostElsewhere();
  const QString question =
      tr("These objects lose their surfaces, too, and undo does not bring them back: %1. Grow in this frame?")
          .arg(lost.join(tr(", ")));
  if (!lost.isEmpty() && !files_->isAgreed(tr("Grow in this frame"), question)) return;
  if (time.shownFrame() == frame) document_.growInShownFrame();  // one that was read meanwhile is another one
}

void MainWindow::updateTimeCommands() {
  const TimeSeries& time = document_.time();
  const bool open = document_.hasVolume() && time.hasTime();
  QAction* play = commands_[Command::playFrames];
  play->setEnabled(open);
  play->setText(time.isPlaying() ? tr("&Stop playing") : tr("&Play"));
  play->setIcon(icon(time.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
  commands_[Command::previousFrame]->setEnabled(open && time.wantedFrame() > 0);
  commands_[Command::nextFrame]->setEnabled(open && time.wantedFrame() < time.frameCount() - 1);
  commands_[Command::toGrownFrame]->setEnabled(open && time.wantedFrame() != time.grownFrame());
  const bool corrects = document_.correctedFrame().has_value();
  commands_[Command::growHere]->setEnabled(open && !corrects && !time.showsGrownFrame());
  commands_[Command::correctFrame]->setEnabled(open && document_.correctionFault().isEmpty());
  commands_[Command::endCorrection]->setEnabled(corrects);
  commands_[Command::leaveCorrection]->setEnabled(corrects);
  QAction* carry = commands_[Command::carryOverTime];
  carry->setEnabled(open && (time.isCarrying() || document_.carryFault().isEmpty()));
  carry->setText(time.isCarrying() ? tr("&Cancel") : tr("&Over time"));
  const bool whole = open && document_.framesFault().isEmpty();
  commands_[Command::exportFrameMeshes]->setEnabled(whole);
  commands_[Command::exportFrameLabels]->setEnabled(whole);
}

}  // namespace handlebody::ui
