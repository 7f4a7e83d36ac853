#pragma once
// The disc that closes a passage of the object.

#include "core/evolution/object_image.h"
#include "core/evolution/passages.h"

namespace handlebody {

//! A disc across the passage where its cross-section in the image is smallest near Passage::place, wide
//! enough to hold all of that section and a voxel around it; the normal points to what lies behind. Rounded
//! to 0.001 mm, so that it can be written and read again as it is. Of a section that is wider than several
//! times the passage's radius only so much is closed.
WallDisc discAcross(const ObjectImage& image, const Passage& passage);

}  // namespace handlebody
