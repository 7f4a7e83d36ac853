#pragma once
// Fusion, but for the check boxes, whose outline Fusion takes from the window's colour, so that on a dark
// ground it cannot be seen; for the icons in the chosen row of a menu; and for the pictures in dialogs, which
// are of another age.

#include <QProxyStyle>

namespace handlebody::ui {

class WindowStyle : public QProxyStyle {
  Q_OBJECT

 public:
  WindowStyle();

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override;
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
};

}  // namespace handlebody::ui
