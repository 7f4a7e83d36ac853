#pragma once

#include <span>

#include "core/collision/self_intersection.h"
#include "core/mesh/mesh.h"
#include "core/surgery/event.h"
#include "core/surgery/opening.h"

namespace handlebody {

//! The first stage of a change of topology: the colliding faces of the mesh as it is before any refinement.
EventTrace traceOfCollision(const Mesh& mesh, std::span<const FacePair> pairs);

//! Adds Λ, the mesh within a few rings of it, opened, and refined where an opening needed it. Precondition:
//! the mesh is refined, and not yet open.
void traceOpening(const Mesh& mesh, std::span<const Opening> openings, EventTrace& trace);

//! Adds the faces that closed the mesh, which are in the mesh now.
void traceClosing(const Mesh& mesh, std::span<const Triangle> patch, EventTrace& trace);

}  // namespace handlebody
