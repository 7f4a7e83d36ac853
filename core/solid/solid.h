#pragma once
// An object to be compared: a mesh from a file, or what a label map holds.

#include <optional>

#include "core/mesh/validity.h"
#include "core/solid/mask.h"

namespace handlebody {

struct Solid {
  TriangleSoup surface;        //!< mm LPS; of a mask, its maskSurface
  std::optional<Mask> mask{};  //!< of a label map
  Certificate certificate{};   //!< of the surface, but for self-intersections
  bool wasInsideOut = false;   //!< a mesh that enclosed a negative volume, turned here

  bool empty() const { return surface.triangles.empty(); }
  //! Parts of a mesh lie where they bound nothing, as one does that is inside out (nesting.h).
  bool isMisplaced() const { return !mask && certificate.misplaced > 0; }
  //! Has an inside: closed, all faces oriented alike and no part misplaced, or a label map. Nothing does,
  //! too.
  bool isClosed() const { return empty() || (certificate.closed && certificate.oriented && !isMisplaced()); }
  //! mm³: of the voxels, or enclosed by the mesh. Precondition: isClosed().
  double volume() const;
};

Solid solidOf(TriangleSoup mesh);
//! Throws as maskSurface.
Solid solidOf(Mask mask);

}  // namespace handlebody
