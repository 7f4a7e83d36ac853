#pragma once
// The program's own icons: line drawings in the colour of the text, so that they can be read on light and
// dark.

#include <QIcon>
#include <QString>

#include "core/io/meshes/exported_object.h"

namespace handlebody::ui {

//! resources/icons/NAME.svg; "currentColor" in it is the palette's text colour at the time of painting.
//! Precondition: there is such a file.
QIcon icon(const QString& name);
//! The same for a ground that is always black.
QIcon iconOnBlack(const QString& name);
//! A patch of this colour, the same on a chosen row.
QIcon swatch(const Colour& colour);
//! The program's icon, in its own colours.
QIcon programIcon();

}  // namespace handlebody::ui
