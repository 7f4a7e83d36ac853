#pragma once
// What a solver asks of a surface: the shapes of its triangles.

#include "core/mesh/mesh.h"

namespace handlebody {

struct Spread {
  double least = 0;
  double percent5 = 0;  //!< 5 % are no larger
  double median = 0;
  double largest = 0;
};

struct MeshQuality {
  Spread angles;       //!< degrees, of all corners
  Spread radiusRatio;  //!< per triangle, 2 · inscribed / circumscribed: 1 if equilateral, 0 without area
  Spread edges;        //!< mm, each once
  //! Degrees, between the two faces of an edge: 180 where it is flat, small where it is sharp on either side.
  Spread dihedral;
  int flat = 0;  //!< triangles without area
};

//! Of any triangles; edges of one face or more than two have no dihedral angle. All 0 where there is nothing.
//! O(n log n).
MeshQuality meshQuality(const TriangleSoup& mesh);

}  // namespace handlebody
