#pragma once
// A contour as it was, kept for going back to it.

#include "core/evolution/active_contour.h"
#include "core/mesh/mesh_copy.h"

namespace handlebody {

//! Most of a front is at rest most of the time, so what its mesh has in common with the keyframe before is
//! kept once. Immutable.
class Keyframe {
 public:
  //! `before`: the keyframe before it, if there is one.
  Keyframe(const ActiveContour& contour, const Keyframe* before);
  int iteration() const { return bare_.iteration(); }
  //! The contour, bit for bit.
  ActiveContour contour() const;
  //! Bytes, but for the image and what is shared with `before`, if that is given.
  std::size_t memoryBeside(const Keyframe* before) const;

 private:
  ActiveContour bare_;  // without its mesh
  MeshCopy mesh_;
};

}  // namespace handlebody
