#pragma once
// Where edges have gaps and intensities overlap (ultrasound, touching organs), a surface that every ray from
// its middle meets once and that bends little still finds its way: Li, Wu, Chen and Sonka (2006), "Optimal
// surface segmentation in volumetric images", on a sphere, with the two regions of Chan and Vese.

#include "core/object/region.h"

namespace handlebody {

//! A star-shaped part of a box of cells.
struct StarRegion {
  std::vector<std::uint8_t> inside;  //!< per cell
  double agreement = 0;              //!< part of the starts that end in it
};

//! Surfaces around clicks, from starts of several sizes; those that differ. `values` smoothed, `padding`: no
//! image. A surface that leaves a click on the wrong side is left out.
std::vector<StarRegion> starRegions(const CellImage& image, const std::vector<float>& values,
                                    const std::vector<CellClick>& inside,
                                    const std::vector<CellClick>& outside, const ObjectPolicy& policy,
                                    int threads);

}  // namespace handlebody
