#pragma once
// A slider over the iterations with a mark per event; a click goes straight there.

#include <QSlider>
#include <vector>

#include "ui/window/timeline/timeline_axis.h"

namespace handlebody::ui {

class TimelineSlider : public QSlider {
  Q_OBJECT

 public:
  explicit TimelineSlider(QWidget* parent = nullptr);

  //! Iterations with a change of topology, and those in which places were rolled back; ascending.
  void setMarks(std::vector<int> changes, std::vector<int> rollBacks);
  QSize sizeHint() const override { return {300, 26}; }
  QSize minimumSizeHint() const override { return {120, 26}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  TimelineAxis axis() const { return {width(), maximum()}; }

  std::vector<int> changes_, rollBacks_;
};

}  // namespace handlebody::ui
