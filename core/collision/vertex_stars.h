#pragma once
// Which faces meet at a vertex, in flat arrays, and in cyclic order where they close up around it.

#include <span>
#include <vector>

#include "core/geometry/vec.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! One corner of a face, seen from its vertex v: the face is (v, next, prev).
struct Corner {
  int face;
  int next;
  int prev;
};

class VertexStars {
 public:
  //! The stars of all vertices. Faces (-1,-1,-1) are skipped. Costs next to nothing when the faces are those
  //! of the last call.
  void build(std::size_t pointCount, std::span<const Triangle> faces);
  //! Those stars that are asked for by need() are read from the mesh, which must not change meanwhile; or
  //! taken from an earlier reading, if the mesh still holds all their faces.
  void readFrom(const Mesh& mesh);
  //! After readFrom: makes corners(v) valid, those of other vertices stay so; spans do not.
  void need(int v) {
    if (mesh_ && stars_[v].reading != reading_) check(v);
  }
  //! The same for each of them, all different.
  void need(std::span<const int> vertices, int threads);

  std::span<const Corner> corners(int v) const {
    const Star& star = stars_[v];
    return {corners_.data() + star.first, static_cast<std::size_t>(star.count)};
  }
  //! True if the faces at v form one closed cycle; corners(v) are then in that order: corner i and corner i+1
  //! share the edge from v to prev of i = next of i+1.
  bool isCycle(int v) const { return stars_[v].isCycle; }
  int vertexCount() const { return static_cast<int>(stars_.size()); }

 private:
  struct Star {
    int first;  // into corners_
    int count;
    bool isCycle;
    int reading;  // for which it was checked last
  };
  void fill(std::size_t pointCount);
  void check(int v);
  bool isStill(int v) const;
  void read(int v);

  const Mesh* mesh_ = nullptr;   // of readFrom
  int reading_ = 0;              // calls of readFrom
  std::vector<Triangle> faces_;  // of the last build
  std::vector<Star> stars_;
  std::vector<Corner> corners_;
  std::vector<Corner> scratch_;
};

}  // namespace handlebody
