#pragma once
// Internal: rulers, angles and centre lines over slices and over the 3D view.

#include <QPainter>
#include <optional>

#include "ui/view/slice_geometry.h"
#include "ui/view/surface_scene.h"

namespace handlebody::ui {

class Document;
class MeasureTool;

//! What lies within half a slice of this one: the ends of measurements there and the parts of their lines,
//! each with its value beside it.
void paintMeasurements(QPainter& painter, const SliceGeometry& geometry, const Document& document,
                       const MeasureTool& tool);
//! All of them, over the surface.
void paintMeasurements(QPainter& painter, const QSizeF& size, const CameraPose& pose,
                       const Document& document, const MeasureTool& tool);

//! Where a point is seen in a view of this size, logical pixels.
QPointF toScreen(const CameraPose& pose, const QSizeF& size, const Vec3& world);

//! A point of a measurement.
struct MeasurementGrab {
  int measurement = -1, point = -1;
};
//! The point of a measurement under the mouse, the selected one's first; none: there is none within reach.
std::optional<MeasurementGrab> grabAt(const SliceGeometry& geometry, const Document& document,
                                      const QPointF& pixel);
std::optional<MeasurementGrab> grabAt(const CameraPose& pose, const QSizeF& size, const Document& document,
                                      const QPointF& pixel);

}  // namespace handlebody::ui
