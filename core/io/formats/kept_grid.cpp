// Whether a written volume lies where it should. Not beside ITK's headers: they bring another Eigen, and
// products of ours, which the linker takes for theirs, crash.

#include "core/io/formats/volume_keys.h"
#include "core/io/lowered.h"

namespace handlebody {

namespace {

//! Of a corner, mm. NIfTI keeps its geometry in single precision, and of its quaternion one part is the root
//! of what the others leave: half a thousandth where that is near 0. The others write all digits.
double roundingOf(const std::string& path, const Grid& grid, double diagonal) {
  const bool isNifti = lowered(path).ends_with(".nii") || lowered(path).ends_with(".nii.gz");
  return (isNifti ? 2e-3 : 1e-6) * diagonal + 1e-6 * grid.origin.norm();
}

}  // namespace

bool isGridKept(const Grid& back, const Grid& meant, const std::string& path) {
  const auto corner = [](const Grid& grid, int which) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) index[axis] = (which >> axis & 1) * (grid.size[axis] - 1.0);
    return grid.toWorld(index);
  };
  const double most = roundingOf(path, meant, (corner(meant, 7) - corner(meant, 0)).norm());
  for (int which = 0; which < 8; ++which)
    if (!((corner(back, which) - corner(meant, which)).norm() <= most)) return false;
  return true;
}

}  // namespace handlebody
