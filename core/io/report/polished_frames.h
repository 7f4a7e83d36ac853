#pragma once
// Polishing (core/polish) of a surface over time, frame by frame as it is written. It is carried as it grew.

#include <functional>
#include <map>

#include "core/io/report/over_time_report.h"

namespace handlebody {

//! Betters the mesh of each frame that has one, within the limits of a single one (polishOptions);
//! `over.polish` tells of all of them then. Those of which it tells already stay as they are. Volumes, curve
//! and drifts stay those of the surface that was carried. `polishing` gets the number of each frame before
//! its turn. Precondition: the meshes are of certifiedForExport. Throws Cancelled (cancellation.h).
void polishFrames(OverTimeReport& over, const std::function<void(int frame)>& polishing = {});

//! What was done to all of them, as if they were one mesh. Without the places that are left.
PolishReport together(const std::map<int, PolishReport>& frames);

}  // namespace handlebody
