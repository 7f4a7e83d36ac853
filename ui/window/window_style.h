#pragma once
// Fusion, but for the check boxes: Fusion takes the outline from the window's colour, which on a dark ground
// cannot be seen.

#include <QProxyStyle>

namespace handlebody::ui {

class WindowStyle : public QProxyStyle {
  Q_OBJECT

 public:
  WindowStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace handlebody::ui
