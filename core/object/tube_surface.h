#pragma once
// What is long and round (vessels, spinal cord, airways) meets every plane across it in a star-shaped area,
// also where it is neither told from its surroundings by intensity nor star-shaped as a whole. Tracked from a
// click both ways, plane by plane: the middle of one area is the start of the next (the scheme of Wink,
// Niessen and Viergever 2000, "Fast delineation and visualization of vessels in 3-D angiographic images").

#include "core/object/region.h"

namespace handlebody {

//! Tubes through the first click, from starts of several radii, those that differ; each as the star-shaped
//! region of a search of its own in a box around it. `like`: whose noise and level they have. A tube that
//! leaves a click on the wrong side is left out.
std::vector<std::unique_ptr<ClickSearch>> tubeSearches(const WorkImage& work, const ClickSearch& like,
                                                       const std::vector<CellClick>& inside,
                                                       const std::vector<CellClick>& outside,
                                                       const ObjectPolicy& policy, int threads);

}  // namespace handlebody
