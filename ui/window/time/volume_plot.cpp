#include "ui/window/time/volume_plot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "core/volume/anatomy.h"
#include "ui/model/document.h"
#include "ui/model/time_series.h"
#include "ui/window/time/frame_slider.h"
#include "ui/window/time/time_bar.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {

constexpr double kPlotTop = 22, kPlotBottom = 20, kLeft = 50, kRight = 22;  // pixels around the curve
constexpr double kRoom = 0.12;                                              // of the range, above and below

}  // namespace

VolumePlot::VolumePlot(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Volume over time"));
  TimeSeries& time = document_.time();
  const auto follow = [this, &time] {
    curve_ = time.curve();
    update();
  };
  connect(&time, &TimeSeries::carriedChanged, this, follow);
  connect(&document_, &Document::opened, this, follow);
  for (auto changed : {&TimeSeries::shownChanged, &TimeSeries::wantedChanged})
    connect(&time, changed, this, qOverload<>(&QWidget::update));
  connect(&document_, &Document::snapshotChanged, this, qOverload<>(&QWidget::update));
}

QRectF VolumePlot::area() const { return QRectF(rect()).adjusted(kLeft, kPlotTop, -kRight, -kPlotBottom); }

double VolumePlot::when(int frame) const { return document_.time().timeOf(frame).value_or(frame); }

double VolumePlot::xOf(int frame) const {
  const double first = when(0), last = when(std::max(1, document_.time().frameCount() - 1));
  return area().left() + area().width() * (when(frame) - first) / std::max(1e-9, last - first);
}

int VolumePlot::frameAt(const QPointF& pixel) const {
  int best = -1;
  for (int f = 0; f < document_.time().frameCount() && document_.time().hasTime(); ++f)
    if (best < 0 || std::abs(xOf(f) - pixel.x()) < std::abs(xOf(best) - pixel.x())) best = f;
  return best;
}

void VolumePlot::mousePressEvent(QMouseEvent* event) { mouseMoveEvent(event); }

void VolumePlot::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) && frameAt(event->position()) >= 0)
    document_.time().show(frameAt(event->position()));
}

void VolumePlot::keyPressEvent(QKeyEvent* event) {
  TimeSeries& time = document_.time();
  const int key = event->key();
  if (!time.hasTime()) return QWidget::keyPressEvent(event);
  if (key == Qt::Key_Left || key == Qt::Key_Right)
    time.show(time.wantedFrame() + (key == Qt::Key_Left ? -1 : 1));
  else if (key == Qt::Key_Home || key == Qt::Key_End)
    time.show(key == Qt::Key_Home ? 0 : time.frameCount() - 1);
  else
    QWidget::keyPressEvent(event);
}

//! Its keys are no shortcuts while it has the focus; the tip tells the point under the mouse.
bool VolumePlot::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Home || key == Qt::Key_End) {
      event->accept();
      return true;
    }
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int frame = frameAt(help->pos());
  for (const VolumePoint& p : curve_.points)
    if (p.frame == frame && p.volume)
      QToolTip::showText(help->globalPos(),
                         tr("%1: %2").arg(frameText(document_, frame), millilitres(*p.volume)));
  return true;
}

