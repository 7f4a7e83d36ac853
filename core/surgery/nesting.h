#pragma once
// Whether the parts of a surface lie within each other as the surface of a body does.

#include "core/mesh/topology.h"

namespace handlebody {

//! 1 or -1 if a ray from p, the same for all triangles, crosses abc, by its orientation, else 0 (exact). The
//! sum over a closed surface is how often it winds around p. p must not lie on it.
int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

//! How often the surface without `component` winds around p: 1 inside the body, 0 outside of it and in its
//! cavities (signed crossings of a ray with the faces, exact). p must not lie on the surface.
int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p);

//! True if a component lies wholly where none of its orientation can: a solid part (positive volume) in the
//! body, or a cavity outside of it. Such a part is a scrap that a cut has turned inside out, or has been
//! swallowed. Judged at up to kNestingSamples of its vertices, all of which must agree.
bool isMisplaced(const Mesh& mesh, const Components& parts, int component);

inline constexpr int kNestingSamples = 16;

}  // namespace handlebody
