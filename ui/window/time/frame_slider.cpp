#include "ui/window/time/frame_slider.h"

#include <QMouseEvent>
#include <QPainter>

namespace handlebody::ui {

namespace {

const QColor kAccent(0x2E, 0x9E, 0x8F);  // another colour than the iterations'
constexpr double kHandle = 6;            // radius, pixels
constexpr double kMark = 3.2, kGrown = 5;

}  // namespace

QColor frameMarkColour(FrameMark mark) {
  switch (mark) {
    case FrameMark::failed:
      return {0xC8, 0x32, 0x32};
    case FrameMark::warned:
      return {0xE0, 0x8A, 0x1E};
    default:
      return {0x2E, 0x9E, 0x8F};
  }
}

FrameSlider::FrameSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Frame"));
  setToolTip(
      tr("<p>Time: the frames of the volume. A ring is the frame the surface is grown in, dots are frames it "
         "was carried to: orange with a warning, red where it failed. Click or drag to go there.</p>"));
}

void FrameSlider::setMarks(std::vector<FrameMark> marks) {
  marks_ = std::move(marks);
  update();
}

void FrameSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  setValue(axis().toIteration(event->position().x()));
}

void FrameSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) setValue(axis().toIteration(event->position().x()));
}

void FrameSlider::mouseReleaseEvent(QMouseEvent*) { setSliderDown(false); }

void FrameSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const TimelineAxis a = axis();
  if (a.last <= 0) return;
  const double y = height() / 2.0;
  QColor line = palette().color(QPalette::WindowText);
  line.setAlphaF(0.35F);
  painter.setPen(QPen(line, 2));
  painter.drawLine(QPointF(a.toX(0), y), QPointF(a.toX(a.last), y));
  constexpr double kMinApart = 5;  // pixels between ticks that are told apart
  if ((width() - 2 * TimelineAxis::kMargin) > kMinApart * a.last)
    for (int f = 0; f <= a.last; ++f) painter.drawLine(QPointF(a.toX(f), y - 4), QPointF(a.toX(f), y + 4));
  for (int f = 0; f < static_cast<int>(marks_.size()) && f <= a.last; ++f) {
    const FrameMark mark = marks_[f];
    if (mark == FrameMark::none) continue;
    const bool isGrown = mark == FrameMark::grown;
    painter.setPen(isGrown ? QPen(frameMarkColour(mark), 2) : Qt::NoPen);
    painter.setBrush(isGrown ? QBrush(palette().color(QPalette::Window)) : QBrush(frameMarkColour(mark)));
    const double radius = isGrown ? kGrown : kMark;
    painter.drawEllipse(QPointF(a.toX(f), y), radius, radius);
  }
  painter.setBrush(kAccent);
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.drawEllipse(QPointF(a.toX(value()), y), kHandle, kHandle);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
  painter.drawEllipse(QPointF(a.toX(value()), y), kHandle + 2, kHandle + 2);
}

}  // namespace handlebody::ui
