#pragma once
// Pairs of faces without a common vertex, by way of vertices that are near each other.

#include "core/collision/broad_phase.h"
#include "core/collision/detection_workspace.h"
#include "core/collision/vertex_levels.h"
#include "core/collision/vertex_pairs.h"

namespace handlebody {

//! Faces without a common vertex. If two such triangles intersect, an edge of one of them, PP', meets the
//! other, T, in a point Q, and P may be chosen such that |PQ| ≤ |PP'|/2. Let Q = Σ λi Ti with the vertices Ti
//! of T, and let C be the centre of the smallest circle that holds T, r its radius. Then
//!   Σ λi |P-Ti|² = |P-Q|² + Σ λi |Q-Ti|² ≤ |P-Q|² + Σ λi |C-Ti|² ≤ |PP'|²/4 + r²
//! and r² ≤ t²/3 with the longest edge t of T (Jung). So some Ti is that near to P. With the longest edge s
//! of the mesh for PP' and t, this proves Theorem 4 for sqrt(7/12)·s, which is sharp, instead of sqrt(2/3)·s.
//! It says more, too: P is within |PP'|/2 of T, which hardly any neighbour is. So what is looked for are
//! pairs of a vertex P and a triangle T.
//! No edge of the mesh but those of the two triangles is in the proof, so it holds for graded meshes place by
//! place: with a size s(v) of each star, not below its edges at v and √3 times its circles,
//!   |P-Ti|² ≤ s(P)²/4 + s(Ti)²/3 ≤ 7/12 · max(s(P), s(Ti))²
//! and levels of vertices by the octave of s(v) find all such pairs (vertex_levels.h).
class SeparateFaces {
 public:
  void use(BroadPhase phase) {
    nearPairs_.use(phase);
    levelPairs_.use(phase);
  }
  //! False, and nothing is tested, if the vertices are too crowded for that. Precondition: work.vertices have
  //! been measured.
  bool test(DetectionWorkspace& work);

 private:
  VertexPairs nearPairs_;
  LevelPairs levelPairs_;  // instead, where the sizes of the stars differ much
};

}  // namespace handlebody
