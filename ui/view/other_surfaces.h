#pragma once
// Internal: the surfaces of the objects that are not active, as the 3D view draws them.

#include <optional>
#include <vector>

#include "ui/view/surface_scene.h"

namespace handlebody::ui {

class Document;

//! Of the objects that are visible and have a surface.
std::vector<SurfaceScene::Other> otherSurfaces(const Document& document);
//! Of the active object's surface and all others that are shown; none if there is none.
std::optional<Sight> sightOfSurfaces(const Document& document);

}  // namespace handlebody::ui
