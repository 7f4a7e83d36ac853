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

constexpr double kKnown = 0.5;  // voxels: how well a place is known,
constexpr double kDrawn = 1.5;  // and a ball, which is drawn in voxels around the middle of one

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

bool areInOneVoxel(const Grid& grid, const Vec3& a, const Vec3& b) {
  return voxelOf(grid, a) == voxelOf(grid, b);
}

bool isInBall(const Vec3& place, const Seed& click) {
  return click.radius && (place - click.centre).norm() < *click.radius;
}

std::optional<Finding> contradictionOf(const Grid& grid, const Seed& inside, const Seed& outside) {
  const bool isOne = areInOneVoxel(grid, inside.centre, outside.centre);
  if (!isOne && !isInBall(inside.centre, outside)) return std::nullopt;
  Finding out(isOne ? FindingKind::clicksContradict : FindingKind::ballOverSeed,
              {{"place", placeValue(inside.centre)}, {"outside", placeValue(outside.centre)}});
  if (!isOne) out.values.push_back({"radius_mm", *outside.radius});
  return out;
}

//! How the surface, `distance` mm from the click and perhaps on the wrong side of it, fails to heed it; none:
//! it does, as far as can be told.
std::optional<Finding> faultOf(const Seed& click, bool isWrong, double distance, double voxel) {
  if (isWrong)
    return Finding(click.background ? FindingKind::clickEnclosed : FindingKind::seedNotEnclosed,
                   {{"place", placeValue(click.centre)}, {"distance_mm", distance}});
  if (!click.background || !click.radius || *click.radius - distance <= kDrawn * voxel) return std::nullopt;
  return Finding(FindingKind::ballEntered, {{"place", placeValue(click.centre)},
                                            {"radius_mm", *click.radius},
                                            {"distance_mm", *click.radius - distance}});
}

}  // namespace

std::optional<Finding> contradictionOf(const Grid& grid, const std::vector<Seed>& clicks) {
  for (const Seed& inside : clicks)
    for (const Seed& outside : clicks)
      if (!inside.background && outside.background)
        if (std::optional<Finding> fault = contradictionOf(grid, inside, outside)) return fault;
  return std::nullopt;
}

std::optional<Finding> contradictionOf(const Grid& grid, const Vec3& start, const std::vector<Seed>& clicks) {
  for (const Seed& outside : clicks)
    if (outside.background && (areInOneVoxel(grid, start, outside.centre) || isInBall(start, outside)))
      return Finding(FindingKind::clickOverStart, {{"outside", placeValue(outside.centre)}});
  return std::nullopt;
}

std::vector<Finding> unheededClicks(const Mesh& mesh, const Grid& grid, const std::vector<Seed>& clicks) {
  std::vector<Finding> out;
  if (mesh.faceCount() == 0) return out;
  const Components parts = findComponents(mesh);
  for (auto c = clicks.begin(); c != clicks.end(); ++c) {
    const Seed& click = *c;
    const auto isAgain = [&](const Seed& s) {
      const bool isBall = s.background && s.radius != click.radius;
      return s.centre == click.centre && s.background == click.background && !isBall;
    };
    if (std::any_of(clicks.begin(), c, isAgain)) continue;
    const double distance = distanceTo(mesh, click.centre);
    const bool isWrong =
        distance > kKnown * grid.meanSpacing() && encloses(mesh, parts, click.centre) == click.background;
    if (auto fault = faultOf(click, isWrong, distance, grid.meanSpacing())) out.push_back(*fault);
  }
  return out;
}

}  // namespace handlebody
