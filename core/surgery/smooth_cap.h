#pragma once
// A cap for a large polygon: a fine membrane.

#include <optional>

#include "core/surgery/closing.h"

namespace handlebody {

//! The cap of least area without new vertices, divided into faces with edges like those of the polygon and
//! relaxed to a membrane, about as a soap film. None where leastAreaCap gives none.
std::optional<Patch> smoothCap(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop);

}  // namespace handlebody
