#include "core/evolution/thickness_map.h"

#include <algorithm>

namespace handlebody {

namespace {
constexpr float kFar = 1e30f;
}

ThicknessMap::ThicknessMap(const Grid& grid, const ObjectRegion& region) : grid_(grid) {
  low_ = region.voxels[0];
  Voxel high = low_;
  for (const Voxel& v : region.voxels)
    for (std::size_t a = 0; a < 3; ++a) {
      low_[a] = std::min(low_[a], v[a]);
      high[a] = std::max(high[a], v[a]);
    }
  for (std::size_t a = 0; a < 3; ++a) {
    low_[a] -= 1;
    size_[a] = high[a] + 2 - low_[a];
  }
  steps_ = {1, size_[0], static_cast<std::ptrdiff_t>(size_[0]) * size_[1]};
  makeNeighbours();
  distance_.assign(idx(size_[0]) * idx(size_[1]) * idx(size_[2]), 0.0f);
  for (const Voxel& v : region.voxels) distance_[at(v)] = kFar;
  const std::vector<std::size_t> beyond = outsideOfVolume();
  for (std::size_t i : beyond) distance_[i] = kFar;
  sweep(distance_);
  for (std::size_t i : beyond) distance_[i] = 0;
}

std::vector<float> ThicknessMap::distanceTo(const VoxelMarks& marked) const {
  std::vector<float> d(distance_.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = marked[i] ? 0.0f : kFar;
  sweep(d);
  return d;
}

VoxelMarks ThicknessMap::coveredByBalls(const VoxelMarks& centres) const {
  std::vector<float> radii(distance_.size(), 0.0f);
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (centres[i]) radii[i] = distance_[i];
  VoxelMarks covered = coveredByBalls(radii);
  for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = covered[i] && distance_[i] > 0;
  return covered;
}

VoxelMarks ThicknessMap::coveredByBalls(const std::vector<float>& radii) const {
  std::vector<float> d(radii.size(), kFar);  // to the surface of the nearest ball
  for (std::size_t i = 0; i < d.size(); ++i)
    if (radii[i] > 0) d[i] = -radii[i];
  sweep(d);
  VoxelMarks covered(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) covered[i] = d[i] < 0;
  return covered;
}

bool ThicknessMap::isInVolume(std::size_t i) const {
  const Voxel v = voxel(i);
  for (std::size_t a = 0; a < 3; ++a)
    if (v[a] < 0 || v[a] >= grid_.size[a]) return false;
  return true;
}

ThicknessMap::Voxel ThicknessMap::voxel(std::size_t i) const {
  const auto x = static_cast<int>(i % idx(size_[0])), y = static_cast<int>(i / idx(size_[0]) % idx(size_[1])),
             z = static_cast<int>(i / (idx(size_[0]) * idx(size_[1])));
  return {x + low_[0], y + low_[1], z + low_[2]};
}

bool ThicknessMap::contains(const Voxel& v) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (v[a] < low_[a] || v[a] >= low_[a] + size_[a]) return false;
  return true;
}

//! The 13 neighbours that come before a voxel in memory.
void ThicknessMap::makeNeighbours() {
  for (int dz = -1; dz <= 0; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (dz == 0 && (dy > 0 || (dy == 0 && dx >= 0))) continue;
        const Vec3 d = Vec3(dx, dy, dz).cwiseProduct(grid_.spacing);
        before_.push_back({dx + dy * steps_[1] + dz * steps_[2], static_cast<float>(d.norm())});
      }
}

std::vector<std::size_t> ThicknessMap::outsideOfVolume() const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < distance_.size(); ++i)
    if (!isInVolume(i)) out.push_back(i);
  return out;
}

//! Two passes over all but the outermost layer.
void ThicknessMap::sweep(std::vector<float>& d) const {
  const auto relax = [&](int x, int y, int z, int sign) {
    const std::ptrdiff_t i = x + y * steps_[1] + z * steps_[2];
    float best = d[i];
    if (best == 0) return;
    for (const Neighbour& n : before_) best = std::min(best, d[i + sign * n.offset] + n.length);
    d[i] = best;
  };
  for (int z = 1; z < size_[2] - 1; ++z)
    for (int y = 1; y < size_[1] - 1; ++y)
      for (int x = 1; x < size_[0] - 1; ++x) relax(x, y, z, 1);
  for (int z = size_[2] - 2; z > 0; --z)
    for (int y = size_[1] - 2; y > 0; --y)
      for (int x = size_[0] - 2; x > 0; --x) relax(x, y, z, -1);
}

}  // namespace handlebody
