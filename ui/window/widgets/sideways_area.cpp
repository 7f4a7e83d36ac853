#include "ui/window/widgets/sideways_area.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace handlebody::ui {

SidewaysArea::SidewaysArea(QWidget* panel) {
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
  setWidget(panel);
}

QSize SidewaysArea::sizeHint() const { return widget()->sizeHint(); }

QSize SidewaysArea::minimumSizeHint() const {
  constexpr int kNarrowest = 300;  // pixels
  const QSize needed = widget()->minimumSizeHint();
  const int bar = horizontalScrollBar()->isVisible() ? horizontalScrollBar()->sizeHint().height() : 0;
  return {std::min(kNarrowest, needed.width()), needed.height() + bar};
}

bool SidewaysArea::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace handlebody::ui
