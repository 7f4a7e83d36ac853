#pragma once
// One line that is shortened in its middle where it does not fit; the tooltip says it whole.

#include <QLabel>

namespace handlebody::ui {

class ElidingLabel : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace handlebody::ui
