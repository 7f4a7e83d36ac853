#include "ui/window/time/time_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/model/time_series.h"
#include "ui/window/commands.h"
#include "ui/window/time/frame_slider.h"
#include "ui/window/widgets/eliding_label.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

FrameMark markOf(const TimeSeries& time, int frame) {
  if (frame == time.grownFrame()) return FrameMark::grown;
  const FrameResult* result = time.resultOf(frame);
  if (!result) return FrameMark::none;
  if (!result->isTrusted()) return FrameMark::failed;
  return result->faults.empty() ? FrameMark::carried : FrameMark::warned;
}

}  // namespace

QString frameText(const Document& document, int frame) {
  const TimeSeries& time = document.time();
  const QString text = TimeBar::tr("Frame %1 of 0–%2").arg(frame).arg(time.frameCount() - 1);
  const auto when = time.timeOf(frame);
  return when ? TimeBar::tr("%1, %2 ms").arg(text, number(*when)) : text;
}

QString outOfDateText(const Document& document) {
  return TimeBar::tr("The surface here was carried from an earlier state of frame %1: carry it again.")
      .arg(document.time().grownFrame());
}

TimeBar::TimeBar(Document& document, const Commands& commands, QWidget* parent)
    : QWidget(parent),
      document_(document),
      slider_(new FrameSlider(this)),
      text_(new QLabel(this)),
      fault_(new ElidingLabel(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 0);
  row->setSpacing(2);
  for (const Command id : {Command::playFrames, Command::previousFrame, Command::nextFrame})
    row->addWidget(smallButton(commands[id], this));
  row->addWidget(slider_, 3);
  text_->setAccessibleName(tr("Shown frame"));
  text_->setContentsMargins(6, 0, 6, 0);
  row->addWidget(text_);
  fault_->setAccessibleName(tr("What is wrong with the shown frame"));
  row->addWidget(fault_, 2);
  TimeSeries& time = document_.time();
  connect(slider_, &QSlider::valueChanged, this, [&time](int frame) { time.show(frame); });
  for (auto changed : {&TimeSeries::shownChanged, &TimeSeries::wantedChanged})
    connect(&time, changed, this, &TimeBar::showTime);
  connect(&time, &TimeSeries::carriedChanged, this, &TimeBar::showMarks);
  connect(&document_, &Document::opened, this, &TimeBar::showTime);
  connect(&document_, &Document::snapshotChanged, this, &TimeBar::showMarks);
  showTime();
}

void TimeBar::showTime() {
  const TimeSeries& time = document_.time();
  setVisible(time.hasTime());
  if (!time.hasTime()) return;
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, time.frameCount() - 1);
  slider_->setValue(time.wantedFrame());
  // As wide for every frame, so that the slider does not move under the mouse.
  const int last = time.frameCount() - 1;
  text_->setText(frameText(document_, last));
  text_->setMinimumWidth(std::max(text_->minimumWidth(), text_->sizeHint().width() + 12));
  text_->setText(frameText(document_, time.wantedFrame()));
  showMarks();
}

void TimeBar::showMarks() {
  const TimeSeries& time = document_.time();
  if (!time.hasTime()) return;
  std::vector<FrameMark> marks;
  for (int f = 0; f < time.frameCount(); ++f) marks.push_back(markOf(time, f));
  slider_->setMarks(std::move(marks));
  QString why = time.error();
  if (why.isEmpty() && document_.isShownOutOfDate()) why = outOfDateText(document_);
  if (const FrameResult* result = time.resultOf(time.shownFrame()); why.isEmpty() && result)
    for (const ToldFault& f : result->faults)
      why += (why.isEmpty() ? QString() : QStringLiteral("; ")) + findingText(f.finding);
  if (why.isEmpty() && time.wantedFrame() != time.shownFrame())
    why = tr("Reading…");
  else if (why.isEmpty() && time.showsGrownFrame())
    why = tr("The surface is grown in this frame");
  else if (why.isEmpty() && !time.resultOf(time.shownFrame()) && time.carriedFrom())
    why = tr("The surface has not been carried here");
  fault_->setText(why);
  fault_->setToolTip(why.toHtmlEscaped());
}

}  // namespace handlebody::ui
