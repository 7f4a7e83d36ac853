#pragma once
// Whether the parts of a surface lie within each other as the surface of a body does: bodies and cavities
// alternate, no body lies directly in a body, no cavity outside of any.

#include <span>
#include <vector>

#include "core/mesh/topology.h"

namespace handlebody {

//! Faces whose vertices are labelled with their component. Faces (-1,-1,-1) are skipped.
struct LabelledSurface {
  std::span<const Vec3> points;  //!< mm
  std::span<const Triangle> faces;
  const Components& parts;
};
inline LabelledSurface labelled(const Mesh& mesh, const Components& parts) {
  return {mesh.positions(), mesh.faces(), parts};
}

//! 1 or -1 if a ray from p, the same for all triangles, crosses abc, by its orientation, else 0 (exact). The
//! sum over a closed surface is how often it winds around p. p must not lie on it.
int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

//! How often the surface without `component` winds around p: 1 inside the body, 0 outside of it and in its
//! cavities (signed crossings of a ray with the faces, exact). p must not lie on the surface.
int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p);

//! The same at many places, without leaving a component out, in one look at every face.
std::vector<int> windingNumbers(const Mesh& mesh, const Components& parts, std::span<const Vec3> places);

//! True if the body holds p: it lies in no cavity. p must not lie on the surface.
inline bool encloses(const Mesh& mesh, const Components& parts, const Vec3& p) {
  constexpr int kNone = -1;  // no component is left out
  return windingNumber(mesh, parts, kNone, p) == 1;
}

//! True if a component lies wholly where none of its orientation can: a solid part (positive volume) in the
//! body, or a cavity outside of it. Such a part is a scrap that a cut has turned inside out, or has been
//! swallowed. Judged at up to kNestingSamples of its vertices, all of which must agree.
bool isMisplaced(const Mesh& mesh, const Components& parts, int component);

//! All components that are, ascending. Costs one look at every face, however many components there are.
std::vector<int> misplacedComponents(const LabelledSurface& surface);

inline constexpr int kNestingSamples = 16;

}  // namespace handlebody
