#pragma once
// Topology of a mask counted voxel by voxel, with nothing in common with the surface: components by flood
// fill (object: 6 neighbours, background: 26), the Euler number of the cubical complex whose cells have all
// of their corners (voxel centres) in the object.

#include <Eigen/Geometry>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "core/mesh/validity.h"
#include "core/solid/mask.h"

namespace handlebody::testing {

struct VoxelTopology {
  int components = 0, cavities = 0, tunnels = 0;
  bool operator==(const VoxelTopology&) const = default;
};

class VoxelCounting {
 public:
  explicit VoxelCounting(const Mask& mask) : mask_(mask) {
    for (std::size_t a = 0; a < 3; ++a) n_[a] = mask.grid.size[a] + 2;
    label_.assign(static_cast<std::size_t>(n_[0] * n_[1] * n_[2]), 0);
  }
  VoxelTopology count() {
    VoxelTopology t;
    t.components = parts(true);
    t.cavities = parts(false) - 1;  // but for the outside
    // Euler number = components - tunnels + cavities.
    t.tunnels = t.components + t.cavities - euler();
    return t;
  }

 private:
  bool in(int x, int y, int z) const { return mask_.holds(x - 1, y - 1, z - 1); }
  int& label(int x, int y, int z) { return label_[(z * n_[1] + y) * n_[0] + x]; }

  int parts(bool object) {
    int n = 0;
    for (int z = 0; z < n_[2]; ++z)
      for (int y = 0; y < n_[1]; ++y)
        for (int x = 0; x < n_[0]; ++x)
          if (in(x, y, z) == object && label(x, y, z) == 0) {
            ++n;
            flood({x, y, z}, object);
          }
    return n;
  }

  void flood(std::array<int, 3> start, bool object) {
    std::vector<std::array<int, 3>> waiting{start};
    label(start[0], start[1], start[2]) = 1;
    while (!waiting.empty()) {
      const auto [x, y, z] = waiting.back();
      waiting.pop_back();
      for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (object && dx * dx + dy * dy + dz * dz != 1) continue;
            const int u = x + dx, v = y + dy, w = z + dz;
            if (u < 0 || v < 0 || w < 0 || u >= n_[0] || v >= n_[1] || w >= n_[2]) continue;
            if (in(u, v, w) != object || label(u, v, w) != 0) continue;
            label(u, v, w) = 1;
            waiting.push_back({u, v, w});
          }
    }
  }

  //! Vertices less edges and squares less cubes: cells of the sides (dx, dy, dz) at every corner.
  int euler() const {
    int sum = 0;
    for (int z = 0; z < n_[2]; ++z)
      for (int y = 0; y < n_[1]; ++y)
        for (int x = 0; x < n_[0]; ++x)
          for (int side = 0; side < 8; ++side) {
            bool whole = true;
            for (int corner = 0; corner < 8; ++corner)
              if ((corner & ~side) == 0)
                whole = whole && in(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
            const int dimension = (side & 1) + (side >> 1 & 1) + (side >> 2);
            if (whole) sum += dimension % 2 == 0 ? 1 : -1;
          }
    return sum;
  }

  const Mask& mask_;
  std::array<int, 3> n_{};
  std::vector<int> label_;
};

inline VoxelTopology voxelTopology(const Mask& mask) { return VoxelCounting(mask).count(); }

//! Of all components of a surface: to be as many as the mask has.
inline int tunnelsOf(const Certificate& c) { return std::accumulate(c.genus.begin(), c.genus.end(), 0); }

//! Every voxel is inside with the probability `share`.
inline Mask randomMask(const std::array<int, 3>& size, double share, unsigned seed) {
  std::mt19937 random(seed);
  Mask mask;
  mask.grid.size = size;
  mask.inside.resize(mask.grid.voxelCount());
  for (auto& v : mask.inside) v = static_cast<double>(random()) < share * 4294967296.0 ? 1 : 0;
  return mask;
}

//! A grid whose axes are neither those of the world nor alike.
inline void makeOblique(Grid& grid) {
  grid.spacing = Vec3(0.7, 0.9, 2.5);
  grid.origin = Vec3(-80, 33, 121);
  grid.direction =
      (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(-0.7, Vec3::UnitZ())).toRotationMatrix();
}

}  // namespace handlebody::testing
