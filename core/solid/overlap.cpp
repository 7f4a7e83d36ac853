#include "core/solid/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cancellation.h"
#include "core/phase.h"
#include "core/solid/rasterize.h"

namespace handlebody {

namespace {

constexpr double kPointsOfSlab = 0x1p24;
constexpr double kStepsOfMeshes = 256;

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  void widen(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

//! Of the object in the indices of a lattice.
Extent extentOn(const Grid& lattice, const Solid& solid) {
  Extent extent;
  if (!solid.mask) {
    for (const Triangle& t : solid.surface.triangles)
      for (const int v : t) extent.widen(lattice.toIndex(solid.surface.points[v]));
    return extent;
  }
  const Grid& g = solid.mask->grid;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int a = 0; a < 3; ++a) index[a] = (corner >> a & 1) * g.size[a] - 0.5;
    extent.widen(lattice.toIndex(g.toWorld(index)));
  }
  return extent;
}

double pointsIn(const Extent& e) { return (e.high - e.low + Vec3::Ones()).prod(); }

Grid latticeOf(const Solid& a, const Solid& b, double spacing) {
  const Mask* finer = a.mask ? &*a.mask : nullptr;
  if (b.mask && (!finer || b.mask->grid.voxelVolume() < finer->grid.voxelVolume())) finer = &*b.mask;
  if (finer) return finer->grid;
  Grid lattice;
  const Extent ea = extentOn(lattice, a), eb = extentOn(lattice, b);
  const double larger = std::max((ea.high - ea.low).prod(), (eb.high - eb.low).prod());
  lattice.spacing.setConstant(spacing > 0 ? spacing : std::cbrt(larger) / kStepsOfMeshes);
  // Half a step into A's box: surfaces along the axes at round places do not pass through the points.
  lattice.origin = ea.low + 0.5 * lattice.spacing;
  return lattice;
}

//! 1 where a voxel of the mask lies around a point of the grid. One step along x is a constant step there.
std::vector<std::uint8_t> lookUp(const Mask& mask, const Grid& grid) {
  std::vector<std::uint8_t> inside;
  inside.reserve(grid.voxelCount());
  const Vec3 zero = mask.grid.toIndex(grid.toWorld(Vec3::Zero()));
  std::array<Vec3, 3> step;
  for (int a = 0; a < 3; ++a) step[a] = mask.grid.toIndex(grid.toWorld(Vec3::Unit(a))) - zero;
  const auto voxel = [](double index) { return static_cast<int>(std::floor(index + 0.5)); };
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x) {
        const Vec3 p = zero + x * step[0] + y * step[1] + z * step[2];
        const bool isOn = mask.grid.contains(p);
        inside.push_back(isOn && mask.holds(voxel(p.x()), voxel(p.y()), voxel(p.z())) ? 1 : 0);
      }
  return inside;
}

std::vector<std::uint8_t> insideOn(const Solid& solid, const Grid& grid) {
  if (solid.mask) return lookUp(*solid.mask, grid);
  const Volume drawn = rasterize(solid.surface, grid);
  const auto* voxels = drawn.data<std::uint8_t>();
  return {voxels, voxels + grid.voxelCount()};
}

struct Counts {
  std::size_t own = 0, both = 0;
};

//! Points of the lattice inside of `solid`, and inside of `other` as well.
Counts countPoints(const Grid& lattice, const Solid& solid, const Solid* other) {
  const Extent extent = extentOn(lattice, solid);
  const Vec3 low = extent.low.array().floor(),
             size = extent.high.array().ceil().matrix() - low + Vec3::Ones();
  Grid slab = lattice;
  slab.size = {static_cast<int>(size.x()), static_cast<int>(size.y()), 1};
  const int planes = static_cast<int>(size.z());
  const int thick = static_cast<int>(std::clamp(kPointsOfSlab / (size.x() * size.y()), 1.0, size.z()));
  Counts counts;
  for (int z = 0; z < planes; z += thick) {
    giveUpIfCancelled();
    slab.size[2] = std::min(thick, planes - z);
    slab.origin = lattice.toWorld(low + z * Vec3::UnitZ());
    const auto mine = insideOn(solid, slab);
    counts.own += static_cast<std::size_t>(std::count(mine.begin(), mine.end(), std::uint8_t{1}));
    if (!other) continue;
    const auto theirs = insideOn(*other, slab);
    for (std::size_t i = 0; i < mine.size(); ++i) counts.both += mine[i] & theirs[i];
  }
  return counts;
}

}  // namespace

Overlap overlapOf(const Solid& a, const Solid& b, double spacing) {
  const Phase phase("overlap");
  Grid lattice = latticeOf(a, b, spacing);
  Overlap overlap;
  overlap.onVoxels = a.mask || b.mask;
  while (std::max(pointsIn(extentOn(lattice, a)), pointsIn(extentOn(lattice, b))) > kMaxLatticePoints) {
    lattice.spacing *= 2;
    overlap.onVoxels = false;
  }
  const Counts ofA = countPoints(lattice, a, nullptr), ofB = countPoints(lattice, b, &a);
  const double each = lattice.voxelVolume();
  overlap.a = each * static_cast<double>(ofA.own);
  overlap.b = each * static_cast<double>(ofB.own);
  overlap.both = each * static_cast<double>(ofB.both);
  overlap.spacing = lattice.spacing;
  return overlap;
}

}  // namespace handlebody
