#pragma once
// The object of one frame in another, where what clicks mean there is not what was decided before.

#include <memory>

#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! What the surface of one frame encloses, as two images move it (FrameMotion).
struct MovedObject {
  std::shared_ptr<const TriangleSoup> surface;  //!< mm LPS: closed
  bool isCertified = false;                     //!< free of self-intersections, too

  //! Where the growth begins: with itself if it can, else with the surface of the frame beside it, which has
  //! not moved.
  const TriangleSoup& beginning(const TriangleSoup& beside) const { return isCertified ? *surface : beside; }
  //! As the object that is given (docs/object.md), with the clicks as corrections of it.
  StartSurface given() const;
};

//! Precondition: both volumes have the same grid; `surface` is that of the first, and not empty.
MovedObject movedObject(const Volume& from, const Volume& to, const TriangleSoup& surface);

}  // namespace handlebody
