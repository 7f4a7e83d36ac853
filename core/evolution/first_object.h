#pragma once
// What the first click alone means, as its surface is grown: what further clicks correct.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/evolution/object_range.h"
#include "core/object/object_model.h"

namespace handlebody {

//! A boundary is no further from the surface of a region that is of the same object than so many cells.
inline constexpr double kNextTo = 1.5;

//! A region, and the boundary between two intensities next to it, if there is one and it is of the same
//! object: then that is grown.
struct FirstObject {
  std::optional<ObjectModel> model;  //!< none where there is nothing but one intensity
  std::optional<ObjectChoice> boundary;
  std::shared_ptr<const RegionInCells> shown;  //!< what the boundary encloses; null if there is none
};

//! Of a model: ObjectFinder::find, with what was found before.
using FindModel = std::function<std::optional<ObjectModel>(const ObjectQuery&)>;

//! `query`: of one click, `seed`. Throws Cancelled.
FirstObject findFirstObject(const Volume& volume, const Seed& seed, const ObjectQuery& query,
                            const Parameters& parameters, const FindModel& find);

//! What a boundary encloses around the clicks, in the cells of a model; none if that is not much the same as
//! the model's region, or a click lies on the wrong side of it.
std::optional<RegionInCells> enclosedAs(const Volume& volume, const ObjectChoice& choice,
                                        const std::vector<Seed>& clicks, const ObjectModel& model);

//! A region that clicks have corrected is what they made of it, and no boundary of the image; nor is one
//! on another scale.
bool isItselfABoundary(const ObjectModel& model);

}  // namespace handlebody
