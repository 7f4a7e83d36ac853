#pragma once
// Clicks on a grid of cells.

#include <cstddef>

#include "core/geometry/vec.h"

namespace handlebody {

//! A click and its cell. A click in the middle of what is wrong says how large that is: about as deep as the
//! click lies behind the surface.
struct CellClick {
  Vec3 place{0, 0, 0};  //!< mm
  std::size_t cell = 0;
  double radius = 0;  //!< mm: of a ball that is all inside or all outside; 0 = the cell
};

}  // namespace handlebody
