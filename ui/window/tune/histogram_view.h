#pragma once
// The histogram with the object's range on it; both ends can be dragged, or moved with the keyboard.

#include <QWidget>
#include <optional>

#include "core/evolution/parameters.h"
#include "ui/window/tune/histogram.h"

class QPainter;

namespace handlebody::ui {

class HistogramView : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramView(QWidget* parent = nullptr);

  //! Without counts nothing is drawn, and no end can be moved.
  void setHistogram(const Histogram& histogram);
  const Histogram& histogram() const { return histogram_; }
  //! `automatic`: it was chosen by the program (drawn with dashed ends). None: nothing is known yet.
  void setRange(const std::optional<IntensityRange>& range, bool automatic);
  //! What the mouse has hold of is let go.
  void endDrag() { dragging_ = false; }
  QSize sizeHint() const override { return {260, 120}; }
  QSize minimumSizeHint() const override { return {160, 100}; }

 Q_SIGNALS:
  void rangeEdited(const handlebody::IntensityRange& range, int gesture);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class End { none, low, high };
  QRectF area() const;
  double toX(double intensity) const;
  double toIntensity(double x) const;
  double valueOf(End end) const;
  End endAt(double x) const;
  void moveEnd(double intensity, int gesture);
  void paintBars(QPainter& painter) const;
  void paintEnd(QPainter& painter, End end) const;
  void describeRange();

  Histogram histogram_;
  std::optional<IntensityRange> range_;
  bool automatic_ = true;
  End active_ = End::none;
  int gesture_ = -1;
  bool dragging_ = false;
};

}  // namespace handlebody::ui
