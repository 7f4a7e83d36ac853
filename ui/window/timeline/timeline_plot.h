#pragma once
// Volume and moving share over the iterations.

#include <QWidget>
#include <vector>

#include "ui/model/document.h"
#include "ui/window/timeline/timeline_axis.h"

class QPainter;

namespace handlebody::ui {

class TimelinePlot : public QWidget {
  Q_OBJECT

 public:
  explicit TimelinePlot(Document& document, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {400, 110}; }
  QSize minimumSizeHint() const override { return {160, 60}; }

 Q_SIGNALS:
  void iterationChosen(int iteration);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  TimelineAxis axis() const;
  QRectF area() const;
  void paintCurve(QPainter& painter, double most, double IterationSummary::*number,
                  const QColor& colour) const;
  void paintChanges(QPainter& painter) const;
  void paintLegend(QPainter& painter, double mostVolume) const;

  Document& document_;
};

}  // namespace handlebody::ui
