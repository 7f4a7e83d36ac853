#pragma once
// Tunnels, components and edits of a mesh in JSON. Only sources include this header, as json.h.

#include "core/io/report/json.h"
#include "core/mesh/pieces.h"
#include "core/surgery/mesh_edits.h"

namespace handlebody {

//! One object per tunnel: {"position": [x, y, z] in mm, "handle_loop_mm", "tunnel_loop_mm",
//! "handle_loop_bounds", "tunnel_loop_bounds", "component"}.
Json tunnelsToJson(const TunnelList& list);
//! One object per component: {"cavity", "volume_ml", "size_mm", "centre", "genus", "vertices", "within"}; the
//! last is the place in this list of the innermost component around it, or null.
Json piecesToJson(const std::vector<Piece>& pieces);
//! {"kind", "location", "loop_mm" or null, "volume_before_ml", "volume_after_ml", "before", "after"}, the
//! last two with "components", "euler" and "genus".
Json editToJson(const Event& edit);
//! {"position", "handle_loop_mm", "tunnel_loop_mm"}
Json openTunnelToJson(const OpenTunnel& tunnel);

}  // namespace handlebody
