#pragma once
// Which faces have a moved vertex, and which vertices they have.

#include <span>
#include <vector>

#include "core/collision/vertex_stars.h"

namespace handlebody {

//! A flag per face and per vertex, set by mark() and taken back by clear(): between two detections all are 0,
//! so that both cost what is marked, and no table is filled anew. Owned by the workspace.
class MovedFaces {
 public:
  //! Marks the faces that have a vertex v with moved[v] != 0 (one flag per point), and all of their vertices;
  //! these are listed in `vertices`, whose stars are read. Precondition: nothing is marked.
  void mark(std::size_t pointCount, std::span<const Triangle> faces, std::span<const unsigned char> moved,
            VertexStars& stars, std::vector<int>& vertices, int threads = 1);
  //! `vertices`: those that were listed, whatever others there are among them.
  void clear(std::span<const int> vertices);

  //! Those marked, by slot.
  std::span<const int> list() const { return faces_; }
  bool hasFace(int f) const { return isFace_[f] != 0; }
  bool hasVertex(int v) const { return isVertex_[v] != 0; }

 private:
  void listAmongAll(std::span<const Triangle> faces, std::span<const unsigned char> moved);
  void listAtVertices(std::span<const unsigned char> moved, VertexStars& stars);

  std::vector<unsigned char> isFace_, isVertex_;
  std::vector<int> faces_;
};

}  // namespace handlebody
