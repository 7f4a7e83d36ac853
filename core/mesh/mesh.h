#pragma once
// The triangle mesh of the engine: a corner table (implicit half-edges) in flat arrays.
//
// Face f has the half-edges 3f, 3f+1, 3f+2; half-edge h runs from origin(h) to target(h) = origin(next(h)),
// and the face lies to its left. opposite(h) is the half-edge that runs the other way in the neighbouring
// face, or -1 on a boundary (an opened mesh only). Deleted faces and vertices leave free slots that later
// insertions fill again, so an index stays valid until its element is deleted.

#include <span>
#include <vector>

#include "core/geometry/vec.h"
#include "core/indices.h"

namespace handlebody {

//! Triangles by index, of any kind (closed or not, manifold or not): what comes from a file or goes to one.
struct TriangleSoup {
  std::vector<Vec3> points;         //!< mm
  std::vector<Triangle> triangles;  //!< indices into points, counter-clockwise seen from outside
};

class Mesh {
 public:
  Mesh() = default;
  //! Builds from triangles. Precondition: every directed edge occurs at most once (oriented manifold edges).
  explicit Mesh(const TriangleSoup& soup);

  // --- sizes: slots include deleted elements, counts do not ---
  int vertexSlots() const { return static_cast<int>(positions_.size()); }
  int faceSlots() const { return static_cast<int>(faces_.size()); }
  int vertexCount() const { return vertexSlots() - static_cast<int>(freeVertices_.size()); }
  int faceCount() const { return faceSlots() - static_cast<int>(freeFaces_.size()); }
  //! Bytes of the arrays that a copy of the mesh takes.
  std::size_t memory() const;
  bool isVertex(int v) const { return outgoing_[v] != kDeleted; }
  bool isFace(int f) const { return faces_[f][0] >= 0; }

  // --- geometry ---
  const Vec3& position(int v) const { return positions_[v]; }
  void setPosition(int v, const Vec3& p) { positions_[v] = p; }
  std::span<const Vec3> positions() const { return positions_; }
  //! Vertex indices per face slot; deleted faces hold -1.
  std::span<const Triangle> faces() const { return faces_; }
  //! Per half-edge slot: the opposites, stale for deleted faces.
  std::span<const int> opposites() const { return opposite_; }
  //! Per vertex slot: outgoing(), and a negative number for what has none.
  std::span<const int> outgoing() const { return outgoing_; }
  const Triangle& face(int f) const { return faces_[f]; }
  //! Cross product of two edges of face f: its length is twice the area (mm²), outward.
  Vec3 areaVector(int f) const;

  // --- half-edges ---
  static int faceOf(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int origin(int h) const { return faces_[h / 3][h % 3]; }
  int target(int h) const { return origin(next(h)); }
  int apex(int h) const { return origin(prev(h)); }
  int opposite(int h) const { return opposite_[h]; }
  //! One half-edge that leaves v; on a boundary vertex the one from which rotating with `turn` meets all
  //! faces. -1 for an isolated vertex.
  int outgoing(int v) const { return outgoing_[v]; }
  //! Next half-edge that leaves the same vertex, counter-clockwise seen from outside; -1 at a boundary.
  int turn(int h) const { return opposite(prev(h)); }
  //! The half-edge from u to v, or -1.
  int findHalfedge(int u, int v) const;

  //! Calls f(h) for every half-edge that leaves v, counter-clockwise.
  template <typename F>
  void forEachOutgoing(int v, F&& f) const {
    const int start = outgoing(v);
    if (start < 0) return;
    int h = start;
    do {
      f(h);
      h = turn(h);
    } while (h >= 0 && h != start);
  }
  //! Calls f(w) for every neighbour of v, counter-clockwise (boundary vertices: all of them too).
  template <typename F>
  void forEachNeighbour(int v, F&& f) const {
    const int start = outgoing(v);
    if (start < 0) return;
    int h = start;
    int last = -1;
    do {
      f(target(h));
      last = h;
      h = turn(h);
    } while (h >= 0 && h != start);
    if (h < 0) f(apex(last));
  }
  int valence(int v) const;

  // --- elementary changes; they keep opposite_ and outgoing_ consistent, nothing more ---
  int addVertex(const Vec3& p);
  //! Adds faces and joins them to each other and to boundary half-edges around their vertices. Precondition:
  //! no directed edge occurs twice afterwards, and every vertex has at most one fan of faces before.
  void addFaces(std::span<const Triangle> faces);
  //! Removes faces; what is left beside them gets a boundary. Vertices stay. Precondition: the faces around
  //! each vertex that are left form one fan (no pinched vertices).
  void removeFaces(std::span<const int> faces);
  //! Removes a vertex without faces.
  void removeVertex(int v);
  //! Splits the edge of h at p; returns the new vertex. Both faces are divided in two. Precondition: not a
  //! boundary.
  int splitEdge(int h, const Vec3& p);
  //! Turns the edge of h. Precondition: canFlip(h).
  void flipEdge(int h);
  bool canFlip(int h) const;
  //! Merges origin(h) and target(h) into origin(h), placed at p. Precondition: canCollapse(h).
  void collapseEdge(int h, const Vec3& p);
  //! Link condition on a closed mesh: the collapse keeps it a manifold of the same topology.
  bool canCollapse(int h) const;

  //! Numbers the vertices anew, in this order (all of them, each once), and the faces by the first of their
  //! vertices in it. No free slots are left.
  void reorder(std::span<const int> vertices);

  //! Copy without free slots, in slot order; if wanted, `vertexMap` gets the new index of each old slot or
  //! -1.
  TriangleSoup compact(std::vector<int>* vertexMap = nullptr) const;

 private:
  friend class MeshCopy;  // all arrays, in another form
  static constexpr int kIsolated = -1;
  static constexpr int kDeleted = -2;
  void link(int h, int g);
  int newFace(const Triangle& corners);
  void deleteFaceSlot(int f);

  std::vector<Vec3> positions_;
  std::vector<Triangle> faces_;
  std::vector<int> opposite_;  // per half-edge
  std::vector<int> outgoing_;  // per vertex; kIsolated, kDeleted
  std::vector<int> freeVertices_;
  std::vector<int> freeFaces_;
};

}  // namespace handlebody
