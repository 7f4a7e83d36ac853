#pragma once
// Euclidean distances on a grid.

#include <cstdint>
#include <limits>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! Distance (mm) of every cell's centre to the nearest centre of a cell with mask = 1; infinite if there is
//! none. Exact and linear in the cells: Felzenszwalb and Huttenlocher (2012), "Distance transforms of sampled
//! functions". Only what is no further than `limit` (mm) counts; the rest is told to be further than that. It
//! does not depend on the number of threads.
std::vector<float> distanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                              const std::vector<std::uint8_t>& mask,
                              double limit = std::numeric_limits<double>::infinity(), int threads = 1);

//! The largest of these distances that is finite; 0 if none is.
double greatestDistanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                          const std::vector<std::uint8_t>& mask);

}  // namespace handlebody
