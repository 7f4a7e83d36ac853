#pragma once

#include <array>

#include "core/solid/surface_distance.h"

namespace handlebody {

//! How far two surfaces are from each other, over the area of each (surface_distance.h): the thickness of the
//! wall between an inner and an outer one.
struct WallThickness {
  double sampling = 0;  //!< mm
  DirectedDistances fromFirst, fromSecond;
};

//! Both have triangles; where they cross the least is 0 but for the sampling.
WallThickness wallThickness(const TriangleSoup& first, const TriangleSoup& second, int threads = 1);

//! The surfaces of a body apart: its outer ones, and those of its cavities (no triangles if there is none).
//! Precondition: closed, manifold, oriented.
std::array<TriangleSoup, 2> outerAndInner(const TriangleSoup& mesh);

}  // namespace handlebody
