#pragma once

namespace handlebody {

//! What a cut by a plane leaves: both sides, that to which the normal points, or the other one.
enum class KeptSide { both, positive, negative };

}  // namespace handlebody
