#pragma once
// The tunnels of a surface, each as a pair of short loops that meet.

#include <optional>
#include <vector>

#include "core/mesh/loop_tightening.h"
#include "core/mesh/validity.h"

namespace handlebody {

//! A handle of the surface; its tunnel is what lies beside the handle.
struct Tunnel {
  //! Around the handle: bounds a surface in the body. Cutting along it takes the handle away.
  SurfaceLoop handle;
  //! Round the tunnel: bounds a surface outside of the body. A membrane in it closes the tunnel.
  SurfaceLoop tunnel;
  //! Along a knotted handle (or tunnel) no short loop bounds outside (inside) of the body: then that loop is
  //! the shortest one that meets the other, and bounds on neither side.
  bool handleBounds = true, tunnelBounds = true;
  Vec3 position;      //!< mm: the middle of the shorter loop that bounds
  int component = 0;  //!< as in findComponents

  const SurfaceLoop& shorter() const {
    return !tunnelBounds || (handleBounds && handle.length < tunnel.length) ? handle : tunnel;
  }
};

struct TunnelList {
  std::vector<Tunnel> tunnels;  //!< by the length of the shorter loop, ascending
  //! Tunnels for which no pair of loops was found: of components of a genus above kMaxListed, or that fold
  //! so tightly that their loops cannot be told apart.
  int unlisted = 0;
};

//! A component of a greater genus is not searched: time and memory grow with the square of it.
inline constexpr int kMaxListed = 400;

//! All tunnels of a closed, manifold, oriented mesh without self-intersections. The loops of each kind are
//! independent in the first homology (modulo 2) and short: the shortest through base points all over the
//! surface and on the loops found so far, tightened across faces. A handle loop and the tunnel loop of the
//! same pair meet an odd number of times, mostly once. Throws Cancelled (cancellation.h).
//! Each component is looked at alone: a loop that bounds
//! outside of its component may run around another one. The vertices of the loops are slots of the mesh.
//! On up to so many threads (0: as many as the machine has), on which the list does not depend.
TunnelList findTunnels(const Mesh& mesh, int threads = 0);

//! The same of a mesh as it is written, where that takes some seconds at most: none if the certificate does
//! not pass, or the mesh has more than kQuickVertices vertices or kQuickGenus tunnels.
std::optional<TunnelList> findTunnelsQuickly(const TriangleSoup& mesh, const Certificate& certificate,
                                             int threads = 0);

inline constexpr int kQuickVertices = 100000, kQuickGenus = 40;

//! Other loops of the class of the tunnel's loop of that kind, along edges: through places all around the
//! other loop of the pair, the nearest to the first first. For cuts that do not fit where the loop is
//! shortest.
std::vector<SurfaceLoop> loopsBeside(const Mesh& mesh, const Tunnel& tunnel, LoopKind kind);

}  // namespace handlebody
