#pragma once
// Edits of a finished mesh: tunnels closed, pieces removed, cavities filled. Each leaves a valid mesh or the
// mesh as it was.

#include <string>
#include <vector>

#include "core/surgery/tunnel_closing.h"

namespace handlebody {

enum class EditKind { tunnelClosed, handleCut, componentRemoved, cavityFilled };
//! "tunnel closed", "handle cut" … as in reports.
const char* editKindName(EditKind kind);

//! One change, as it was made.
struct MeshEdit {
  EditKind kind = EditKind::tunnelClosed;
  Vec3 location{0, 0, 0};                    //!< mm: of the tunnel, or the middle of the component's box
  double length = 0;                         //!< of the loop that was cut along, mm; 0 for components
  double volumeBefore = 0, volumeAfter = 0;  //!< of the whole mesh, mm³
  TopologyNumbers before, after;             //!< counted, and as predicted
};

//! A tunnel that should have been closed and could not be.
struct OpenTunnel {
  Vec3 location{0, 0, 0};  //!< mm
  double handleLength = 0, tunnelLength = 0;
};

//! Which loop of a tunnel is cut along.
enum class TunnelCut { shorter, handle, tunnel };

struct TunnelsClosed {
  std::vector<MeshEdit> edits;
  std::vector<OpenTunnel> open;  //!< caps fit along neither loop, nor beside it
  int unlisted = 0;              //!< see TunnelList
};

//! Closes every tunnel whose loop is shorter than `shorterThan` mm: `shorter` looks at the shorter loop of
//! the pair, and where that does not fit at the other one if it is short enough, too. The shortest first;
//! what is left is searched for tunnels again until none is short enough. Precondition: as for findTunnels.
TunnelsClosed closeTunnels(Mesh& mesh, double shorterThan, TunnelCut cut = TunnelCut::shorter);

//! Removes the component, with all that lies in it. Precondition: as for surroundingComponents.
std::vector<MeshEdit> removeComponent(Mesh& mesh, int component);

//! Removes everything but the body of the largest volume (cavities taken off) with its cavities.
std::vector<MeshEdit> keepLargest(Mesh& mesh);

//! Removes all cavities, with all that lies in them.
std::vector<MeshEdit> fillCavities(Mesh& mesh);

}  // namespace handlebody
