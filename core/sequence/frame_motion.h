#pragma once
// How what lies at a surface moves from one frame to another, by the two images alone.

#include <array>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/object/cells.h"

namespace handlebody {

//! Demons (Thirion 1998) with the gradients of both images, on a few thousand cells around the surface: what
//! is followed is the object as a whole, its finest parts are left to the edges of the other image.
//! Intensities are compared in units of what they vary by nearby, so that a gain changes nothing.
class FrameMotion {
 public:
  //! Preconditions: both volumes have the same grid; the surface (mm LPS) is not empty.
  FrameMotion(const Volume& from, const Volume& to, const TriangleSoup& surface);
  //! Where the points of a surface of the one frame lie in the other: mm, in single precision. It is closed
  //! as before; whether it is free of self-intersections is not said.
  TriangleSoup moved(TriangleSoup surface) const;

 private:
  void follow(const std::vector<float>& from, const std::vector<float>& to);
  void step(const std::vector<float>& from, const std::vector<float>& here);

  CellGrid cells_;
  std::array<std::vector<float>, 3> along_;  // mm along the axes of the grid, per cell
};

}  // namespace handlebody
