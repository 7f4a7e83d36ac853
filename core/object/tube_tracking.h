#pragma once
// A tube followed from a click both ways, plane by plane: the middle of one outline is the start of the next
// (Wink, Niessen and Viergever 2000, "Fast delineation and visualization of vessels in 3-D angiographic
// images").

#include <optional>

#include "core/object/cross_section.h"

namespace handlebody {

//! Planes across a tube, one after the other, from end to end.
struct Tube {
  std::vector<CrossSection> sections;
  std::vector<Vec3> goesOn;    //!< mm: where it leaves the image
  double length() const;       //!< mm, from the first plane to the last
  double usualRadius() const;  //!< mm, the median
};

//! The tube through the first click inside, looked for at `radius` mm. A further click inside that lies past
//! an end of it leads it on; one outside ends it, or keeps its outlines on this side. None if it is no longer
//! than what a star-shaped surface holds. Throws Cancelled.
std::optional<Tube> trackTube(const WorkImage& work, const std::vector<CellClick>& inside,
                              const std::vector<CellClick>& outside, double radius,
                              const ObjectPolicy& policy);

}  // namespace handlebody
