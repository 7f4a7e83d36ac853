#pragma once
// The faces of a mesh near a place, while the mesh changes: so that a change costs what lies about it.

#include <Eigen/Geometry>
#include <algorithm>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! Boxes around every kBlock faces, in the order of their slots. Faces that follow each other lie close to
//! each other wherever the mesh is kept in order (morton_order.h), so that a box says much; it holds its
//! faces in any case. Made in one look at every face.
class FaceBlocks {
 public:
  explicit FaceBlocks(const Mesh& mesh);
  //! Puts all faces into blocks anew, by their place. A mesh that has changed everywhere since it was put
  //! into order has blocks that reach across half of it: then a few looks at the blocks cost more than this
  //! (two looks at every face). What is found near a place does not depend on it.
  void sortByPlace(const Mesh& mesh);
  //! To be called when the face is new or has moved. Faces that are removed need no call.
  void include(const Mesh& mesh, int face);
  //! The same for all faces around these vertices.
  void includeAround(const Mesh& mesh, std::span<const int> vertices);

  //! Calls f(face) for all faces whose boxes meet the box, each once, and for some others. Those without a
  //! place of their own in the blocks (new ones) come last.
  template <typename F>
  void forEachNear(const Mesh& mesh, const Eigen::AlignedBox3d& box, F&& f) const {
    const int slots = mesh.faceSlots();
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      if (!boxes_[b].intersects(box)) continue;
      const int first = static_cast<int>(b) * kBlock;
      for (int place = first; place < first + kBlock; ++place) {
        const int face = faceAt(place);
        if (face < slots && mesh.isFace(face)) f(face);
      }
    }
  }

 private:
  static constexpr int kBlock = 32;
  int faceAt(int place) const {
    const auto p = static_cast<std::size_t>(place);
    return p < faceOfPlace_.size() ? faceOfPlace_[p] : place;
  }
  int placeOf(int face) const {
    const auto f = static_cast<std::size_t>(face);
    return f < placeOfFace_.size() ? placeOfFace_[f] : face;
  }

  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<int> faceOfPlace_, placeOfFace_;  // the slots by place; those beyond are in their own order
};

}  // namespace handlebody
