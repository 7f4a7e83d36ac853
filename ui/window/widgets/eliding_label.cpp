#include "ui/window/widgets/eliding_label.h"

#include <QPainter>

namespace handlebody::ui {

QSize ElidingLabel::minimumSizeHint() const { return {40, QLabel::minimumSizeHint().height()}; }

void ElidingLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(text(), Qt::ElideMiddle, width()));
}

}  // namespace handlebody::ui
