#pragma once
// The volume of the surface over time, with end-diastole and end-systole; a click goes to the frame.

#include <QWidget>

#include "core/sequence/volume_curve.h"

class QPainter;

namespace handlebody::ui {

class Document;

//! Keys, with the focus: Left and Right, Home and End go to other frames.
class VolumePlot : public QWidget {
  Q_OBJECT

 public:
  explicit VolumePlot(Document& document, QWidget* parent = nullptr);

  //! The frame whose point is nearest; -1: there is none.
  int frameAt(const QPointF& pixel) const;

  QSize sizeHint() const override { return {420, 150}; }
  QSize minimumSizeHint() const override { return {140, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;
  double when(int frame) const;  //!< ms; the number of the frame where no time is known
  double xOf(int frame) const;
  void paintAxes(QPainter& painter, double least, double most) const;
  void paintCurve(QPainter& painter, double least, double most) const;
  void paintPhase(QPainter& painter, const QPointF& at, const QString& text, bool isAbove) const;

  Document& document_;
  VolumeCurve curve_;
};

}  // namespace handlebody::ui
