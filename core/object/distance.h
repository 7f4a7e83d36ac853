#pragma once
// Euclidean distances on a grid.

#include <cstdint>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! Distance (mm) of every cell's centre to the nearest centre of a cell with mask = 1; infinite if there is
//! none. Exact and linear in the cells: Felzenszwalb and Huttenlocher (2012), "Distance transforms of sampled
//! functions".
std::vector<float> distanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                              const std::vector<std::uint8_t>& mask);

}  // namespace handlebody
