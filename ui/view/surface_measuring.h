#pragma once
// Internal: points of measurements on the surface in 3D.

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "ui/view/measurement_drag.h"

class QKeyEvent;
class QMouseEvent;
class QWidget;

namespace handlebody::ui {

class ViewState;

//! Where the line of sight through a pixel first meets the shown surfaces, and their normal there (a unit
//! vector towards the outside).
struct SurfaceHit {
  Vec3 place{0, 0, 0}, normal{0, 0, 1};
};
std::optional<SurfaceHit> hitAt(const CameraPose& pose, const QSizeF& size, const Document& document,
                                const QPointF& pixel);

//! Filters the events of the 3D view's widget. While the tool is on a click on the surface places a point (to
//! drag turns the camera as ever), and Escape takes the last one back. Otherwise the ends of measurements are
//! dragged along the surface.
class SurfaceMeasuring : public QObject {
  Q_OBJECT

 public:
  //! `pose`: none where no surface is shown. All of them outlive it; `view` owns it.
  SurfaceMeasuring(Document& document, ViewState& state, std::function<std::optional<CameraPose>()> pose,
                   QWidget& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool key(QKeyEvent& event);
  std::optional<Vec3> placeAt(const QPointF& pixel) const;
  std::optional<MeasurementGrab> grab(const QPointF& pixel) const;

  Document& document_;
  ViewState& state_;
  std::function<std::optional<CameraPose>()> pose_;
  QWidget& view_;
  MeasurementDrag drag_;
  std::optional<QPointF> pressed_;  //!< a press that may become a click
  bool isOverEnd_ = false;
};

}  // namespace handlebody::ui
