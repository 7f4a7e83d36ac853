#pragma once
// Internal: what is painted over the 3D view.

#include <QPainter>

#include "core/evolution/image_warnings.h"
#include "ui/view/surface_scene.h"

namespace handlebody::ui {

//! Arrows towards left, anterior and superior as the camera sees them, with their letters.
void paintTriad(QPainter& painter, const QSizeF& size, const CameraPose& pose);
//! What the colours of the mesh mean, under the title.
void paintStateLegend(QPainter& painter);
//! What the colours of the support by the image mean, under the title, with the part without an edge; shorter
//! in a narrow view. Of a surface that was not compared with the image, that.
void paintSupportLegend(QPainter& painter, const QSizeF& size, const MeshSnapshot& mesh);
//! What the colour of pinned faces means, over the triad.
void paintPinLegend(QPainter& painter, const QSizeF& size);
//! What a stage of an event shows.
void paintStageCaption(QPainter& painter, EventStage stage);

}  // namespace handlebody::ui
