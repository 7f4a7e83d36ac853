#pragma once
// What the first click alone means, as its surface is grown: what further clicks correct.

#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/evolution/object_range.h"
#include "core/object/object_model.h"

namespace handlebody {

//! A region, and the boundary between two intensities next to it if there is one and it is of the same
//! object: then that is grown.
struct FirstObject {
  std::optional<ObjectModel> model;  //!< none where there is nothing but one intensity
  std::optional<ObjectChoice> boundary;
  std::shared_ptr<const ObjectImage> image;  //!< of the boundary
};

//! `model`: of that one click. Throws Cancelled.
FirstObject firstObjectOf(const Volume& volume, const Seed& seed, const Parameters& parameters,
                          const ObjectModel& model);

//! True if the boundary encloses much the same as the model's region, and every click lies on its side of it.
bool isSameObject(const Volume& volume, const ObjectChoice& choice, const std::vector<Seed>& clicks,
                  const ObjectModel& model);

//! A region that clicks have corrected is what they made of it, and no boundary of the image; nor is one
//! on another scale.
bool isItselfABoundary(const ObjectModel& model);

}  // namespace handlebody
