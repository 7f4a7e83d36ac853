#pragma once
// Which faces meet at a vertex, in flat arrays, and in cyclic order where they close up around it.

#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! One corner of a face, seen from its vertex v: the face is (v, next, prev).
struct Corner {
  int face;
  int next;
  int prev;
};

class VertexStars {
 public:
  //! Faces (-1,-1,-1) are skipped. Costs next to nothing when the faces are those of the last call.
  void build(std::size_t pointCount, std::span<const Triangle> faces);

  std::span<const Corner> corners(int v) const {
    const auto first = static_cast<std::size_t>(first_[static_cast<std::size_t>(v)]);
    const auto last = static_cast<std::size_t>(first_[static_cast<std::size_t>(v) + 1]);
    return {corners_.data() + first, last - first};
  }
  //! True if the faces at v form one closed cycle; corners(v) are then in that order: corner i and corner i+1
  //! share the edge from v to prev of i = next of i+1.
  bool isCycle(int v) const { return isCycle_[static_cast<std::size_t>(v)] != 0; }
  int vertexCount() const { return static_cast<int>(isCycle_.size()); }

 private:
  void fill(std::size_t pointCount);

  std::vector<Triangle> faces_;  // of the last call
  std::vector<int> first_;       // per vertex, into corners_; one more at the end
  std::vector<Corner> corners_;
  std::vector<unsigned char> isCycle_;
  std::vector<Corner> scratch_;
};

}  // namespace handlebody
