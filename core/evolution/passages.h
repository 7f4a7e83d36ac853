#pragma once
// Narrow passages of the object as the image shows it: where a surface that grows from the seeds would leave
// a wide space through something much narrower for another wide space.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/geometry/vec.h"

namespace handlebody {

//! A box of voxels, both ends included.
struct VoxelBox {
  std::array<int, 3> low{0, 0, 0}, high{-1, -1, -1};
  bool operator==(const VoxelBox&) const = default;
};

//! A passage between the side of the seeds and what lies behind it. Radii are those of balls, mm.
struct Passage {
  Vec3 place{0, 0, 0};      //!< mm, LPS: where it is narrowest; isSeen only
  double radius = 0;        //!< of the widest ball that passes
  double before = 0;        //!< of the widest ball on the side of the seeds
  double behind = 0;        //!< of the widest ball on the other side
  Vec3 widest{0, 0, 0};     //!< mm, LPS: the middle of that ball
  bool isSeen = true;       //!< false: the voxels show no way through
  bool isWidening = false;  //!< no narrower than what lies before it, but what lies behind is much wider
};

//! The passages of a part of the volume.
//!
//! Every voxel of the object holds the radius of the largest ball around it. Taken from the widest down, the
//! voxels make spaces that merge at the passages between them (space_tree.h). Where a space without a seed
//! merges with that of the seeds, and the passage is much narrower than either, or that space is much wider
//! than all that lies before it, what lies behind is marked as far as balls reach that are as much wider than
//! the passage. Cavities count as filled: the way around an island is no narrow one. Neither the volume's
//! border nor that of the box narrows anything.
class PassageMap {
 public:
  //! `starts`: mm, on the side of the seeds; those that lie outside of the object or the box do not count.
  //! `walls` may be null. A box of more than kMaxCells voxels is looked at in coarser cells.
  //! The map does not depend on the number of threads.
  PassageMap(const ObjectImage& image, const Walls* walls, const VoxelBox& box, std::span<const Vec3> starts,
             int threads = 1);

  //! Index of the passage that a place lies behind; -1: none.
  int behindWhich(const Vec3& world) const {
    if (passages_.empty()) return -1;
    const std::int64_t cell = cellAt(world);
    return cell < 0 ? -1 : zones_[cell] - 1;
  }
  const std::vector<Passage>& passages() const { return passages_; }
  double cellSize() const { return cell_; }  //!< mm
  //! True if it would be told were it, or what lies before it if it widens, a cell wider.
  bool isSure(const Passage& passage) const;

  static constexpr std::size_t kMaxCells = 4'000'000;

 private:
  void layOut(const VoxelBox& box);
  std::int64_t cellAt(const Vec3& world) const;
  Vec3 placeOf(std::size_t cell) const;
  std::vector<std::uint8_t> findOutside(const ObjectImage& image, const Walls* walls, int threads) const;
  std::vector<float> findRadii(const std::vector<std::uint8_t>& outside, int threads) const;
  std::uint32_t uphill(std::uint32_t cell, const std::vector<float>& radius) const;
  void markBehind(std::size_t passage, const std::vector<float>& radius,
                  const std::vector<std::uint32_t>& core, double ball);

  Grid grid_;                         // of the volume
  std::array<int, 3> low_{0, 0, 0};   // voxel of the first cell that is not padding
  std::array<int, 3> size_{0, 0, 0};  // cells, with a layer of padding around
  int step_ = 1;                      // voxels of a cell along each axis
  double cell_ = 1;                   // mm
  std::vector<Passage> passages_;
  std::vector<std::uint8_t> zones_;  // per cell: 1 + index of the passage it lies behind, 0 = none
};

}  // namespace handlebody
