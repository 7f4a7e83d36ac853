#pragma once
// Internal: the mesh seen from the front, left and above, drawn with a depth buffer in memory.

#include "app/picture/picture_canvas.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Fills `area` with a view of the mesh (mm LPS) in parallel projection; returns millimetres per pixel, or 0
//! if the mesh is empty.
double drawSurface(Canvas& canvas, const Rect& area, const TriangleSoup& mesh);

}  // namespace handlebody
