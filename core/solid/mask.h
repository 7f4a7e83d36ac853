#pragma once
// An object as voxels: those of a label map that have its value, in the box around them.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

struct Mask {
  Grid grid;                         //!< cut to the object; no voxels at all if there is no object
  std::vector<std::uint8_t> inside;  //!< 1 or 0 per voxel, x fastest

  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(grid.size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(grid.size[0]) +
           static_cast<std::size_t>(x);
  }
  //! False beyond the grid.
  bool holds(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < grid.size[0] && y < grid.size[1] && z < grid.size[2] &&
           inside[at(x, y, z)] != 0;
  }
  //! Whether the voxel that a point (mm) lies in is inside.
  bool holds(const Vec3& world) const;
  std::size_t count() const;
};

//! The voxels whose value is `label`; without one, all that are not 0.
Mask maskOf(const Volume& labels, std::optional<double> label);

//! Where several masks hold a voxel, only the one with the fewest voxels keeps it, of equal ones the last.
//! How many each has lost. Preconditions: their voxels are those of one grid, each has one inside, and there
//! are no more than 65,535.
std::vector<std::size_t> leaveToSmaller(std::vector<Mask>& masks);

//! False if a voxel has a value that is no whole number: an image, not a label map.
bool holdsWholeNumbers(const Volume& volume);

}  // namespace handlebody
