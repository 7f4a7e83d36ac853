#include "ui/window/measures/section_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/volume/anatomy.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {

const QColor kArea(0x3B, 0x82, 0xC4), kDiameter(0xE0, 0x8A, 0x1E);
constexpr double kTop = 20, kBottom = 20, kSide = 54;  // pixels around the curves

//! A round number of at least a fifth of the range, between ticks.
double tickOf(double most) { return most > 0 ? roundLength(most / 2.5) : 1; }

double mostOf(const CentreLine& line, bool isArea) {
  double most = 0;
  for (const CentreLinePoint& p : line.points)
    most = std::max(most, isArea ? p.area.value_or(0) : p.equivalentDiameter());
  return most > 0 ? 1.08 * most : 1;
}

double valueOf(const CentreLinePoint& p, bool isArea) { return isArea ? *p.area : p.equivalentDiameter(); }

}  // namespace

SectionPlot::SectionPlot(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Area and equivalent diameter along the centre line"));
}

void SectionPlot::setLine(const CentreLine& line) {
  line_ = line;
  pointed_ = -1;
  update();
}

QRectF SectionPlot::area() const { return QRectF(rect()).adjusted(kSide, kTop, -kSide, -kBottom); }

double SectionPlot::xOf(double along) const {
  return area().left() + area().width() * (line_.length > 0 ? along / line_.length : 0);
}

int SectionPlot::nearestTo(double x) const {
  int best = -1;
  for (int i = 0; i < static_cast<int>(line_.points.size()); ++i) {
    const auto away = [&](int j) { return std::abs(xOf(line_.points[j].along) - x); };
    if (best < 0 || away(i) < away(best)) best = i;
  }
  return best;
}

void SectionPlot::point(int index) {
  index = std::clamp(index, -1, static_cast<int>(line_.points.size()) - 1);
  if (index == pointed_) return;
  pointed_ = index;
  update();
  Q_EMIT pointedAt(index);
}

void SectionPlot::mouseMoveEvent(QMouseEvent* event) {
  point(nearestTo(event->position().x()));
  if ((event->buttons() & Qt::LeftButton) && pointed_ >= 0) Q_EMIT chosen(pointed_);
}

void SectionPlot::mousePressEvent(QMouseEvent* event) {
  point(nearestTo(event->position().x()));
  if (event->button() == Qt::LeftButton && pointed_ >= 0) Q_EMIT chosen(pointed_);
}

void SectionPlot::leaveEvent(QEvent*) {
  if (!hasFocus()) point(-1);
}

void SectionPlot::focusOutEvent(QFocusEvent*) {
  if (!underMouse()) point(-1);
  update();
}

//! Its keys are no shortcuts while it has the focus.
bool SectionPlot::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !line_.points.empty()) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Home || key == Qt::Key_End) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void SectionPlot::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(line_.points.size()) - 1;
  const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
  const int key = event->key();
  if (last < 0) return QWidget::keyPressEvent(event);
  if (key == Qt::Key_Left)
    point(std::max(0, pointed_ - step));
  else if (key == Qt::Key_Right)
    point(pointed_ + step);
  else if (key == Qt::Key_Home)
    point(0);
  else if (key == Qt::Key_End)
    point(last);
  else if ((key == Qt::Key_Return || key == Qt::Key_Enter) && pointed_ >= 0)
    Q_EMIT chosen(pointed_);
  else
    QWidget::keyPressEvent(event);
}

void SectionPlot::paintAxes(QPainter& painter, double mostArea, double mostDiameter) const {
  const QRectF a = area();
  const QColor text = palette().color(QPalette::WindowText);
  QColor faint = text;
  faint.setAlphaF(0.18F);
  const auto vertical = [&](double most, const QColor& colour, bool isLeft) {
    const double tick = tickOf(most);
    for (double v = 0; v <= most; v += tick) {
      const double y = a.bottom() - a.height() * v / most;
      painter.setPen(faint);
      if (isLeft) painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
      painter.setPen(colour);
      const QRectF place(isLeft ? 0 : a.right() + 6, y - 10, kSide - 6, 20);
      painter.drawText(place, Qt::AlignVCenter | (isLeft ? Qt::AlignRight : Qt::AlignLeft), number(v, 3));
    }
  };
  vertical(mostArea, kArea.lighter(palette().color(QPalette::Window).lightness() < 128 ? 140 : 90), true);
  vertical(mostDiameter, kDiameter.darker(palette().color(QPalette::Window).lightness() < 128 ? 90 : 125),
           false);
  painter.setPen(text);
  const double tick = tickOf(line_.length);
  for (double v = 0; v <= line_.length; v += tick)
    painter.drawText(QRectF(xOf(v) - 40, a.bottom() + 2, 80, kBottom - 2), Qt::AlignHCenter | Qt::AlignTop,
                     number(v, 3) + (v + tick > line_.length ? tr(" mm") : QString()));
  const auto legend = [&](const QString& words, const QColor& colour, bool isLeft) {
    const double width = painter.fontMetrics().horizontalAdvance(words) + 20;
    const double x = isLeft ? a.left() : a.right() - width;
    painter.setPen(QPen(colour, 3));
    painter.drawLine(QPointF(x, kTop / 2), QPointF(x + 12, kTop / 2));
    painter.setPen(text);
    painter.drawText(QRectF(x + 18, 0, width, kTop), Qt::AlignLeft | Qt::AlignVCenter, words);
  };
  legend(tr("Area (mm²)"), kArea, true);
  legend(tr("Equivalent diameter (mm)"), kDiameter, false);
}

void SectionPlot::paintPointed(QPainter& painter, double mostArea, double mostDiameter) const {
  if (pointed_ < 0) return;
  const QRectF a = area();
  const CentreLinePoint& p = line_.points[pointed_];
  const double x = xOf(p.along);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  painter.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
  if (!p.area) return;
  painter.setPen(Qt::NoPen);
  for (const bool isArea : {true, false}) {
    const double y = a.bottom() - a.height() * valueOf(p, isArea) / (isArea ? mostArea : mostDiameter);
    painter.setBrush(isArea ? kArea : kDiameter);
    painter.drawEllipse(QPointF(x, y), 3.5, 3.5);
  }
  painter.setBrush(Qt::NoBrush);
}

void SectionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (line_.points.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(rect()).adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Area and equivalent diameter are plotted here along the line."));
    return;
  }
  const double mostArea = mostOf(line_, true), mostDiameter = mostOf(line_, false);
  paintAxes(painter, mostArea, mostDiameter);
  const QRectF a = area();
  for (const bool isArea : {true, false}) {
    painter.setPen(QPen(isArea ? kArea : kDiameter, 1.8));
    QPolygonF part;
    const auto draw = [&] {
      painter.drawPolyline(part);
      part.clear();
    };
    for (const CentreLinePoint& p : line_.points) {
      if (p.area)
        part << QPointF(xOf(p.along),
                        a.bottom() - a.height() * valueOf(p, isArea) / (isArea ? mostArea : mostDiameter));
      else
        draw();  // a gap where there is no section
    }
    draw();
  }
  paintPointed(painter, mostArea, mostDiameter);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

}  // namespace handlebody::ui
