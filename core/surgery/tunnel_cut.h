#pragma once

namespace handlebody {

//! Which loop of a tunnel is cut along: the one around its handle (which goes), the one round the tunnel
//! (which is filled), or the shorter.
enum class TunnelCut { shorter, handle, tunnel };

}  // namespace handlebody
