#include "ui/window/tune/histogram_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/view/view_state.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

namespace {

constexpr int kHistogramSide = 10;  // pixels left and right for the handles
constexpr int kLabels = 18;         // pixels under the bars
constexpr double kReach = 9;        // pixels beside a handle that still grip it
const QColor kHistogramAccent(0x3B, 0x82, 0xC4);

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Histogram with the object's range"));
  setToolTip(
      tr("<p>How often each intensity occurs (square root). Drag the ends of the object's range; with the "
         "keyboard: Up and Down choose an end, Left and Right move it.</p>"));
}

void HistogramView::setHistogram(const Histogram& histogram) {
  histogram_ = histogram;
  update();
}

void HistogramView::setRange(const std::optional<IntensityRange>& range, bool automatic) {
  range_ = range;
  automatic_ = automatic;
  describeRange();
  update();
}

void HistogramView::describeRange() {
  setAccessibleDescription(range_ ? tr("From %1 to %2").arg(fineNumber(range_->low), fineNumber(range_->high))
                                  : tr("No range yet"));
}

QRectF HistogramView::area() const {
  return QRectF(rect()).adjusted(kHistogramSide, 4, -kHistogramSide, -kLabels);
}

double HistogramView::toX(double intensity) const {
  const double share = (intensity - histogram_.low) / (histogram_.high - histogram_.low);
  return area().left() + std::clamp(share, 0.0, 1.0) * area().width();
}

double HistogramView::toIntensity(double x) const {
  const double share = std::clamp((x - area().left()) / area().width(), 0.0, 1.0);
  return histogram_.low + share * (histogram_.high - histogram_.low);
}

double HistogramView::valueOf(End end) const { return end == End::low ? range_->low : range_->high; }

HistogramView::End HistogramView::endAt(double x) const {
  if (!range_ || histogram_.counts.empty()) return End::none;
  const double low = std::abs(x - toX(range_->low)), high = std::abs(x - toX(range_->high));
  if (std::min(low, high) > kReach) return End::none;
  return low <= high ? End::low : End::high;
}

void HistogramView::moveEnd(double intensity, int gesture) {
  if (!range_ || active_ == End::none) return;
  IntensityRange range = *range_;
  const double step = (histogram_.high - histogram_.low) / 200;
  const double rounded = std::round(intensity / std::pow(10, std::floor(std::log10(step)))) *
                         std::pow(10, std::floor(std::log10(step)));
  if (active_ == End::low)
    range.low = std::min(rounded, range.high);
  else
    range.high = std::max(rounded, range.low);
  setRange(range, false);
  Q_EMIT rangeEdited(range, gesture);
}

void HistogramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  active_ = endAt(event->position().x());
  dragging_ = active_ != End::none;
  gesture_ = ViewState::nextGesture();
  update();
}

void HistogramView::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_)
    moveEnd(toIntensity(event->position().x()), gesture_);
  else
    setCursor(endAt(event->position().x()) == End::none ? Qt::ArrowCursor : Qt::SizeHorCursor);
}

void HistogramView::mouseReleaseEvent(QMouseEvent*) { dragging_ = false; }

void HistogramView::keyPressEvent(QKeyEvent* event) {
  const int direction = (event->key() == Qt::Key_Right) - (event->key() == Qt::Key_Left);
  if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
    active_ = event->key() == Qt::Key_Up ? End::high : End::low;
    update();
  } else if (direction != 0 && range_ && !histogram_.counts.empty()) {
    if (active_ == End::none) active_ = End::high;
    const double step = (histogram_.high - histogram_.low) / 200;
    const double from = std::clamp(valueOf(active_), histogram_.low, histogram_.high);
    moveEnd(from + direction * step, gestureOf(this));
  } else {
    QWidget::keyPressEvent(event);
  }
}

void HistogramView::paintBars(QPainter& painter) const {
  if (histogram_.counts.empty()) return;
  const QRectF a = area();
  const double most = std::sqrt(*std::max_element(histogram_.counts.begin(), histogram_.counts.end()));
  const double width = a.width() / static_cast<double>(histogram_.counts.size());
  QPainterPath path(a.bottomLeft());
  for (std::size_t i = 0; i < histogram_.counts.size(); ++i) {
    const double top = a.bottom() - a.height() * std::sqrt(histogram_.counts[i]) / std::max(most, 1.0);
    path.lineTo(a.left() + width * static_cast<double>(i), top);
    path.lineTo(a.left() + width * static_cast<double>(i + 1), top);
  }
  path.lineTo(a.bottomRight());
  QColor colour = palette().color(QPalette::WindowText);
  colour.setAlphaF(isEnabled() ? 0.5F : 0.2F);
  painter.fillPath(path, colour);
}

void HistogramView::paintEnd(QPainter& painter, End end) const {
  const double x = toX(valueOf(end));
  painter.setPen(QPen(kHistogramAccent, active_ == end && hasFocus() ? 3 : 2,
                      automatic_ ? Qt::DashLine : Qt::SolidLine));
  painter.drawLine(QPointF(x, area().top()), QPointF(x, area().bottom()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kHistogramAccent);
  painter.drawEllipse(QPointF(x, area().bottom()), 4.5, 4.5);
}

void HistogramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area(), palette().color(QPalette::Base));
  if (histogram_.counts.empty()) return;
  if (range_) {
    QColor shade = kHistogramAccent;
    shade.setAlphaF(0.22F);
    painter.fillRect(
        QRectF(QPointF(toX(range_->low), area().top()), QPointF(toX(range_->high), area().bottom())), shade);
  }
  paintBars(painter);
  if (range_)
    for (End end : {End::low, End::high}) paintEnd(painter, end);
  painter.setPen(palette().color(QPalette::WindowText));
  const QRectF labels(area().left(), area().bottom() + 4, area().width(), kLabels - 4);
  painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter,
                   fineNumber(histogram_.whole ? std::ceil(histogram_.low) : histogram_.low, 3));
  painter.drawText(labels, Qt::AlignRight | Qt::AlignVCenter,
                   fineNumber(histogram_.whole ? std::floor(histogram_.high) : histogram_.high, 3));
}

}  // namespace handlebody::ui
