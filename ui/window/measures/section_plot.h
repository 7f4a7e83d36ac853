#pragma once
// Area and equivalent diameter of the sections across a centre line, against the way along it.

#include <QWidget>
#include <vector>

#include "core/measure/centre_line.h"

class QPainter;

namespace handlebody::ui {

//! Mouse: what is under it is pointed at, a click chooses it. Keys, with the focus: Left, Right (Shift: ten
//! at once), Home and End point, Return chooses.
class SectionPlot : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPlot(QWidget* parent = nullptr);

  void setLine(const CentreLine& line);
  const CentreLine& line() const { return line_; }
  int pointed() const { return pointed_; }  //!< index of a point of the line; -1: none
  void point(int index);

  QSize sizeHint() const override { return {400, 140}; }
  QSize minimumSizeHint() const override { return {220, 80}; }

 Q_SIGNALS:
  void pointedAt(int index);  //!< -1: none
  void chosen(int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QRectF area() const;
  double xOf(double along) const;
  int nearestTo(double x) const;
  void paintAxes(QPainter& painter, double mostArea, double mostDiameter) const;
  void paintPointed(QPainter& painter, double mostArea, double mostDiameter) const;

  CentreLine line_;
  int pointed_ = -1;
};

}  // namespace handlebody::ui
