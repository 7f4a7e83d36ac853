#include "ui/window/timeline/timeline_slider.h"

#include <QMouseEvent>
#include <QPainter>

namespace handlebody::ui {

namespace {
const QColor kSliderAccent(0x3B, 0x82, 0xC4), kRolledBack(0xC2, 0x41, 0x3B);
constexpr double kTickMark = 4;    // half the diagonal of the mark of a change, pixels
constexpr double kStroke = 5;      // height of the mark of what was rolled back, below the line
constexpr double kHandleSize = 6;  // radius
}  // namespace

TimelineSlider::TimelineSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setPageStep(10);
  setAccessibleName(tr("Iteration"));
  setToolTip(tr(
      "<p>Iterations; diamonds are changes of topology, strokes below the line places that were rolled back. "
      "Click or drag to go there.</p>"));
}

void TimelineSlider::setMarks(std::vector<int> changes, std::vector<int> rollBacks) {
  changes_ = std::move(changes);
  rollBacks_ = std::move(rollBacks);
  update();
}

void TimelineSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  setValue(axis().toIteration(event->position().x()));
}

void TimelineSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) setValue(axis().toIteration(event->position().x()));
}

void TimelineSlider::mouseReleaseEvent(QMouseEvent*) { setSliderDown(false); }

void TimelineSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const TimelineAxis a = axis();
  if (a.last <= 0) return;  // nothing to choose from yet
  const double y = height() / 2.0;
  QColor line = palette().color(QPalette::WindowText);
  line.setAlphaF(0.35F);
  painter.setPen(QPen(line, 2));
  painter.drawLine(QPointF(a.toX(0), y), QPointF(a.toX(a.last), y));
  painter.setPen(QPen(kSliderAccent, 2));
  painter.drawLine(QPointF(a.toX(0), y), QPointF(a.toX(value()), y));

  painter.setPen(QPen(kRolledBack, 1.5));
  for (int mark : rollBacks_)
    painter.drawLine(QPointF(a.toX(mark), y + 2), QPointF(a.toX(mark), y + 2 + kStroke));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0xE0, 0x8A, 0x1E));
  for (int mark : changes_) {
    const QPointF centre(a.toX(mark), y);
    const QPointF diamond[] = {centre + QPointF(0, -kTickMark - 1), centre + QPointF(kTickMark, 0),
                               centre + QPointF(0, kTickMark + 1), centre + QPointF(-kTickMark, 0)};
    painter.drawPolygon(diamond, 4);
  }
  painter.setBrush(kSliderAccent);
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.drawEllipse(QPointF(a.toX(value()), y), kHandleSize, kHandleSize);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
  painter.drawEllipse(QPointF(a.toX(value()), y), kHandleSize + 2, kHandleSize + 2);
}

}  // namespace handlebody::ui
