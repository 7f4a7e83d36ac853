#pragma once

#include <span>

#include "core/geometry/vec.h"

namespace handlebody {

struct FarthestPair {
  double distance = 0;  //!< mm
  Vec3 from{0, 0, 0}, to{0, 0, 0};
};

//! The two points that are farthest from each other (of equal ones any, always the same): exact but for the
//! rounding of a distance. Only pairs of boxes that can beat the best one found are looked at: some n log n
//! for long things, n^1.5 for a ball. All 0 without points.
FarthestPair farthestPair(std::span<const Vec3> points);

}  // namespace handlebody
