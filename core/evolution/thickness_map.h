#pragma once
// How thick a region is at each of its voxels.

#include <vector>

#include "core/evolution/object_region.h"
#include "core/indices.h"
#include "core/volume/volume.h"

namespace handlebody {

//! The box of a region, one voxel wider on all sides, with the distance of every voxel (mm, chamfer:
//! Borgefors 1986) to the outside. The border of the volume is no wall. Voxels go by their place in the box.
class ThicknessMap {
 public:
  using Voxel = ObjectRegion::Voxel;

  //! Precondition: the region is not empty.
  ThicknessMap(const Grid& grid, const ObjectRegion& region);

  //! Distance of every voxel of the box to the marked ones, mm.
  std::vector<float> distanceTo(const VoxelMarks& marked) const;
  //! 1 for the voxels of the region within the largest balls around the marked ones.
  VoxelMarks coveredByBalls(const VoxelMarks& centres) const;
  //! 1 for the voxels of the box within balls of these radii (mm) around its voxels; 0 = no ball.
  VoxelMarks coveredByBalls(const std::vector<float>& radii) const;
  //! False for the outermost layer of the box where it lies beyond the border of the volume.
  bool isInVolume(std::size_t i) const;

  std::size_t at(const Voxel& v) const {
    return (idx(v[2] - low_[2]) * idx(size_[1]) + idx(v[1] - low_[1])) * idx(size_[0]) + idx(v[0] - low_[0]);
  }
  Voxel voxel(std::size_t i) const;
  bool contains(const Voxel& v) const;
  //! 0 outside of the region.
  float distance(std::size_t i) const { return distance_[i]; }
  const std::vector<float>& distances() const { return distance_; }
  std::size_t count() const { return distance_.size(); }
  const std::array<int, 3>& low() const { return low_; }
  const std::array<int, 3>& size() const { return size_; }

  //! Of a voxel of the region; they may lie outside of it, but not outside of the box.
  template <typename F>
  void forEachFaceNeighbour(std::size_t i, F&& f) const {
    for (std::ptrdiff_t step : steps_) {
      f(i - static_cast<std::size_t>(step));
      f(i + static_cast<std::size_t>(step));
    }
  }

 private:
  struct Row {
    std::ptrdiff_t offset;
    float across, aslant;  // mm: to the voxel beside, and to the one before or after that
  };

  void makeNeighbours();
  std::vector<std::size_t> outsideOfVolume() const;
  void sweep(std::vector<float>& d) const;
  void lookAtRows(const float* here, int sign, std::vector<float>& row) const;

  Grid grid_;
  Voxel low_, size_;
  std::array<std::ptrdiff_t, 3> steps_;
  std::vector<float> distance_;
  std::vector<Row> before_;
  float alongRow_ = 0;  // mm
};

}  // namespace handlebody
