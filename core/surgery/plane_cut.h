#pragma once
// A flat cut, capped on both sides.

#include <optional>

#include "core/surgery/kept_side.h"
#include "core/surgery/touched_mesh.h"

namespace handlebody {

struct PlaneCut {
  Vec3 point{0, 0, 0};   //!< mm, LPS
  Vec3 normal{0, 0, 1};  //!< LPS, of any length above 0
  KeptSide keep = KeptSide::both;
  //! Only where a part of the body's section lies within that many mm of the point, or holds it; none:
  //! wherever the plane meets the surface.
  std::optional<double> radius{};
};

//! Cuts the body along the plane, and caps both sides flat: they are up to kWidestGap edges apart. The plane
//! may be moved by up to kWidestShift edges, so that it comes close to no vertex. Of a cut that leaves one
//! side, what lies on the other goes, with what lies in it (with a radius: the components that the cut capped
//! there); a component that was capped on both sides because the cut did not part it cannot go, and the cut
//! is refused. Refused, too, where the plane meets nothing. The topology is that which the removed rings and
//! the caps predict. Vertices keep their slots. Precondition: `mesh` is certified.
TouchedMesh cutByPlane(const Mesh& mesh, const PlaneCut& cut);

// In mean edges that the plane crosses.
inline constexpr double kWidestGap = 0.01;
inline constexpr double kWidestShift = 0.03;

}  // namespace handlebody
