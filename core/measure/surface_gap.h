#pragma once

#include <vector>

#include "core/collision/body_contact.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! How near two bodies come to each other.
struct SurfaceGap {
  BodyContact contact = BodyContact::none;
  double distance = 0;              //!< mm, of the surfaces, also of one inside of the other; 0 if they meet
  Vec3 onA{0, 0, 0}, onB{0, 0, 0};  //!< where; if they meet, a place near by
};

//! The least distance of any two triangles; exact but for rounding. Precondition: both bound a body.
SurfaceGap surfaceGap(const TriangleSoup& a, const TriangleSoup& b);

//! The gap of two of several bodies, by their indices.
struct PairGap {
  int from = 0, to = 0;
  SurfaceGap gap;  //!< onA is on `from`
};

//! Of every pair, `from` before `to`: 0 and 1, 0 and 2, 1 and 2, 0 and 3. Precondition: as surfaceGap().
std::vector<PairGap> pairGaps(const std::vector<const TriangleSoup*>& bodies);

}  // namespace handlebody
