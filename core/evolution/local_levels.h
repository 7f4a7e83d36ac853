#pragma once
// The boundary level of an object place by place, from the edges of the object itself.

#include <optional>
#include <vector>

#include "core/evolution/level_field.h"
#include "core/evolution/neck.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! Starts from one `level` and goes back and forth: the region that the levels enclose around the seeds, and
//! the levels that the edges of this region suggest, until they stay as they are. A level is the mean of the
//! intensities across the boundary, weighted with the square of the steps between neighbouring voxels:
//! between two plateaus the half-way level, wherever the region's boundary lay in the ramp between them. So
//! the surface ends half-way up its own edge everywhere. Where the region ends without an edge the steps are
//! small, and the levels of the nearest edges go on.
//! The weighted mean is that of Kittler, Illingworth and Föglein (1985), "Threshold selection based on a
//! simple image statistic", taken locally and at the boundary of a region only.
//! `seeds`: continuous indices; `sign`: +1 for a dark object, -1 for a bright one; `contrast`: between object
//! and level, intensity units.
//! `expectedVoxels`: size of the region at `level`.
struct ObjectBoundary {
  LevelField levels;
  std::optional<NeckCut> neck;
};
ObjectBoundary findObjectBoundary(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                                  double level, double contrast, double expectedVoxels);

//! With a constant level, lowered towards that of the object until a neck shows.
std::optional<ObjectBoundary> boundaryWithNeck(const SmoothedVolume& volume, const std::vector<Vec3>& seeds,
                                               double sign, double object, double level);

}  // namespace handlebody
