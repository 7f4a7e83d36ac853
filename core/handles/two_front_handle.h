#pragma once
// Handles that join two boundary loops (k = 2) of any sizes (paper, section 3; engine's own dynamic
// programming).

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

//! The best handles for two loops, shortest total edge length first: for each way to start (which vertex of
//! the second loop is joined to vertex 0 of the first) the strip of least total length, found as a shortest
//! cyclic monotone lattice path; at most `limit` distinct ones. `first` and `second` are the boundary loops
//! of the opened mesh, each in the order in which its boundary half-edges run when seen from the missing
//! side: a handle face that uses the loop edge (v_i, v_i+1) holds it in exactly that direction, so that
//! handle and opened mesh fit with consistent orientation. No handle has a repeated edge or face (it is a
//! simplicial complex by itself). Empty if none exists (a loop of fewer than 3 vertices).
std::vector<HandleCandidate> bestTwoFrontHandles(std::span<const Vec3> first, std::span<const Vec3> second,
                                                 int limit);

}  // namespace handlebody
