#pragma once
// A mesh that is changed patch by patch, each change tried before it is made: within a distance of the mesh
// that was there at first, both ways, and without an intersection.

#include <functional>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/polish/cover.h"
#include "core/polish/face_grid.h"
#include "core/polish/patch.h"

namespace handlebody {

//! What a change may not do. What it refers to outlives it.
struct PolishBounds {
  double distance = 0;  //!< mm, > 0: of the surface from the first one, both ways
  //! That no face may meet.
  std::span<const TriangleSoup* const> obstacles{};
  //! True where no face may lie: its three corners, mm. None: it may lie anywhere.
  std::function<bool(const Vec3&, const Vec3&, const Vec3&)> forbids{};
  //! Per vertex: 1 if it is neither moved nor removed, nor a face between three such. Empty: none.
  std::vector<char> isHeld{};
};

class PolishedSurface {
 public:
  //! Precondition: closed, manifold, oriented, without self-intersections. Mesh and bounds outlive it.
  PolishedSurface(const TriangleSoup& mesh, const PolishBounds& bounds);
  //! To be called before anything is changed or asked for but points, faces and what lies at an edge.
  void prepare();

  std::span<const Vec3> points() const { return points_; }
  //! Those that are gone hold -1. A face that is changed gets another number.
  std::span<const Triangle> faces() const { return faces_; }
  //! The face with that directed edge, or -1, and its third corner.
  int faceAt(int from, int to) const;
  int apex(int from, int to) const;

  struct Part {
    PolishPatch patch;
    std::vector<int> faces;  //!< per face of the patch
  };
  //! The faces at these vertices and at their neighbours.
  Part around(std::span<const int> vertices) const;
  //! The surface of the beginning within the distance of the patch, and some more of it.
  std::vector<Corners> firstNear(const PolishPatch& patch) const;

  //! Makes the patch what it is to be, if that may be: all that is new lies within the distance of the first
  //! surface, all of that which was near to what goes lies within the distance of the new one, and no face
  //! intersects another or an obstacle. Else false, and nothing is changed.
  bool accept(const Part& before, const PolishPatch& after);

  //! Without what is gone; faces that were not changed keep their order.
  TriangleSoup compact() const;
  //! Faces that are not of the beginning.
  int changedFaces() const;
  //! The largest distance of the changed part from the first surface and of that from it, mm (of points that
  //! lie densely).
  double farthest() const;

 private:
  struct Change;
  Corners cornersOf(const Triangle& t) const;
  bool isHeld(int v) const {
    return static_cast<std::size_t>(v) < bounds_.isHeld.size() && bounds_.isHeld[v] != 0;
  }
  bool breaksHeld(const Change& change) const;
  Change changeOf(const Part& before, const PolishPatch& after) const;
  bool isNear(const Change& change) const;
  bool isFree(const Change& change) const;
  void put(int face);
  void take(int face);
  std::vector<Corners> cornersNear(const FaceGrid& grid, const TriangleSoup& mesh, const Box& box) const;

  const TriangleSoup& first_;
  const PolishBounds& bounds_;
  std::vector<Vec3> points_;
  std::vector<Triangle> faces_;
  std::vector<std::vector<int>> facesAt_;  // per vertex
  FaceGrid grid_, firstGrid_;
  TriangleSoup obstacle_;  // all of them
  FaceGrid obstacleGrid_;
};

}  // namespace handlebody
