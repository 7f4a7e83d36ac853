#pragma once
// Leaks: a region that passes from the seeded structure through a narrow neck into something far larger.

#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/object_region.h"

namespace handlebody {

//! Where the object ends without an edge of its own in the image: voxels that it must not enter.
class Barrier {
 public:
  //! A box of voxels from `low` on; 1 = closed.
  Barrier(const std::array<int, 3>& low, const std::array<int, 3>& size,
          const std::vector<unsigned char>& closed);
  //! -1 within what is closed, +1 away from it; smooth between. At a continuous voxel index.
  double openness(const Vec3& index) const;

 private:
  std::array<int, 3> low_, size_;
  std::vector<float> values_;
};

//! A region cut at its neck.
struct NeckCut {
  double neckRadius = 0;            //!< mm: of the widest ball that passes to what was cut off
  bool widens = false;              //!< no neck: cut where the structure grows wider than neckRadius
  double structureRadius = 0;       //!< mm: of the ball that fits into the seeded structure
  double widestBehind = 0;          //!< mm: of the widest ball behind the neck
  double keptVolume = 0;            //!< mm³
  double cutVolume = 0;             //!< mm³; a lower bound if the region was not whole
  std::vector<unsigned char> kept;  //!< for each voxel of the region: 1 = on the side of the seeds
  std::shared_ptr<const Barrier> barrier;
};

//! Looks for the neck through which the region leaks: the widest path (largest ball all along it) from the
//! seeds to each voxel tells how wide a neck lies before it. A structure that opens with hardly a neck into
//! something hundreds of times larger is cut where it grows wider than it is at the seeds. None if nothing is
//! so much larger than what lies before it that the seeds can hardly have meant it. `seeds`: continuous
//! indices.
std::optional<NeckCut> findNeck(const Grid& grid, const ObjectRegion& region, const std::vector<Vec3>& seeds);

}  // namespace handlebody
