#pragma once
// The components of a mesh as a list for people: size, place, what lies in what.

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! A component of a closed mesh.
struct Piece {
  bool isCavity = false;  //!< encloses a negative volume
  double volume = 0;      //!< mm³, what the surface encloses, always positive
  Vec3 size{0, 0, 0};     //!< mm, sides of the box around it
  Vec3 centre{0, 0, 0};   //!< mm, of that box
  int vertices = 0;
  int genus = 0;
  int within = -1;  //!< the innermost other component around it, or -1
};

//! All components, in the order of findComponents. Precondition: closed, manifold, oriented, no
//! self-intersections.
std::vector<Piece> listPieces(const Mesh& mesh);

//! Without the points that belong to no face; the others keep their order. A mesh made from it has no
//! isolated vertices, which would count as components.
TriangleSoup withoutLoosePoints(const TriangleSoup& soup);

}  // namespace handlebody
