#pragma once
// Sensitivity in JSON. Only sources include this header, as json.h.

#include "core/io/report/json.h"
#include "core/sensitivity/sensitivity.h"

namespace handlebody {

//! "sensitivity" of a report: "perturbed_by" ("click_voxels", "smoothing", "noise"), "runs" (each "failure"
//! or "volume_mm3", "components", "genus", "mean_distance_mm"), "grown", "same_topology", "volume_mm3"
//! ("mean", "standard_deviation", "least", "most") and "spread_mm" ("mean", "percentile_95", "largest"); the
//! last two are null where no run left a surface.
Json sensitivityToJson(const Sensitivity& s);

}  // namespace handlebody
