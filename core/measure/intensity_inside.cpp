#include "core/measure/intensity_inside.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/solid/rasterize.h"
#include "core/volume/not_a_number.h"

namespace handlebody {

namespace {

//! The part of a grid that a mesh may have voxel centres in.
struct Part {
  std::array<int, 3> first{0, 0, 0};
  Grid grid;  //!< a size of 0 if there is none
  bool isWhole = true;
};

Part partOf(const Grid& grid, const TriangleSoup& mesh) {
  Vec3 low = grid.toIndex(mesh.points[mesh.triangles[0][0]]), high = low;
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) {
      const Vec3 index = grid.toIndex(mesh.points[v]);
      low = low.cwiseMin(index);
      high = high.cwiseMax(index);
    }
  Part part;
  part.grid = grid;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<int>(a);
    const double last = grid.size[a] - 1;
    part.isWhole = part.isWhole && low[axis] >= -0.5 && high[axis] <= last + 0.5;
    part.first[a] = static_cast<int>(std::clamp(std::floor(low[axis]), 0.0, last + 1));
    const int end = static_cast<int>(std::clamp(std::ceil(high[axis]), -1.0, last));
    part.grid.size[a] = std::max(0, end - part.first[a] + 1);
  }
  part.grid.origin = grid.toWorld(Vec3(part.first[0], part.first[1], part.first[2]));
  return part;
}

//! Calls f(value) for every voxel of the part whose label is 1.
template <typename T, typename F>
void forInside(const T* voxels, const Grid& whole, const Part& part, const std::uint8_t* label, F&& f) {
  const auto [nx, ny, nz] = part.grid.size;
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y) {
      const std::size_t row =
          (static_cast<std::size_t>(part.first[2] + z) * static_cast<std::size_t>(whole.size[1]) +
           static_cast<std::size_t>(part.first[1] + y)) *
              static_cast<std::size_t>(whole.size[0]) +
          static_cast<std::size_t>(part.first[0]);
      for (int x = 0; x < nx; ++x)
        if (*label++ != 0) f(static_cast<double>(voxels[row + static_cast<std::size_t>(x)]));
    }
}

template <typename T>
void gather(const T* voxels, const Grid& grid, const Part& part, const std::uint8_t* label,
            IntensityInside& i) {
  // Volumes from files hold no NaN: readers put a number in its place.
  const std::optional<T> none = notANumberIn(voxels, grid.voxelCount());
  const auto isValue = [&](double v) {
    return std::isfinite(v) && !(none && v == static_cast<double>(*none));
  };
  double sum = 0, squares = 0;
  forInside(voxels, grid, part, label, [&](double v) {
    if (!isValue(v)) {
      ++i.withoutValue;
      return;
    }
    i.minimum = i.voxels == 0 ? v : std::min(i.minimum, v);
    i.maximum = i.voxels == 0 ? v : std::max(i.maximum, v);
    sum += v;
    ++i.voxels;
  });
  if (i.voxels == 0) return;
  i.mean = sum / static_cast<double>(i.voxels);
  forInside(voxels, grid, part, label, [&](double v) {
    if (isValue(v)) squares += (v - i.mean) * (v - i.mean);
  });
  if (i.voxels > 1) i.deviation = std::sqrt(squares / static_cast<double>(i.voxels - 1));
}

}  // namespace

VoxelsInside voxelsInside(const TriangleSoup& mesh, const Grid& grid) {
  if (mesh.triangles.empty()) return {};
  const Part part = partOf(grid, mesh);
  const std::size_t voxels = part.grid.voxelCount();
  if (voxels == 0) return {0, part.isWhole};
  const Volume label = rasterize(mesh, part.grid);
  const auto* first = label.data<std::uint8_t>();
  return {voxels - static_cast<std::size_t>(std::count(first, first + voxels, 0)), part.isWhole};
}

IntensityInside intensityInside(const TriangleSoup& mesh, const Volume& volume) {
  IntensityInside inside;
  if (mesh.triangles.empty()) return inside;
  const Part part = partOf(volume.grid, mesh);
  inside.isWhole = part.isWhole;
  if (part.grid.voxelCount() == 0) return inside;
  const Volume label = rasterize(mesh, part.grid);
  visitVoxels(volume, [&](const auto* voxels) {
    gather(voxels, volume.grid, part, label.data<std::uint8_t>(), inside);
  });
  return inside;
}

}  // namespace handlebody
