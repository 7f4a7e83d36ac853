#pragma once
// The volume that a mesh encloses, where little of it has changed since the last time.

#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Keeps the share of each face, so that only those that have changed are computed again. What comes out is
//! signedVolume (topology.h), bit for bit: the shares are added up in the same order.
class SurfaceVolume {
 public:
  //! mm³. `touched`: per vertex, all that have moved since the last call and one at least of each face that
  //! has other vertices; what lies beyond its end has not. Precondition: the slots are those of the last
  //! call, or `forget` was called.
  double follow(const Mesh& mesh, VertexMarkSpan touched);
  void forget() { shares_.clear(); }

 private:
  std::vector<double> shares_;  // mm³, per face slot, 0 without a face; empty: not known
};

}  // namespace handlebody
