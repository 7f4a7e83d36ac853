#pragma once
// Whether detection has been asked to look at all that has changed in a mesh.

#include <optional>
#include <span>

#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! A vertex of a face in `newFaces` of which no vertex is marked in `looked`; nothing if there is none.
std::optional<int> unseenFace(const Mesh& mesh, std::span<const int> newFaces, VertexMarkSpan looked);
//! A vertex that lies elsewhere than in `before`, slot by slot, and is not marked.
std::optional<int> unseenMove(const Mesh& before, const Mesh& mesh, VertexMarkSpan looked);
//! Either of them, of all faces that `before` does not have in their slots.
std::optional<int> unseenChange(const Mesh& before, const Mesh& mesh, VertexMarkSpan looked);

}  // namespace handlebody