void VolumePlot::paintAxes(QPainter& painter, double least, double most) const {
  const QRectF a = area();
  const QColor text = palette().color(QPalette::WindowText);
  QColor faint = text;
  faint.setAlphaF(0.18F);
  const double tick = roundLength((most - least) / 2.5);
  for (double v = std::ceil(least / tick) * tick; v <= most; v += tick) {
    const double y = a.bottom() - a.height() * (v - least) / (most - least);
    painter.setPen(faint);
    painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0, y - 10, kLeft - 6, 20), Qt::AlignVCenter | Qt::AlignRight, number(v, 3));
  }
  const TimeSeries& time = document_.time();
  const bool isKnown = time.timeOf(0).has_value();
  const int last = time.frameCount() - 1;
  const int step = std::max(1, static_cast<int>(std::ceil(last * 60.0 / std::max(60.0, a.width()))));
  for (int f = 0; f <= last; f += step) {
    const QString label =
        number(when(f), 4) + (isKnown && f + step > last ? QStringLiteral(" ms") : QString());
    const double wide = painter.fontMetrics().horizontalAdvance(label) + 2.0;
    const double left = std::min(xOf(f) - wide / 2, width() - wide);
    painter.drawText(QRectF(left, a.bottom() + 2, wide, kPlotBottom - 2), Qt::AlignHCenter | Qt::AlignTop,
                     label);
  }
  const QRectF top(4, 0, width() - 8, kPlotTop);
  const QString title = isKnown ? tr("Volume (ml) over time (ms)") : tr("Volume (ml) over frames");
  const bool fits = painter.fontMetrics().horizontalAdvance(title) <= top.width();
  painter.drawText(top, Qt::AlignLeft | Qt::AlignVCenter, fits ? title : QStringLiteral("ml"));
}

void VolumePlot::paintPhase(QPainter& painter, const QPointF& at, const QString& text, bool isAbove) const {
  const double width = painter.fontMetrics().horizontalAdvance(text) + 4.0;
  const double x =
      std::clamp(at.x() - width / 2, area().left(), std::max(area().left(), this->width() - width - 2));
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(x, isAbove ? at.y() - 20 : at.y() + 4, width, 16), Qt::AlignCenter, text);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, 6, 6);
}

void VolumePlot::paintCurve(QPainter& painter, double least, double most) const {
  const QRectF a = area();
  const auto at = [&](const VolumePoint& p) {
    return QPointF(xOf(p.frame),
                   a.bottom() - a.height() * (*p.volume / kMillilitre - least) / (most - least));
  };
  const bool isCurrent = document_.isCarriedCurrent();
  QColor colour = frameMarkColour(FrameMark::carried);
  if (!isCurrent) colour.setAlphaF(0.45F);
  QPolygonF line;
  const auto draw = [&] {
    painter.setPen(QPen(colour, 1.8));
    painter.drawPolyline(line);
    line.clear();
  };
  int before = -2;
  for (const VolumePoint& p : curve_.points) {
    if (!line.isEmpty() && (!p.isTrusted || !p.volume || p.frame != before + 1)) draw();  // a gap
    if (p.isTrusted && p.volume) line << at(p);
    before = p.frame;
  }
  draw();
  painter.setPen(Qt::NoPen);
  for (const VolumePoint& p : curve_.points) {
    if (!p.volume) continue;
    painter.setBrush(p.isTrusted ? colour : frameMarkColour(FrameMark::failed));
    painter.drawEllipse(at(p), 3, 3);
  }
  if (curve_.endDiastole && isCurrent) {
    paintPhase(painter, at(curve_.points[*curve_.endDiastole]), tr("end-diastole"), true);
    paintPhase(painter, at(curve_.points[*curve_.endSystole]), tr("end-systole"), false);
  }
}

void VolumePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  double least = 1e300, most = 0;
  for (const VolumePoint& p : curve_.points)
    if (p.volume) {
      least = std::min(least, *p.volume / kMillilitre);
      most = std::max(most, *p.volume / kMillilitre);
    }
  if (!(most > 0) || curve_.points.size() < 2) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        QRectF(rect()).adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap,
        tr("The volume over time is plotted here when the surface is carried through the frames."));
  } else {
    const double room = std::max(kRoom * (most - least), 0.01 * most);
    least = std::max(0.0, least - 1.6 * room);
    most += 1.6 * room;
    paintAxes(painter, least, most);
    const QRectF a = area();
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    const double x = xOf(document_.time().wantedFrame());
    painter.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
    paintCurve(painter, least, most);
  }
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace handlebody::ui
