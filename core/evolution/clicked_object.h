#pragma once
// What the clicks mean (core/object), as the contour sees it.

#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/object/object_model.h"

namespace handlebody {

//! The image term of an object and what is told of it.
struct ClickedObject {
  std::shared_ptr<const ObjectImage> image;
  ObjectKind kind = ObjectKind::dark;
  IntensityRange range{};
  double smoothing = 0;   //!< mm
  double neckRadius = 0;  //!< mm: passages narrower than this are cut; 0 = none
  std::vector<ObjectCandidate> candidates;
  int candidate = 1;
  bool isCloseChoice = false;
};

//! From clicks to the object: the strongest boundary around the seeds (object_range.h) where it is that of
//! the likeliest region, else the region itself, whose surface follows the image within a cell. Throws as
//! chooseObject; SeedError also if there is nothing but one intensity, or no image, at the first click.
ClickedObject findClickedObject(const Volume& volume, const std::vector<Seed>& clicks,
                                const Parameters& parameters);

}  // namespace handlebody
