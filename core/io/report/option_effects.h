#pragma once
// Options of a growth that others leave without any effect: who gives one means something by it.

#include <string>
#include <vector>

#include "core/evolution/constraints.h"

namespace handlebody {

//! Throws OptionError for the first of `names`, as on the command line ("--edge-length"), that can have no
//! effect: with a range, on an object that is given, on a start that is a mesh. `constraints`: what the same
//! options have set.
void requireEffect(const std::vector<std::string>& names, const Constraints& constraints);

//! Throws UsageError where an object that is given breaks its own constraints: a wall lies over it, or it has
//! more components or tunnels than it may; edits may yet take these away. Precondition: its surface and the
//! label map of its walls have been read. Throws as requireSensible.
void requireGivenHolds(const Constraints& constraints, const Grid& grid);

}  // namespace handlebody
