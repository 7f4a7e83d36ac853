#include "ui/window/timeline/timeline_plot.h"

#include <QEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>

#include "ui/model/finding_text.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {

const QColor kVolume(0x3B, 0x82, 0xC4), kMoving(0xE0, 0x8A, 0x1E), kLeak(0xC8, 0x32, 0x32),
    kChange(0x9B, 0x59, 0xD0);
constexpr double kTracksTop = 18;  // pixels for the legend
constexpr double kEventMark = 5;   // pixels, half of the width of a mark
constexpr int kKey = 20;           // pixels that an entry of the legend takes besides its text
constexpr int kApart = 12;         // pixels between two entries

double mostVolume(const std::vector<IterationSummary>& summaries) {
  double most = 0;
  for (const IterationSummary& s : summaries) most = std::max(most, s.volume);
  return most > 0 ? most : 1;
}

QString leakText(const Document& document, int iteration) {
  for (const FoundLeak& found : document.leaks())
    if (found.leak.iteration == iteration)
      return QLatin1Char('\n') + TimelinePlot::tr("Leak: %1").arg(findingText(findingOf(found.leak)));
  return {};
}

//! A mark covers some iterations beside its own.
QString changesText(const Document& document, const TimelineAxis& axis, int iteration) {
  QString text;
  for (const ChangeMark& mark : document.changeMarks())
    if (std::abs(axis.toX(mark.iteration) - axis.toX(iteration)) <= kEventMark)
      text +=
          QLatin1Char('\n') + TimelinePlot::tr("Changed at %1: %2")
                                  .arg(QString::number(mark.iteration), mark.what.join(QStringLiteral(", ")));
  return text;
}

}  // namespace

TimelinePlot::TimelinePlot(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setAccessibleName(tr("Volume and moving share over the iterations"));
  for (auto changed : {&Document::snapshotChanged, &Document::summariesChanged, &Document::stateChanged})
    connect(&document_, changed, this, qOverload<>(&QWidget::update));
}

TimelineAxis TimelinePlot::axis() const { return {width(), std::max(0, document_.lastIteration())}; }

QRectF TimelinePlot::area() const {
  return QRectF(rect()).adjusted(TimelineAxis::kMargin, kTracksTop, -TimelineAxis::kMargin, -4);
}

void TimelinePlot::mousePressEvent(QMouseEvent* event) { mouseMoveEvent(event); }

void TimelinePlot::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) && document_.lastIteration() >= 0)
    Q_EMIT iterationChosen(axis().toIteration(event->position().x()));
}

bool TimelinePlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || document_.summaries().empty()) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto i = static_cast<std::size_t>(axis().toIteration(help->pos().x()));
  const IterationSummary& s = document_.summaries()[std::min(i, document_.summaries().size() - 1)];
  QToolTip::showText(help->globalPos(),
                     tr("Iteration %1: %2, %3 % of the vertices moving, %4")
                             .arg(QString::number(s.iteration), millilitres(s.volume),
                                  number(100 * s.movingShare, 2), tr("events: %1").arg(s.events)) +
                         leakText(document_, s.iteration) + changesText(document_, axis(), s.iteration));
  return true;
}

void TimelinePlot::paintCurve(QPainter& painter, double most, double IterationSummary::*number,
                              const QColor& colour) const {
  const std::vector<IterationSummary>& summaries = document_.summaries();
  const TimelineAxis a = axis();
  QPolygonF line;
  for (const IterationSummary& s : summaries)
    line << QPointF(a.toX(s.iteration), area().bottom() - area().height() * (s.*number) / most);
  painter.setPen(QPen(colour, 1.6));
  painter.drawPolyline(line);
}

//! A triangle on the lower rim for each.
void TimelinePlot::paintChanges(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(kChange);
  const double bottom = area().bottom();
  for (const ChangeMark& mark : document_.changeMarks()) {
    const double x = axis().toX(mark.iteration);
    painter.drawPolygon(
        QPolygonF{{x - kEventMark, bottom}, {x + kEventMark, bottom}, {x, bottom - 1.6 * kEventMark}});
  }
  painter.setBrush(Qt::NoBrush);
}

//! Side by side; where it is narrow the second gives way.
void TimelinePlot::paintLegend(QPainter& painter, double most) const {
  const int room = width() - 2 * TimelineAxis::kMargin;
  const QFontMetrics metrics = painter.fontMetrics();
  const auto elided = [&](const QString& text, int widest) {
    return metrics.elidedText(text, Qt::ElideRight, std::max(0, widest));
  };
  const auto entry = [&](const QString& text, const QColor& colour, int x) {
    painter.setPen(QPen(colour, 3));
    painter.drawLine(QPointF(x, kTracksTop / 2), QPointF(x + 12, kTracksTop / 2));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(x + 18, 0, room, kTracksTop), Qt::AlignLeft | Qt::AlignVCenter, text);
  };
  const QString volume = elided(tr("Volume, up to %1").arg(millilitres(most)), room - kKey);
  entry(volume, kVolume, TimelineAxis::kMargin);
  const int left = room - metrics.horizontalAdvance(volume) - 2 * kKey - kApart;
  const QString moving = elided(tr("Moving, 0 to 100 %"), left);
  constexpr int kFewest = 5;  // letters; fewer say nothing, and the tip has it
  if (moving.size() >= kFewest)
    entry(moving, kMoving, width() - TimelineAxis::kMargin - kKey - metrics.horizontalAdvance(moving));
}

void TimelinePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area(), palette().color(QPalette::Base));
  if (document_.summaries().empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Volume and motion are plotted here while the surface grows."));
    return;
  }
  const TimelineAxis a = axis();
  QColor faint = kMoving;
  faint.setAlphaF(0.45F);
  painter.setPen(QPen(faint, 1));
  for (const IterationSummary& s : document_.summaries())
    if (s.events > 0)
      painter.drawLine(QPointF(a.toX(s.iteration), kTracksTop), QPointF(a.toX(s.iteration), area().bottom()));
  painter.setPen(QPen(kLeak, 2, Qt::DashLine));
  for (const FoundLeak& found : document_.leaks()) {
    const double x = a.toX(found.leak.iteration);
    painter.drawLine(QPointF(x, kTracksTop), QPointF(x, area().bottom()));
  }
  const double most = mostVolume(document_.summaries());
  paintCurve(painter, 1, &IterationSummary::movingShare, kMoving);
  paintCurve(painter, most, &IterationSummary::volume, kVolume);
  paintChanges(painter);
  if (document_.iteration() >= 0) {
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    const double x = a.toX(document_.iteration());
    painter.drawLine(QPointF(x, kTracksTop), QPointF(x, area().bottom()));
  }
  paintLegend(painter, most);
}

}  // namespace handlebody::ui
