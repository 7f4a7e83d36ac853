#pragma once
// Internal: the way from ball to ball.

#include <vector>

#include "core/measure/centre_line.h"
#include "core/measure/inscribed_balls.h"

namespace handlebody {

struct BallPath {
  std::vector<Vec3> points;  //!< from `from` to `to`; none if there is no way
  CentreLineFault fault = CentreLineFault::none;
};

//! Dijkstra's search on a lattice of centres; two of them are joined if their balls overlap, which no two do
//! that the surface lies between. A millimetre costs 1/radius². `spacing` (mm) is halved where that finds no
//! way, until kMaxBalls. Precondition: both are inside.
BallPath findBallPath(InscribedBalls& balls, const Vec3& from, const Vec3& to, double spacing);

inline constexpr int kMaxBalls = 3'000'000;

}  // namespace handlebody
