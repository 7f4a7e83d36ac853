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
  Barrier(const std::array<int, 3>& low, const std::array<int, 3>& size, const VoxelMarks& closed);
  //! -1 within what is closed, +1 away from it; smooth between. At a continuous voxel index.
  double openness(const Vec3& index) const;

 private:
  std::array<int, 3> low_, size_;
  std::vector<float> values_;
};

//! A region cut at its neck.
struct NeckCut {
  double neckRadius = 0;       //!< mm: of the widest ball that passes to what was cut off
  bool widens = false;         //!< no neck: cut where the structure grows wider than neckRadius
  bool hole = false;           //!< the neck is a hole in a thin wall
  double structureRadius = 0;  //!< mm: of the ball that fits into the seeded structure
  double widestBehind = 0;     //!< mm: of the widest ball behind the neck
  double keptVolume = 0;       //!< mm³
  double cutVolume = 0;        //!< mm³; a lower bound if the region was not whole
  VoxelMarks kept;             //!< for each voxel of the region: 1 = on the side of the seeds
  std::shared_ptr<const Barrier> barrier;
};

//! What may hold a region back.
enum class Passages { necks, holes, both };

//! Looks for the passage through which the region leaks: the widest path (largest ball all along it) from the
//! seeds to each voxel tells how wide a passage lies before it. None if there is none. `seeds`: continuous
//! indices.
//!
//! A neck leads to something so much larger than what lies before it that the seeds can hardly have meant it.
//! A structure that opens with hardly a neck into something hundreds of times larger is cut where it grows
//! wider than it is at the seeds.
//!
//! A hole in a thin wall is a passage no longer than it is wide between two spaces at least three times as
//! wide, which lie side by side around it, so that without the wall a ball three times as wide as the hole
//! would fit there. What lies behind it may be smaller than what lies before it, but no less than a fifth of
//! it. A bar between two balls is no hole, nor is a place where a tube is narrower than elsewhere. If there
//! is a neck as well, it is the neck that is returned.
std::optional<NeckCut> findNeck(const Grid& grid, const ObjectRegion& region, const std::vector<Vec3>& seeds,
                                Passages which = Passages::necks);

}  // namespace handlebody
