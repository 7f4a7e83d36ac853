#pragma once
// How the region around the seeds grows as the intensity level rises, and how strong its edge is at each
// level.

#include <vector>

#include "core/geometry/vec.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! A region that holds more than this part of the volume's border is the background.
inline constexpr double kBackgroundBorder = 0.5;

//! Region growth over equally spaced levels. All intensities are multiplied by `sign` first: +1 for a dark
//! object, -1 for a bright one, so that the region always grows upwards.
struct RegionGrowth {
  double lowest = 0;           //!< level of bin 0 (signed intensity)
  double step = 1;             //!< between bins
  std::vector<double> voxels;  //!< region size when the level has reached the end of the bin
  //! Part of the voxels on the faces of the grid that the region holds by then.
  std::vector<double> border;
  //! Mean gradient (signed intensity per mm) over the region's boundary at that level, smoothed.
  std::vector<double> edge;
  //! False: it was given up as a leak before it was twice as large as at its strongest edge.
  bool whole = true;
  double level(std::size_t bin) const { return lowest + step * (static_cast<double>(bin) + 0.5); }
};

//! Floods from the voxels nearest to `seeds` (continuous indices), lowest signed value first, up to the
//! signed level `highest` or until the region has clearly leaked.
RegionGrowth growRegion(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                        double lowest, double highest);

//! True if a growth in this volume does not depend on what others have had made smooth of it before, so that
//! several may go on at once. In a large volume it is given up as a leak by how much of it has been smoothed.
bool growsByItself(const SmoothedVolume& volume);

}  // namespace handlebody
