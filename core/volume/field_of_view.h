#pragma once
// Where a volume holds no image: scanners and reconstructions fill what they did not see with one value.

#include <array>
#include <memory>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! Marks the padding of a volume: voxels of the one value that is commonest on the border of the grid,
//! connected with the border by more than passages of one or two voxels (what is as dark as padding may come
//! near the side of an ultrasound fan); and voxels that are not a number in their file, which are read as a
//! number below the least of the others (volume_io.h), wherever they lie. One bit per voxel.
class FieldOfView {
 public:
  //! Null if there is no padding: fewer than kMinPadding of the border voxels have the same value, and all
  //! are numbers.
  static std::shared_ptr<const FieldOfView> find(const Volume& volume);

  bool isPadding(std::size_t voxel) const { return padding_[voxel]; }
  //! Of the voxel nearest to a continuous index.
  bool isPaddingNear(const Vec3& index) const;
  //! The padding's value.
  double value() const { return value_; }

 private:
  std::array<int, 3> size_{};
  std::vector<bool> padding_;
  double value_ = 0;
};

//! Part of the border voxels. A circular field of view leaves 21 % of four faces out; noise never repeats one
//! value so often.
inline constexpr double kMinPadding = 0.1;

}  // namespace handlebody
