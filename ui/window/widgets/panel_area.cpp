#include "ui/window/widgets/panel_area.h"

#include <QEvent>

namespace handlebody::ui {

PanelArea::PanelArea(QWidget* panel) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
  setWidget(panel);
}

QSize PanelArea::sizeHint() const { return widget()->sizeHint(); }

QSize PanelArea::minimumSizeHint() const {
  constexpr QSize kSmallest(300, 180);  // pixels
  return widget()->minimumSizeHint().boundedTo(kSmallest);
}

bool PanelArea::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace handlebody::ui
