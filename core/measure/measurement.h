#pragma once
// What a user measures by placing points: a distance, or an angle.

#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

enum class MeasurementKind { ruler, angle };

struct Measurement {
  MeasurementKind kind = MeasurementKind::ruler;
  std::vector<Vec3> points;  //!< mm LPS: both ends of a ruler; of an angle the end of a leg, its vertex, the
                             //!< end of the other leg

  friend bool operator==(const Measurement&, const Measurement&) = default;
};

//! 2 for a ruler, 3 for an angle.
std::size_t pointsOf(MeasurementKind kind);

//! mm of a ruler, degrees (0 … 180) of an angle; an angle with a leg of no length has 0. Precondition: all
//! points are there. An angle is exact but for rounding near 0 and 180 degrees, too.
double valueOf(const Measurement& measurement);

}  // namespace handlebody
