#pragma once
// Internal: what mouse and keys do in a slice while the tool that measures is on, or over the end of a
// measurement.

#include <QObject>

#include "ui/view/measurement_drag.h"

class QKeyEvent;
class QMouseEvent;
class QWidget;

namespace handlebody::ui {

class ViewState;

//! Filters the events of the slice's widget. While the tool is on a click places a point, Return places one
//! at the crosshair, and Escape takes the last one back. Otherwise the ends of measurements are dragged.
class SliceMeasuring : public QObject {
  Q_OBJECT

 public:
  //! All of them outlive it; `view` owns it.
  SliceMeasuring(Document& document, ViewState& state, SliceGeometry& geometry, QWidget& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool key(QKeyEvent& event);
  Vec3 placeAt(const QPointF& pixel) const;
  void dragTo(const QPointF& pixel);
  bool isFree() const;

  Document& document_;
  ViewState& state_;
  SliceGeometry& geometry_;
  QWidget& view_;
  MeasurementDrag drag_;
  bool pressed_ = false;  //!< by a press that was for the tool
};

}  // namespace handlebody::ui
