#pragma once

#include <functional>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Where a surface may not be put. Empty functions forbid nothing.
struct Forbidden {
  //! True where no face may lie: its three corners, mm.
  std::function<bool(const Vec3&, const Vec3&, const Vec3&)> holds{};
  //! Places in a box (its lowest and highest corner, mm) that no change may carry from one side of the
  //! surface to the other: at least one of each forbidden part that lies wholly in the box.
  std::function<std::vector<Vec3>(const Vec3&, const Vec3&)> places{};
};

}  // namespace handlebody
