#pragma once
// A few faces of a mesh around a bad place, to be tried at: changed in any way that keeps its border and its
// topology. A value; everything in it is small, and looked for by going through all of it.

#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/polish/shape.h"

namespace handlebody {

//! An edge of the border with the face beyond it, whose shape counts too.
struct BorderEdge {
  int from, to;  //!< as in the face within
  Vec3 beyond;   //!< the third corner of the face beyond it
};

class PolishPatch {
 public:
  std::vector<Vec3> points;
  std::vector<int> vertex;      //!< per point: of the mesh; -1: a new one
  std::vector<char> isFree;     //!< per point: all of its faces are here
  std::vector<Triangle> faces;  //!< of points
  std::vector<BorderEdge> border;
  std::vector<std::pair<int, int>> outer;  //!< edges of faces outside between points here, lower one first
  std::vector<int> outerFaces;             //!< per point: faces outside

  //! The third corner of the face that has the edge in this direction, or -1.
  int apex(int from, int to) const;
  bool hasEdge(int a, int b) const;
  std::vector<int> neighbours(int v) const;  //!< here, ascending
  int valence(int v) const;                  //!< faces here and outside

  //! Each refuses with false, and nothing is changed, where a vertex would move that may not or the surface
  //! would be no manifold any more.
  bool flip(int a, int b);
  //! a goes to b, which is put at `place` (if that is not where it is, b must be free).
  bool collapse(int a, int b, const Vec3& place);
  //! The new point's index, or -1.
  int split(int a, int b, const Vec3& place);

  //! A face (p, q, c), an edge pq between it and (q, p, d), or one of the border.
  struct Shape {
    int p, q, c;
    int d = -1;
    const Vec3* beyond = nullptr;  //!< of the border's edge
  };
  //! All faces and edges, or those of the faces at v. Valid, however the points move, until faces change.
  std::vector<Shape> shapes() const;
  std::vector<Shape> shapesAt(int v) const;
  Badness badnessOf(std::span<const Shape> shapes, const WantedShape& wanted) const;
  Badness badness(const WantedShape& wanted) const { return badnessOf(shapes(), wanted); }
  bool isUsed(int v) const;

 private:
  void addEdges(const Triangle& t, int onlyAt, std::vector<Shape>& shapes) const;
};

}  // namespace handlebody
