#pragma once
// A panel that is scrolled where the screen is smaller than it needs: else it would push the window out of
// the screen, or be cut off.

#include <QScrollArea>

namespace handlebody::ui {

class PanelArea : public QScrollArea {
 public:
  explicit PanelArea(QWidget* panel);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handlebody::ui
