#include "core/volume/field_of_view.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/indices.h"
#include "core/volume/border_region.h"
#include "core/volume/not_a_number.h"

namespace handlebody {

namespace {

// A passage has no width along an axis with voxels of so many times the least spacing.
constexpr double kCoarse = 2;

struct Size {
  explicit Size(const std::array<int, 3>& n) : x(idx(n[0])), y(idx(n[1])), z(idx(n[2])) {}
  std::size_t x, y, z;
  std::size_t at(std::size_t i, std::size_t j, std::size_t k) const { return (k * y + j) * x + i; }
};

//! Calls f(index) for every voxel on a face of the grid.
template <typename F>
void forEachBorderVoxel(const Size& n, F&& f) {
  for (std::size_t k = 0; k < n.z; ++k)
    for (std::size_t j = 0; j < n.y; ++j) {
      const bool wholeRow = k == 0 || k + 1 == n.z || j == 0 || j + 1 == n.y;
      const std::size_t stride = wholeRow || n.x == 1 ? 1 : n.x - 1;
      for (std::size_t i = 0; i < n.x; i += stride) f(n.at(i, j, k));
    }
}

//! Around the volume all is padding.
template <typename T>
VoxelBits voxelsWith(const T* voxels, const std::array<int, 3>& size, T value) {
  VoxelBits bits(size, true);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j, voxels += size[0])
      bits.setRow(j, k, [&](int i) { return voxels[i] == value; });
  return bits;
}

//! Along which voxels are not much longer than along the others.
std::array<bool, 3> fineAxes(const Grid& grid) {
  std::array<bool, 3> fine;
  for (int a = 0; a < 3; ++a) fine[idx(a)] = grid.spacing[a] < kCoarse * grid.spacing.minCoeff();
  return fine;
}

template <typename T>
std::vector<bool> findPadding(const T* voxels, const Grid& grid, double& paddingValue) {
  const Size n(grid.size);
  std::unordered_map<T, std::size_t> count;
  std::size_t border = 0;
  forEachBorderVoxel(n, [&](std::size_t v) {
    ++border;
    if (count.size() < 100'000 || count.count(voxels[v])) ++count[voxels[v]];
  });
  T value{};
  std::size_t most = 0;
  for (const auto& [v, c] : count)
    if (c > most || (c == most && v < value)) {
      most = c;
      value = v;
    }
  if (static_cast<double>(most) < kMinPadding * static_cast<double>(border)) return {};

  paddingValue = static_cast<double>(value);
  const VoxelBits same = voxelsWith(voxels, grid.size, value);
  VoxelBits reached = reachedFromBorder(same, fineAxes(grid));
  reached &= same;
  std::vector<bool> padding(n.x * n.y * n.z, false);
  bool any = false;
  auto row = padding.begin();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j, row += grid.size[0])
      reached.forEachRun(j, k, [&](int first, int last) {
        any = true;
        std::fill(row + first, row + last, true);
      });
  if (!any) return {};
  return padding;
}

//! Voxels that are not a number are padding wherever they lie.
template <typename T>
std::vector<bool> withNotANumber(const T* voxels, std::size_t count, std::vector<bool> padding,
                                 double& value) {
  const std::optional<T> none = notANumberIn(voxels, count);
  if (!none) return padding;
  padding.resize(count, false);
  for (std::size_t v = 0; v < count; ++v)
    if (voxels[v] == *none) padding[v] = true;
  value = static_cast<double>(*none);
  return padding;
}

}  // namespace

std::shared_ptr<const FieldOfView> FieldOfView::find(const Volume& volume) {
  auto found = std::make_shared<FieldOfView>();
  found->size_ = volume.grid.size;
  found->padding_ = visitVoxels(volume, [&](const auto* voxels) {
    return withNotANumber(voxels, volume.grid.voxelCount(), findPadding(voxels, volume.grid, found->value_),
                          found->value_);
  });
  return found->padding_.empty() ? nullptr : found;
}

bool FieldOfView::isPaddingNear(const Vec3& index) const {
  std::size_t at = 0;
  for (int a = 2; a >= 0; --a) {
    const int n = size_[a];
    at = at * static_cast<std::size_t>(n) +
         static_cast<std::size_t>(std::clamp(static_cast<int>(std::lround(index[a])), 0, n - 1));
  }
  return padding_[at];
}

}  // namespace handlebody
