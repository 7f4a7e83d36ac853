#pragma once
// Simplicial homology over the integers of a small 2-complex (paper, section 3, Theorem 7).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

struct Homology {
  //! The ranks of H_0, H_1, H_2.
  std::array<int, 3> betti{};
  //! The orders (> 1, each divides the next) of the cyclic summands of H_1. H_0 and H_2 have none.
  std::vector<std::int64_t> torsion;
  //! If H_2 is Z: one coefficient per face as it is oriented, of a generator; otherwise empty.
  std::vector<std::int64_t> generator;
};

//! Homology of the complex of these triangles with all their edges and vertices. The matrices are dense:
//! meant for handles and their caps, up to some hundred faces. Faces are oriented as given; a face that
//! occurs twice counts as two cells (then it is no simplicial complex). Precondition: three different
//! vertices per face. Throws UsageError if the matrices do not fit into 64-bit integers.
Homology homology(std::span<const Triangle> faces);

//! Whether the triangles form a 2-sphere: Theorem 7 (H_0 = Z, H_1 = 0, H_2 = Z with a generator that has
//! the coefficient 1 or -1 on every face), and every edge has exactly two faces. The paper leaves the second
//! condition out, but the first alone also holds for a sphere in which two edges at one vertex are glued to
//! each other. Together they suffice: a connected surface whose pinched vertices are pulled apart is a
//! closed orientable surface by H_2, and each pinch, like each hole, would add to the rank of H_1.
bool isSphere(std::span<const Triangle> faces);

}  // namespace handlebody
