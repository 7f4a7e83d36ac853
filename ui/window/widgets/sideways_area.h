#pragma once
// A panel that is scrolled sideways where the screen is narrower than its texts: else it would push the
// window out of the screen.

#include <QScrollArea>

namespace handlebody::ui {

class SidewaysArea : public QScrollArea {
 public:
  explicit SidewaysArea(QWidget* panel);

  QSize sizeHint() const override;
  //! As high as the panel must be.
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handlebody::ui
