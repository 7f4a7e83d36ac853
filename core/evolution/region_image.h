#pragma once
// The image of an object that is a region: its surface follows the image near that of the region.

#include <memory>
#include <optional>

#include "core/evolution/object_image.h"
#include "core/evolution/object_range.h"
#include "core/object/object_model.h"

namespace handlebody {

//! Along the half-way levels of the edges on the region's surface, no more than a cell away from it.
//! `smoothing`: mm, none: the least that is enough for the noise.
std::shared_ptr<const ObjectImage> imageOfRegion(const Volume& volume, const ObjectModel& model,
                                                 std::optional<double> smoothing,
                                                 std::shared_ptr<const FieldOfView> view);

//! A boundary next to the region, no further outwards from the region's own surface than it may have moved:
//! it could leak where it has a gap of less than a voxel.
std::shared_ptr<const ObjectImage> imageOfBoundary(const ObjectChoice& choice, const ObjectModel& model);

//! A region that further clicks have corrected: near what they changed as imageOfRegion, but where its
//! surface has hardly moved along the same level as before; elsewhere as before.
std::shared_ptr<const ObjectImage> imageOfCorrected(std::shared_ptr<const ObjectImage> before,
                                                    const ObjectModel& model);

//! The cells of the model that hold the object as the image has it.
RegionInCells shownCells(const ObjectImage& image, const ObjectModel& model);

}  // namespace handlebody
