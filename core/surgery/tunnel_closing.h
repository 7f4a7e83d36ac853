#pragma once
// Cuts along loops: the surface is opened along a loop and both sides are capped.

#include <optional>
#include <vector>

#include "core/mesh/topology.h"
#include "core/mesh/tunnels.h"

namespace handlebody {

//! The mesh after a cut, and what it changed.
struct LoopCut {
  Mesh mesh;
  TopologyNumbers before, after;  //!< counted; the genus has fallen by one, the Euler number risen by two
  std::vector<int> touched;       //!< vertex slots beside the change, of either mesh, ascending
};

//! Cuts along the loop and caps both sides with membranes, so that a tunnel is closed (a tunnel loop) or a
//! handle taken away (a handle loop). Where the caps would meet the surface or each other, a narrower opening
//! and plainer caps are tried. None if nothing fits, or if the loop separates the surface.
//!
//! What is given is valid if the mesh was: the structure is checked as a whole, all faces that are new or
//! beside them exactly against all others, the topology counted against what the cut predicts, and no
//! component lies in another's way that did not before. Precondition: the mesh has no self-intersections, and
//! the loop's points lie on vertices and edges of it.
std::optional<LoopCut> cutAlong(const Mesh& mesh, const SurfaceLoop& loop);

//! Cuts along the tunnel's loop of that kind or, where caps do not fit there, along another one of its class.
std::optional<LoopCut> closeTunnel(const Mesh& mesh, const Tunnel& tunnel, LoopKind kind);

}  // namespace handlebody
