#include "core/solid/mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

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

//! Where the first voxel of a mask is, in voxels of another.
std::array<int, 3> placeIn(const Grid& other, const Mask& mask) {
  const Vec3 at = other.toIndex(mask.grid.origin);
  return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())),
          static_cast<int>(std::lround(at.z()))};
}

//! The box around masks, and whose a voxel is in it.
class Owners {
 public:
  explicit Owners(const std::vector<Mask>& masks) : first_(masks[0].grid) {
    for (const Mask& mask : masks)
      for (std::size_t a = 0; a < 3; ++a) {
        const int low = placeIn(first_, mask)[a];
        low_[a] = std::min(low_[a], low);
        high_[a] = std::max(high_[a], low + mask.grid.size[a]);
      }
    owner_.resize(sizeAlong(0) * sizeAlong(1) * sizeAlong(2));
  }

  //! f(place in the mask, its owner, from 1 on) for each voxel inside.
  template <typename F>
  void forEachInside(const Mask& mask, F&& f) {
    const std::array<int, 3> at = placeIn(first_, mask);
    const auto place = [&](std::size_t a, int v) { return static_cast<std::size_t>(at[a] + v - low_[a]); };
    std::size_t here = 0;
    for (int z = 0; z < mask.grid.size[2]; ++z)
      for (int y = 0; y < mask.grid.size[1]; ++y) {
        const std::size_t row = (place(2, z) * sizeAlong(1) + place(1, y)) * sizeAlong(0) + place(0, 0);
        for (std::size_t x = 0; x < static_cast<std::size_t>(mask.grid.size[0]); ++x, ++here)
          if (mask.inside[here] != 0) f(here, owner_[row + x]);
      }
  }

 private:
  std::size_t sizeAlong(std::size_t a) const { return static_cast<std::size_t>(high_[a] - low_[a]); }
  Grid first_;
  std::array<int, 3> low_{0, 0, 0}, high_{0, 0, 0};  // voxels of the first mask
  std::vector<std::uint16_t> owner_;
};

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

std::vector<std::size_t> leaveToSmaller(std::vector<Mask>& masks) {
  std::vector<std::size_t> order(masks.size()), lost(masks.size());
  if (masks.size() < 2) return lost;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return masks[a].count() > masks[b].count(); });
  Owners owners(masks);
  for (const std::size_t m : order)
    owners.forEachInside(
        masks[m], [m](std::size_t, std::uint16_t& owner) { owner = static_cast<std::uint16_t>(m + 1); });
  for (std::size_t m = 0; m < masks.size(); ++m) {
    auto kept = std::make_shared<std::vector<std::uint8_t>>(masks[m].inside);
    owners.forEachInside(masks[m], [&](std::size_t here, std::uint16_t owner) {
      if (owner == m + 1) return;
      (*kept)[here] = 0;
      ++lost[m];
    });
    if (lost[m] > 0) masks[m] = maskOf({masks[m].grid, VoxelType::uint8, {kept, kept->data()}}, std::nullopt);
  }
  return lost;
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
