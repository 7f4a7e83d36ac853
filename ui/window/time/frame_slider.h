#pragma once
// A slider over the frames of a 4D volume, with what has become of each; a click goes straight there.

#include <QSlider>
#include <vector>

#include "ui/window/timeline/timeline_axis.h"

namespace handlebody::ui {

//! What a frame is marked as.
enum class FrameMark {
  none,     //!< not carried to
  grown,    //!< the surface is grown there
  carried,  //!< there is a surface
  warned,   //!< the same, with a warning
  failed
};

QColor frameMarkColour(FrameMark mark);

class FrameSlider : public QSlider {
  Q_OBJECT

 public:
  explicit FrameSlider(QWidget* parent = nullptr);

  //! One for each frame.
  void setMarks(std::vector<FrameMark> marks);
  QSize sizeHint() const override { return {300, 26}; }
  QSize minimumSizeHint() const override { return {120, 26}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  TimelineAxis axis() const { return {width(), maximum()}; }

  std::vector<FrameMark> marks_;
};

}  // namespace handlebody::ui
