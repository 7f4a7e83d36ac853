#pragma once
// The boundary loops that a handle joins, and the edges and faces that it may have.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/vec.h"
#include "core/indices.h"

namespace handlebody {

//! Two vertices that must not be joined, numbered as in CrossEdges.
using VertexPair = std::array<int, 2>;

//! Loops of vertices, numbered one loop after the other from 0, and the length of every edge between two.
class CrossEdges {
 public:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  //! `loops`: positions (mm) in the order in which handle faces hold the edges of the loop.
  CrossEdges(std::span<const std::vector<Vec3>> loops, std::span<const VertexPair> forbiddenEdges);
  //! No handle may have these faces, corners in any order.
  void forbid(std::span<const Triangle> faces);
  //! Nor these edges.
  void forbid(std::span<const VertexPair> edges);

  int vertexCount() const { return static_cast<int>(loop_.size()); }
  int loopCount() const { return static_cast<int>(first_.size()) - 1; }
  int loopOf(int v) const { return loop_[v]; }
  //! The first vertex of a loop; of loopCount(): the number of all vertices.
  int firstOf(int loop) const { return first_[loop]; }
  //! The vertex next to v along its loop.
  int next(int v) const { return v + 1 == firstOf(loopOf(v) + 1) ? firstOf(loopOf(v)) : v + 1; }
  //! Of the edge uv, mm; kNone within a loop, if the edge is forbidden, and if it is not finite.
  double length(int u, int v) const { return length_[idx(u) * loop_.size() + idx(v)]; }
  //! Of the edges between loops of these faces, each once, mm.
  double lengthOf(std::span<const Triangle> faces) const;
  bool anyFaceForbidden() const { return !forbiddenFaces_.empty(); }
  bool allows(const Triangle& face) const {
    return !anyFaceForbidden() || (isCorner_[face[0]] & isCorner_[face[1]] & isCorner_[face[2]]) == 0 ||
           !isForbidden(face);
  }

 private:
  bool isForbidden(const Triangle& face) const;
  std::vector<int> loop_;   // of each vertex
  std::vector<int> first_;  // vertex of each loop, and the end
  std::vector<double> length_;
  std::vector<unsigned char> isCorner_;   // of a forbidden face, per vertex
  std::vector<Triangle> forbiddenFaces_;  // corners ascending; sorted
};

}  // namespace handlebody
