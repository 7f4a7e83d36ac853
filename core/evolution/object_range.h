#pragma once
// Which intensities belong to the object, found from the image around the seeds.

#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/level_field.h"
#include "core/evolution/neck.h"
#include "core/evolution/parameters.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! What was chosen, and on what grounds.
struct ObjectChoice {
  ObjectKind object = ObjectKind::dark;
  IntensityRange range{};
  double level = 0;     //!< median of the smoothed image in the seeds
  double contrast = 0;  //!< |boundary level - level|: scale of the image force
  std::shared_ptr<const SmoothedVolume> volume;
  //! The finite end of the range place by place; null with a given range, which holds everywhere.
  std::shared_ptr<const LevelField> levels;
  //! Where the object is cut off at a neck; null if it is not.
  std::shared_ptr<const NeckCut> neck;
  //! Where the volume holds no image; null if there is no such place, or a seed lies in it.
  std::shared_ptr<const FieldOfView> view;
};

//! Throws UsageError if there is none or a radius makes no sense, SeedError if one lies outside of the grid.
void requireSeedsInside(const Grid& grid, const std::vector<Seed>& seeds);

//! What is likely to be the object, where a search for its boundary begins.
struct BoundaryStart {
  ObjectKind object = ObjectKind::dark;
  LevelField levels;      //!< half-way up the edges on it
  double voxels = 0;      //!< of it
  bool isOpened = false;  //!< it hangs on to more of the same by narrow passages
};

//! The boundary around the seeds next to a start: from its levels on, or from lower ones where these let the
//! region out of itself, refined place by place (object_boundary.h). Smoothing, if `parameters` leave it
//! open, is the least that brings the noise in the seeds well below the contrast. None if all levels leak, a
//! seed lies outside, or it fills the field of view though its kind was not asked for. Precondition: there
//! are seeds, all in the volume.
std::optional<ObjectChoice> objectNextTo(const BoundaryStart& start, const Volume& volume,
                                         const std::vector<Seed>& seeds, const Parameters& parameters);

//! Chooses what `parameters` leaves open. The boundary level is the one at which the connected region that
//! grows from the seeds has the strongest mean edge; a level after the region has leaked into another one
//! counts only if its edge is much stronger. From there on the level is refined place by place
//! (object_boundary.h). Smoothing is the least that brings the noise in the seeds well
//! below the contrast. Throws SeedError (seed outside the volume or not in an object), UsageError (range
//! without voxels).
ObjectChoice chooseObject(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters);

}  // namespace handlebody
