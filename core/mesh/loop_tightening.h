#pragma once
// Loops across faces: shorter than along edges.

#include "core/mesh/loop_search.h"

namespace handlebody {

//! A place on a vertex (from = to) or on an edge.
struct SurfacePoint {
  int from = -1, to = -1;  //!< vertices
  double at = 0;           //!< part of the way, between 0 and 1
};

//! A simple closed loop straight across faces from each point to the next, which lie in one face.
struct SurfaceLoop {
  std::vector<SurfacePoint> points;
  double length = 0;  //!< mm
};

Vec3 positionOf(const Mesh& mesh, const SurfacePoint& p);

//! The loop and what lies within a few rings of it searched for a shorter one of the same class, by shortest
//! paths between vertices and kEdgePoints places on each edge.
SurfaceLoop tightened(const Mesh& mesh, const LoopClasses& classes, const EdgeLoop& loop);

inline constexpr int kEdgePoints = 3;

}  // namespace handlebody
