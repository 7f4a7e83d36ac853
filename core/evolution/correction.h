#pragma once
// What other clicks make of a surface that has grown: parts that do not meet the object go, clicks that no
// front would come to get one of their own, and what agrees with the new image stays as it is.

#include <functional>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! How a surface went on when its clicks were changed.
struct Correction {
  //! Part of what the surface enclosed that the new object holds, 0 … 1.
  double common = 0;
  //! So little that the surface began anew from the seeds; nothing of what follows was done then.
  bool beganAnew = false;
  //! Some of the surface lies outside of the new object.
  bool givesGround = false;
  int deleted = 0;  //!< components that did not meet the new object
  int fronts = 0;   //!< spheres that were added, in components of their own
};

//! And at which iteration.
struct RecordedCorrection {
  int iteration = 0;
  Correction what{};
};

//! Below this part in common a surface begins anew: what it would keep costs less to grow again than the rest
//! costs to give up.
inline constexpr double kHardlyInCommon = 0.1;

//! Changes the components of the surface as the new clicks ask for; the vertices that stay do not move.
//! `fronts` gets the spheres that were added. Nothing is done if it has to begin anew. Precondition: the mesh
//! is closed, manifold and free of self-intersections, with edges of at most `longest` mm; it is so
//! afterwards. A component stays if it, or one within it, has a vertex that `isPinned` tells (none: no
//! vertex).
Correction correctComponents(Mesh& mesh, const ObjectImage& image, const std::vector<Seed>& clicks,
                             double edgeLength, double longest, std::vector<Seed>& fronts,
                             const std::function<bool(int)>& isPinned = {});

//! Where the surface and the image do not agree on where the boundary lies.
struct Disagreement {
  VertexMarks vertices;    //!< per slot: 1 where they disagree, and a few edges around that
  bool isOutside = false;  //!< some vertex lies outside of the object
};

//! They agree at a vertex if the boundary lies within `tolerance` (mm) of it along the normal.
Disagreement findDisagreement(const Mesh& mesh, const ObjectImage& image, double tolerance);

}  // namespace handlebody
