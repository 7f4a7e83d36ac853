#include "core/evolution/start_object.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

#include "core/evolution/object_image.h"
#include "core/geometry/triangle_distance.h"
#include "core/solid/rasterize.h"

namespace handlebody {

namespace {

constexpr double kStartBall = 0.8;  // of the depth of a place in a surface to begin with
constexpr double kMargin = 2;       // voxels around it
constexpr double kNear = 2.5;  // voxels: what is drawn by hand or by a network lies next to what it means
constexpr double kElsewhere = 0.2, kEverywhere = 0.8;  // of its area

}  // namespace

Seed seedWithin(const StartSurface& start) {
  // To the nearest face: vertices may be far apart.
  double least = std::numeric_limits<double>::infinity();
  const auto& p = start.mesh->points;
  for (const Triangle& t : start.mesh->triangles)
    least = std::min(least, squaredDistance(start.inside, p[t[0]], p[t[1]], p[t[2]]));
  return {start.inside, kStartBall * std::sqrt(least), false};
}

std::shared_ptr<const RegionInCells> cellsWithin(const StartSurface& start, const Grid& volume) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : start.mesh->points) {
    low = low.cwiseMin(volume.toIndex(p));
    high = high.cwiseMax(volume.toIndex(p));
  }
  const double margin = kMargin * volume.spacing.maxCoeff();
  auto out = std::make_shared<RegionInCells>();
  out->cells = cellsAround(volume, {{volume.toWorld(low), margin}, {volume.toWorld(high), margin}},
                           ObjectPolicy().workCells);
  const Volume held = rasterize(*start.mesh, out->cells.grid);
  const auto* voxels = static_cast<const std::uint8_t*>(held.voxels.get());
  out->region.inside.assign(voxels, voxels + out->cells.count());
  return out;
}

bool outlinesPart(const StartSurface& start, const ObjectChoice& boundary) {
  const ObjectImage image(boundary.volume, boundary.range, boundary.contrast, boundary.levels, boundary.neck,
                          boundary.view);
  const double reach = kNear * boundary.volume->grid().meanSpacing();
  const auto& p = start.mesh->points;
  double near = 0, all = 0;
  for (const Triangle& t : start.mesh->triangles) {
    const Vec3 across = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
    const double area = across.norm();
    if (!(area > 0)) continue;
    const Vec3 middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3, step = reach / area * across;
    all += area;
    if (image.inside(middle - step) > 0 && image.inside(middle + step) <= 0) near += area;
  }
  return near >= kElsewhere * all && near <= kEverywhere * all;
}

}  // namespace handlebody
