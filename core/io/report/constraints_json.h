#pragma once
// How walls, vetoes, pins and limits of the topology stand in JSON: "constraints" of a request. Only sources
// include this header (see json.h).

#include "core/evolution/constraints.h"
#include "core/io/report/json.h"

namespace handlebody {

//! {"centre", "normal", "radius"}.
Json discToJson(const WallDisc& disc);

//! {"walls": [{"centre", "radius"}], "wall_discs": [as above], "wall_map": {"path", "sha256"}, "vetoes":
//! [{"iteration", "place"}], "components", "genus", "allowed": [place], "asks", "kept": [place], "pins":
//! [{"centre", "radius", "iteration"}], "edits": [{"iteration", "kind", "place"}], with "loop" for a tunnel,
//! "radius", "to" or "normal" and "keep"}, each only where there are any; the path is null if anonymous.
Json constraintsToJson(const Constraints& constraints);

//! The inverse; the voxels of the label map are not read. Throws UsageError.
Constraints constraintsFromJson(const JsonField& json);

}  // namespace handlebody
