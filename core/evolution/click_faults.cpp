#include "core/evolution/click_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/triangle_distance.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

constexpr double kKnown = 0.5;  // voxels: how well a place is known

std::array<long, 3> voxelOf(const Grid& grid, const Vec3& world) {
  const Vec3 index = grid.toIndex(world);
  return {std::lround(index[0]), std::lround(index[1]), std::lround(index[2])};
}

double distanceTo(const Mesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.faces())
    if (t[0] >= 0)
      least =
          std::min(least, squaredDistance(p, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
  return std::sqrt(least);
}

}  // namespace

std::optional<Finding> contradictionOf(const Grid& grid, const std::vector<Seed>& clicks) {
  for (const Seed& inside : clicks)
    for (const Seed& outside : clicks)
      if (!inside.background && outside.background &&
          voxelOf(grid, inside.centre) == voxelOf(grid, outside.centre))
        return Finding(FindingKind::clicksContradict,
                       {{"place", placeValue(inside.centre)}, {"outside", placeValue(outside.centre)}});
  return std::nullopt;
}

std::vector<Finding> unheededClicks(const Mesh& mesh, const Grid& grid, const std::vector<Seed>& clicks) {
  std::vector<Finding> out;
  if (mesh.faceCount() == 0) return out;
  const Components parts = findComponents(mesh);
  for (auto c = clicks.begin(); c != clicks.end(); ++c) {
    const Seed& click = *c;
    const auto isAgain = [&](const Seed& s) {
      return s.centre == click.centre && s.background == click.background;
    };
    if (std::any_of(clicks.begin(), c, isAgain)) continue;
    const double distance = distanceTo(mesh, click.centre);
    if (!(distance > kKnown * grid.meanSpacing())) continue;
    if (encloses(mesh, parts, click.centre) != click.background) continue;
    out.push_back({click.background ? FindingKind::clickEnclosed : FindingKind::seedNotEnclosed,
                   {{"place", placeValue(click.centre)}, {"distance_mm", distance}}});
  }
  return out;
}

}  // namespace handlebody
