#pragma once
// Faces that share a vertex: a cheap sufficient test that a whole star is free of intersections.

#include <span>
#include <vector>

#include "core/collision/vertex_stars.h"

namespace handlebody {

//! Squared lengths in the star of a vertex (mm²).
struct StarSize {
  double longestEdge = 0;      //!< of the longest edge at the vertex
  double enclosingCircle = 0;  //!< of the radius of a face's enclosing circle, for the largest; see StarTest
};

StarSize measureStar(std::span<const Vec3> points, int v, std::span<const Corner> corners);

class StarTest {
 public:
  //! Looks at the closed star of v (precondition: stars.isCycle(v)). True: no two of its faces have a point
  //! in common outside the vertex or edge they share; proven, rounding included. False: not decided. `size`
  //! gets the star's lengths; none is too small by more than rounding in double precision. `longestEdge` is
  //! too large by 2^-18 of itself at most; `enclosingCircle` by 2^-9, or by a third where a face is thin.
  //!
  //! If all faces look up along one direction d (cone of normals), their projections along d are proper
  //! sectors around v that follow each other in one sense. They tile the plane once, and the star is the
  //! graph of a function, if they wind around v once; without the count, a star folded like a rose passes.
  //! Tried in single precision first, where that is safe: several faces at a time.
  bool isEmbedded(std::span<const Vec3> points, int v, std::span<const Corner> corners, StarSize& size);

 private:
  bool isEmbeddedInDouble(std::span<const Vec3> points, int v, std::span<const Corner> corners,
                          StarSize& size);

  std::vector<Vec3> edges_;
  std::vector<Vec3> normals_;
};

}  // namespace handlebody
