#include "ui/view/brush_picture.h"

#include <QLineF>
#include <QPolygonF>
#include <algorithm>

#include "ui/view/overlay.h"

namespace handlebody::ui {

namespace {

const QColor kShadow(0, 0, 0, 150), kWallRim(0xf4, 0xb8, 0xff), kEditRim(0xff, 0xf1, 0xc2);

bool takesAway(Brush::Mode mode) { return mode == Brush::Mode::eraseWalls || mode == Brush::Mode::unpin; }

QColor rimOf(Brush::Mode mode) {
  return takesAway(mode)                   ? QColor(Qt::white)
         : mode == Brush::Mode::paintWalls ? kWallRim
         : mode == Brush::Mode::pin        ? pinColour()
                                           : kEditRim;
}

void ring(QPainter& painter, const QPointF& centre, double radius, const QPen& pen) {
  painter.setPen(QPen(kShadow, pen.widthF() + 2));
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(pen);
  painter.drawEllipse(centre, radius, radius);
}

}  // namespace

void paintBrush(QPainter& painter, const QPointF& pixel, double radius, Brush::Mode mode, bool filled) {
  constexpr float kFill = 0.22F;
  const QColor rim = rimOf(mode);
  QColor fill = rim;
  fill.setAlphaF(kFill);
  if (filled) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawEllipse(pixel, radius, radius);
  }
  painter.setBrush(Qt::NoBrush);
  ring(painter, pixel, radius, QPen(rim, 1.6, takesAway(mode) ? Qt::DashLine : Qt::SolidLine));
}

void paintGrip(QPainter& painter, const QPointF& pixel) {
  constexpr double kGrip = 4.5;
  painter.setBrush(kEditRim);
  ring(painter, pixel, kGrip, QPen(QColor(0x30, 0x2a, 0x18), 1.2));
}

void paintPull(QPainter& painter, const QPointF& from, const QPointF& to, double radius) {
  constexpr double kHead = 10, kHalfHead = 4.5;
  painter.setBrush(Qt::NoBrush);
  ring(painter, from, radius, QPen(kEditRim, 1.2, Qt::DotLine));
  const QLineF way(from, to);
  if (way.length() >= 1) {
    const QPointF along = (to - from) / way.length(), across(-along.y(), along.x());
    const double head = std::min(kHead, way.length());
    const QPointF foot = to - head * along;
    painter.setPen(QPen(kShadow, 4.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, foot);
    painter.setPen(QPen(kEditRim, 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, foot);
    painter.setPen(QPen(kShadow, 1));
    painter.setBrush(kEditRim);
    painter.drawPolygon(QPolygonF{to, foot + kHalfHead * across, foot - kHalfHead * across});
  }
  paintGrip(painter, from);
}

void paintCut(QPainter& painter, const QPointF& from, const QPointF& to) {
  painter.setPen(QPen(kShadow, 4, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setPen(QPen(kEditRim, 1.8, Qt::DashLine, Qt::RoundCap));
  painter.drawLine(from, to);
  paintGrip(painter, from);
  paintGrip(painter, to);
}

}  // namespace handlebody::ui
