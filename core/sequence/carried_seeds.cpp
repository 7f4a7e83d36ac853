#include "core/sequence/carried_seeds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"
#include "core/solid/rasterize.h"

namespace handlebody {

namespace {

constexpr int kLattice = 24;  // points along the longest side of the surface's box

double distanceToPoints(const TriangleSoup& surface, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : surface.points) least = std::min(least, (q - p).squaredNorm());
  return std::sqrt(least);
}

Grid latticeIn(const TriangleSoup& surface) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : surface.points) box.extend(p);
  const double step = box.sizes().maxCoeff() / kLattice;
  Grid grid;
  grid.spacing = Vec3::Constant(step);
  for (int a = 0; a < 3; ++a) grid.size[a] = std::max(1, static_cast<int>(box.sizes()[a] / step));
  for (int a = 0; a < 3; ++a) grid.origin[a] = box.center()[a] - 0.5 * (grid.size[a] - 1) * step;
  return grid;
}

}  // namespace

Seed deepestPlace(const TriangleSoup& surface) {
  const Grid grid = latticeIn(surface);
  const Volume inside = rasterize(surface, grid);
  Seed best{surface.points.front(), 0};
  std::size_t i = 0;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x, ++i) {
        if (inside.data<std::uint8_t>()[i] == 0) continue;
        const Vec3 p = grid.toWorld(Vec3(x, y, z));
        if (const double depth = distanceToPoints(surface, p); depth > *best.radius) best = {p, depth};
      }
  return best;
}

std::vector<Seed> carriedSeeds(const std::vector<Seed>& clicks, const TriangleSoup& surface, double depth) {
  const Mesh mesh(surface);
  const Components parts = findComponents(mesh);
  std::vector<Seed> carried;
  for (Seed click : seedsOfSide(clicks, false)) {
    const double room = distanceToPoints(surface, click.centre);
    if (room < depth || !encloses(mesh, parts, click.centre)) continue;
    if (click.radius) click.radius = std::min(*click.radius, room);
    carried.push_back(click);
  }
  if (carried.empty()) carried.push_back({deepestPlace(surface).centre});
  for (const Seed& click : seedsOfSide(clicks, true))
    if (!encloses(mesh, parts, click.centre)) carried.push_back(click);
  return carried;
}

}  // namespace handlebody
