#pragma once
// Which components of a mesh a step may have come to: so that the others need no look, however large the
// mesh.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/topology.h"

namespace handlebody {

//! What a step has made of a mesh without taking out or making faces but by regulating it.
struct MeshMotion {
  const Mesh& before;
  const Mesh& mesh;
  VertexMarkSpan touched;  //!< per vertex of `mesh`: all that have moved, and one at least of each new face
  double longest = 0;      //!< mm, of an edge
};

//! Boxes around all components but the largest. What changes any of them, or takes one to the other side of
//! another, moves near one of these boxes: each point of a face on its straight way is no further than a
//! longest edge from that of a corner, and regulating puts faces elsewhere by no more than that.
class SmallerComponents {
 public:
  bool areKnown() const { return boxes_.has_value(); }
  //! `parts`: all of the mesh.
  void know(const Components& parts);
  void forget() { boxes_.reset(); }
  //! Forgets them where the motion may have come to one.
  void follow(const MeshMotion& motion);

 private:
  bool mayBeReached(const MeshMotion& motion) const;
  std::optional<std::vector<Eigen::AlignedBox3d>> boxes_;  // mm
};

}  // namespace handlebody
