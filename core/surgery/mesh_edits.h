#pragma once
// Edits of a mesh: tunnels closed, pieces removed, cavities filled. Each leaves a valid mesh or the mesh as
// it was, and tells what it did as events with `edit` (its measures); their iteration is left at 0.

#include <string>
#include <vector>

#include "core/surgery/event.h"
#include "core/surgery/tunnel_closing.h"
#include "core/surgery/tunnel_cut.h"

namespace handlebody {

//! A tunnel that should have been closed and could not be.
struct OpenTunnel {
  Vec3 location{0, 0, 0};  //!< mm
  double handleLength = 0, tunnelLength = 0;
};

struct TunnelsClosed {
  std::vector<Event> edits;
  std::vector<OpenTunnel> open;  //!< caps fit along neither loop, nor beside it
  int unlisted = 0;              //!< see TunnelList
};

//! Closes every tunnel whose loop is shorter than `shorterThan` mm: `shorter` looks at the shorter loop of
//! the pair, and where that does not fit at the other one if it is short enough, too. The shortest first;
//! what is left is searched for tunnels again until none is short enough. Precondition: as for findTunnels.
TunnelsClosed closeTunnels(Mesh& mesh, double shorterThan, TunnelCut cut = TunnelCut::shorter);

//! One tunnel that was closed.
struct TunnelClosed {
  Event event;
  std::vector<int> touched;  //!< as LoopCut::touched
};

//! Closes the tunnel, one of findTunnels(mesh); where caps do not fit along the shorter loop, along the other
//! one. None if they fit nowhere.
std::optional<TunnelClosed> closeOneTunnel(Mesh& mesh, const Tunnel& tunnel, TunnelCut cut);

//! Removes the component, with all that lies in it. Precondition: as for surroundingComponents.
std::vector<Event> removeComponent(Mesh& mesh, int component);

//! Removes everything but the body that the component bounds, with its cavities.
std::vector<Event> keepBodyOf(Mesh& mesh, int component);

//! Removes everything but the body of the largest volume (cavities taken off) with its cavities.
std::vector<Event> keepLargest(Mesh& mesh);

//! Removes all cavities, with all that lies in them.
std::vector<Event> fillCavities(Mesh& mesh);

}  // namespace handlebody
