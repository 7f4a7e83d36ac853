#include "core/solid/mask.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handlebody {

namespace {

//! First and last voxel of the object along each axis.
struct Extent {
  std::array<int, 3> low, high{-1, -1, -1};
  explicit Extent(const std::array<int, 3>& size) : low(size) {}
  bool empty() const { return high[0] < 0; }
  void widen(int x, int y, int z) {
    const std::array<int, 3> p{x, y, z};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
};

template <typename T, typename Is>
Mask cut(const Grid& grid, const T* voxels, const Is& is) {
  const auto [nx, ny, nz] = grid.size;
  Extent extent(grid.size);
  const T* voxel = voxels;
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        if (is(*voxel++)) extent.widen(x, y, z);
  Mask mask;
  mask.grid = grid;
  mask.grid.size = {0, 0, 0};
  if (extent.empty()) return mask;
  for (std::size_t a = 0; a < 3; ++a) mask.grid.size[a] = extent.high[a] - extent.low[a] + 1;
  mask.grid.origin = grid.toWorld(Vec3(extent.low[0], extent.low[1], extent.low[2]));
  mask.inside.reserve(mask.grid.voxelCount());
  for (int z = extent.low[2]; z <= extent.high[2]; ++z)
    for (int y = extent.low[1]; y <= extent.high[1]; ++y) {
      const auto row =
          (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
          static_cast<std::size_t>(nx);
      for (int x = extent.low[0]; x <= extent.high[0]; ++x)
        mask.inside.push_back(is(voxels[row + static_cast<std::size_t>(x)]) ? 1 : 0);
    }
  return mask;
}

}  // namespace

bool Mask::holds(const Vec3& world) const {
  const Vec3 index = grid.toIndex(world);
  if (!grid.contains(index)) return false;
  return holds(static_cast<int>(std::floor(index.x() + 0.5)), static_cast<int>(std::floor(index.y() + 0.5)),
               static_cast<int>(std::floor(index.z() + 0.5)));
}

std::size_t Mask::count() const {
  return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), std::uint8_t{1}));
}

Mask maskOf(const Volume& labels, std::optional<double> label) {
  return visitVoxels(labels, [&](const auto* voxels) {
    return cut(labels.grid, voxels, [label](auto value) {
      return label ? static_cast<double>(value) == *label : static_cast<double>(value) != 0;
    });
  });
}

bool holdsWholeNumbers(const Volume& volume) {
  return visitVoxels(volume, [&](const auto* voxels) {
    return std::all_of(voxels, voxels + volume.grid.voxelCount(), [](auto value) {
      const double v = static_cast<double>(value);
      return std::floor(v) == v;
    });
  });
}

}  // namespace handlebody
