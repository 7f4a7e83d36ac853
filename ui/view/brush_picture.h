#pragma once
// Internal: the brush under the mouse and what it is doing, painted over a slice or over the 3D view.

#include <QPainter>
#include <QPointF>
#include <optional>

#include "ui/view/brush.h"

namespace handlebody::ui {

//! Its rim, `radius` in pixels; in 3D filled as well: the ball as it is seen.
void paintBrush(QPainter& painter, const QPointF& pixel, double radius, Brush::Mode mode, bool filled);
//! A point that a pull would take hold of.
void paintGrip(QPainter& painter, const QPointF& pixel);
//! From where to where the surface is pulled, and how far around it moves with it (pixels).
void paintPull(QPainter& painter, const QPointF& from, const QPointF& to, double radius);
//! The line of a cut.
void paintCut(QPainter& painter, const QPointF& from, const QPointF& to);

}  // namespace handlebody::ui
