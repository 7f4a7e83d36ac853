#pragma once

#include <span>

#include "core/collision/self_intersection.h"
#include "core/mesh/mesh.h"
#include "core/surgery/event.h"
#include "core/surgery/opening.h"

namespace handlebody {

//! The stages of a change of topology before it is made: colliding faces, Λ, and the opened mesh within a few
//! rings of it.
EventTrace traceOfOpening(const Mesh& mesh, std::span<const FacePair> pairs,
                          std::span<const Opening> openings);

//! Adds the faces that closed the mesh, which are in the mesh now.
void traceClosing(const Mesh& mesh, std::span<const Triangle> patch, EventTrace& trace);

}  // namespace handlebody
