#include "core/evolution/thickness_map.h"

#include <algorithm>
#include <utility>

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
  alongRow_ = static_cast<float>(grid_.spacing[0]);
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

//! The rows before one in memory that hold neighbours of its voxels.
void ThicknessMap::makeNeighbours() {
  const auto length = [&](int dx, int dy, int dz) {
    return static_cast<float>(Vec3(dx, dy, dz).cwiseProduct(grid_.spacing).norm());
  };
  for (const auto& [dy, dz] : {std::pair{-1, 0}, {-1, -1}, {0, -1}, {1, -1}})
    before_.push_back({dy * steps_[1] + dz * steps_[2], length(0, dy, dz), length(1, dy, dz)});
}

std::vector<std::size_t> ThicknessMap::outsideOfVolume() const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < distance_.size(); ++i)
    if (!isInVolume(i)) out.push_back(i);
  return out;
}

//! Two passes over all but the outermost layer.
void ThicknessMap::sweep(std::vector<float>& d) const {
  std::vector<float> row(idx(size_[0]));
  for (int z = 1; z < size_[2] - 1; ++z)
    for (int y = 1; y < size_[1] - 1; ++y) {
      float* here = d.data() + y * steps_[1] + z * steps_[2];
      lookAtRows(here, 1, row);
      for (int x = 1; x < size_[0] - 1; ++x) here[x] = std::min(row[idx(x)], here[x - 1] + alongRow_);
    }
  for (int z = size_[2] - 2; z > 0; --z)
    for (int y = size_[1] - 2; y > 0; --y) {
      float* here = d.data() + y * steps_[1] + z * steps_[2];
      lookAtRows(here, -1, row);
      for (int x = size_[0] - 2; x > 0; --x) here[x] = std::min(row[idx(x)], here[x + 1] + alongRow_);
    }
}

//! What a row comes to beside the rows before it (`sign` = 1) or after it (-1), without its own neighbours.
void ThicknessMap::lookAtRows(const float* here, int sign, std::vector<float>& row) const {
  const std::size_t last = row.size() - 1;
  std::copy_n(here, row.size(), row.begin());
  for (const Row& r : before_) {
    const float* beside = here + sign * r.offset;
    float* out = row.data();
    for (std::size_t x = 1; x < last; ++x) {
      const float aslant = std::min(beside[x - 1], beside[x + 1]) + r.aslant;
      out[x] = std::min(out[x], std::min(beside[x] + r.across, aslant));
    }
  }
}

}  // namespace handlebody
