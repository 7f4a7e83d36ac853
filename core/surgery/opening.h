#pragma once
// Opening the mesh around a set Λ so that the boundary consists of simple closed polygons (paper, section 4
// and Figure 7).

#include <optional>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! What is taken out of the mesh, and the holes that this leaves.
struct Opening {
  std::vector<int> lambda;  //!< vertices that go, ascending
  std::vector<int> faces;   //!< faces that go, ascending: the stars of lambda
  //! The boundary polygons; each runs in the direction in which the faces that close the hole hold its edges.
  std::vector<std::vector<int>> loops;
  bool isRefined = false;  //!< the mesh was refined for it: the loops are of new vertices
};

//! Λ together with its neighbours.
std::vector<int> enlarge(const Mesh& mesh, const std::vector<int>& lambda);

//! Plans the opening around Λ; vertices that would be left without a face ("not real" enclosed parts) join Λ.
//! None if the boundary would not be a disjoint union of simple polygons. The mesh is not changed.
std::optional<Opening> planOpening(const Mesh& mesh, std::vector<int> lambda);

//! As planOpening, but where the boundary is not simple the mesh is refined first: new vertices on the
//! middles of the edges between Λ and its neighbours (Figure 7); their polygon bounds a regular neighbourhood
//! of Λ and so is simple. The surface stays where it is.
Opening openWithRefinement(Mesh& mesh, const std::vector<int>& lambda);

}  // namespace handlebody
