#pragma once
// A volume in which a click may mean more than one object.

#include "tests/support/test_volume.h"

namespace handlebody::testing {

inline const Vec3 kLeftBall(14, 24, 24), kRightBall(35, 24, 24);  // mm

//! Two dark balls with a neck between them: a click in one may mean that one, or both.
inline Volume dumbbellVolume() {
  return volumeByDistance(cubicGrid(49), 40, 160, [](const Vec3& p) {
    const bool between = p.x() > kLeftBall.x() && p.x() < kRightBall.x();
    const double neck = between ? std::hypot(p.y() - kLeftBall.y(), p.z() - kLeftBall.z()) - 2 : 100;
    return std::min({(p - kLeftBall).norm() - 8, (p - kRightBall).norm() - 10, neck});
  });
}

}  // namespace handlebody::testing
