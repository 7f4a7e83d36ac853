#pragma once
// What is painted over both kinds of view: text that can be read on any ground, scale bar, frame.

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QString>

#include "ui/view/view_state.h"

namespace handlebody::ui {

//! 3D Slicer's frame colours.
QColor planeColour(Plane plane);
QString planeName(Plane plane);

//! Bold, `factor` times the application's size.
QFont overlayFont(double factor = 1, bool bold = false);
//! Light text with a dark rim; `place` is the corner or middle of the text that `flags` (Qt::Alignment) say.
void paintText(QPainter& painter, const QPointF& place, Qt::Alignment flags, const QString& text,
               const QFont& font, const QColor& colour = QColor(0xe8, 0xec, 0xf0));
//! A square of a colour and what it means; `place` is the middle of the square's left side.
void paintKey(QPainter& painter, const QPointF& place, const QColor& colour, const QString& text);
//! Of the surface where the image shows no edge. The other colours of mesh and outline differ from it for
//! every kind of colour vision.
QColor unsupportedColour();
//! Of a marked loop, in all views.
QColor loopColour(MarkedLoop::Kind kind);
//! Of what the pins hold, in slices and in 3D.
QColor pinColour();
//! Of walls, in slices and in 3D.
QColor wallColour();
//! A bar of a round length with its mm in the lower right corner.
void paintScaleBar(QPainter& painter, const QSizeF& size, double mmPerPixel);
//! A bar of the view's colour along its upper edge; around it when the view has the keyboard's focus.
void paintFrame(QPainter& painter, const QSizeF& size, const QColor& colour, bool focused);
//! A sentence in the middle of an empty view.
void paintHint(QPainter& painter, const QSizeF& size, const QString& text);

constexpr double kOverlayMargin = 10;  //!< pixels from the edge of a view to its texts

}  // namespace handlebody::ui
