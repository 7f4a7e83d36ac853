#include "ui/window/widgets/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "ui/window/widgets/icons.h"

namespace handlebody::ui {

namespace {

void drawTick(QPainter& painter, const QRectF& box) {
  const auto at = [&](double x, double y) {
    return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
  };
  const QPointF tick[] = {at(0.24, 0.53), at(0.43, 0.71), at(0.77, 0.30)};
  painter.drawPolyline(tick, 3);
}

void drawCheckBox(const QStyleOption& option, QPainter& painter) {
  const QPalette& p = option.palette;
  const bool enabled = option.state & QStyle::State_Enabled, on = option.state & QStyle::State_On;
  const bool lit = enabled && on;
  QColor rim = p.color(QPalette::WindowText);
  rim.setAlphaF(enabled ? 0.6F : 0.3F);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(
      QPen(lit || (enabled && option.state & QStyle::State_MouseOver) ? p.color(QPalette::Highlight) : rim));
  painter.setBrush(p.color(lit ? QPalette::Highlight : QPalette::Base));
  painter.drawRoundedRect(box, 2, 2);
  if (on) {
    painter.setPen(QPen(p.color(lit ? QPalette::HighlightedText : QPalette::WindowText), box.width() / 8));
    drawTick(painter, box);
  }
  painter.restore();
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* answer) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  if (hint == SH_EtchDisabledText) return 0;  // a shadow that blurs it on dark ground
  return QProxyStyle::styleHint(hint, option, widget, answer);
}

QIcon WindowStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                                const QWidget* widget) const {
  switch (which) {
    case SP_MessageBoxInformation:
      return icon(QStringLiteral("info"));
    case SP_MessageBoxWarning:
      return icon(QStringLiteral("warning"));
    case SP_MessageBoxCritical:
      return icon(QStringLiteral("error"));
    case SP_MessageBoxQuestion:
      return icon(QStringLiteral("help"));
    case SP_TitleBarCloseButton:  // of the panels; those of Fusion are small pixmaps, blurred on a fine
                                  // screen
      return icon(QStringLiteral("close"));
    case SP_TitleBarNormalButton:
      return icon(QStringLiteral("float"));
    default:
      return QProxyStyle::standardIcon(which, option, widget);
  }
}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
  if (element == PE_IndicatorCheckBox)
    drawCheckBox(*option, *painter);
  else
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

// The row under the mouse has the colour of the icons' accents.
void WindowStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
  constexpr State kChosen = State_Selected | State_Enabled;
  if (element != CE_MenuItem || !item || item->icon.isNull() || (item->state & kChosen) != kChosen)
    return QProxyStyle::drawControl(element, option, painter, widget);
  const int size = pixelMetric(PM_SmallIconSize, option, widget);
  const double ratio = painter->device()->devicePixelRatioF();
  QStyleOptionMenuItem chosen = *item;
  chosen.icon = QIcon(item->icon.pixmap(QSize(size, size), ratio, QIcon::Selected));
  QProxyStyle::drawControl(element, &chosen, painter, widget);
}

}  // namespace handlebody::ui
