#pragma once
// Handles that join two boundary loops (k = 2) of any sizes (paper, section 3; engine's own dynamic
// programming).

#include <array>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! A handle for two loops: faces over the vertex indices 0 … m1-1 (first loop) and m1 … m1+m2-1 (second
//! loop).
struct HandleCandidate {
  std::vector<Triangle> faces;  //!< m1 + m2 faces of Type 1
  double length = 0;            //!< sum of the lengths of the edges between the loops, mm
};

//! A pair of vertices that must not be joined: an index into the first loop, one into the second.
using LoopPair = std::array<int, 2>;

//! The best handles for two loops, shortest total edge length first: for each apex that the edge (0, 1) of
//! the first loop can have in the second, the strip of least total length, found as a shortest cyclic
//! monotone lattice path (O(p·q) each). These classes divide the whole family, so the first result is the
//! best of all handles for k = 2; at most `limit` are returned, and they are distinct. `first` and `second`
//! are the boundary loops of the opened mesh (mm), each in the order in which its boundary half-edges run
//! when seen from the missing side: a handle face that uses the loop edge (v_i, v_i+1) holds it in exactly
//! that direction, so that handle and opened mesh fit with consistent orientation. No handle has a repeated
//! edge or face (it is a simplicial complex by itself), and none has an edge of `forbidden`: name there the
//! pairs that the opened mesh already joins by an edge. Empty if no handle exists: a loop of fewer than 3
//! vertices, too many forbidden pairs, or coordinates that are not finite. Precondition: the loops share no
//! vertex, and the forbidden indices are within the loops.
std::vector<HandleCandidate> bestTwoFrontHandles(std::span<const Vec3> first, std::span<const Vec3> second,
                                                 int limit, std::span<const LoopPair> forbidden = {});

}  // namespace handlebody
