#pragma once
// Whether the parts of a surface lie within each other as the surface of a body does.

#include "core/mesh/topology.h"

namespace handlebody {

//! Signed solid angle of the triangle abc seen from 0 (van Oosterom and Strackee).
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c);

//! How often the surface without `component` winds around p: 1 inside the body, 0 outside of it and in its
//! cavities (solid angle of the faces over 4π, rounded). p must not lie on the surface.
int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p);

//! True if a component lies wholly where none of its orientation can: a solid part (positive volume) in the
//! body, or a cavity outside of it. Such a part is a scrap that a cut has turned inside out, or has been
//! swallowed. Judged at up to kNestingSamples of its vertices, all of which must agree.
bool isMisplaced(const Mesh& mesh, const Components& parts, int component);

inline constexpr int kNestingSamples = 16;

}  // namespace handlebody
