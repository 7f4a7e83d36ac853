#pragma once
// A volume: voxels of their native type on a grid with spacing, origin and direction.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/geometry/vec.h"

namespace handlebody {

//! Where the voxels lie. World frame: LPS millimetres. Voxel (0,0,0) has its centre at `origin`.
//! This is the only place where voxel and world coordinates are converted.
struct Grid {
  std::array<int, 3> size{0, 0, 0};  //!< voxels along each axis
  Vec3 spacing{1, 1, 1};             //!< mm, all > 0
  Vec3 origin{0, 0, 0};              //!< mm, LPS
  Eigen::Matrix3d direction =
      Eigen::Matrix3d::Identity();  //!< orthonormal; column a = world direction of axis a

  std::size_t voxelCount() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]);
  }
  //! Continuous voxel index → world mm.
  Vec3 toWorld(const Vec3& index) const { return origin + direction * index.cwiseProduct(spacing); }
  //! World mm → continuous voxel index.
  Vec3 toIndex(const Vec3& world) const {
    return (direction.transpose() * (world - origin)).cwiseQuotient(spacing);
  }
  //! True if a continuous index lies within the hull of the voxel centres widened by half a voxel.
  bool contains(const Vec3& index) const {
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= -0.5 && index[a] <= size[a] - 0.5)) return false;
    return true;
  }
  //! Volume of one voxel in mm³.
  double voxelVolume() const { return spacing.prod(); }
  //! Geometric mean of the spacing in mm.
  double meanSpacing() const { return std::cbrt(voxelVolume()); }
};

enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, float32, float64 };

//! Bytes of one voxel.
std::size_t bytesPerVoxel(VoxelType type);
//! "uint8", "int16" …
const char* voxelTypeName(VoxelType type);

//! One scalar volume (one time point). The buffer is shared and never changed after reading; x runs fastest.
struct Volume {
  Grid grid;
  VoxelType type = VoxelType::float32;
  std::shared_ptr<const void> voxels;  //!< grid.voxelCount() values of `type`

  //! Pointer to the voxels; T must be the C++ type of `type`.
  template <typename T>
  const T* data() const {
    return static_cast<const T*>(voxels.get());
  }
};

//! Calls f with a typed pointer to the voxels (const std::uint8_t*, …, const double*).
template <typename F>
decltype(auto) visitVoxels(const Volume& volume, F&& f) {
  switch (volume.type) {
    case VoxelType::uint8:
      return f(volume.data<std::uint8_t>());
    case VoxelType::int8:
      return f(volume.data<std::int8_t>());
    case VoxelType::uint16:
      return f(volume.data<std::uint16_t>());
    case VoxelType::int16:
      return f(volume.data<std::int16_t>());
    case VoxelType::uint32:
      return f(volume.data<std::uint32_t>());
    case VoxelType::int32:
      return f(volume.data<std::int32_t>());
    case VoxelType::float32:
      return f(volume.data<float>());
    default:
      return f(volume.data<double>());
  }
}

//! Makes an own, zero-filled buffer of the right size; the writable pointer is handed back through `buffer`.
Volume makeVolume(const Grid& grid, VoxelType type, void** buffer);

}  // namespace handlebody
