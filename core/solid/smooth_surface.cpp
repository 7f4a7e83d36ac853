#include "core/solid/smooth_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/cancellation.h"
#include "core/solid/label_mesh.h"

namespace handlebody {

namespace {

constexpr int kLevelPasses = 20;       // of the mean over neighbours: a radius of some three voxels
constexpr double kLongestStep = 0.25;  // voxels, towards the level
constexpr double kSameWay = 0.3;       // cosine; steps of voxels are within 55° of the surface meant

TriangleSoup onGrid(TriangleSoup mesh, const Grid& grid) {
  for (Vec3& p : mesh.points) p = grid.toIndex(p);
  return mesh;
}

//! The place nearest to `index` along the normal, and then on the way from the anchor, that it may go to.
//! Voxels.
Vec3 withinReach(const Vec3& anchor, const Vec3& index, const Vec3& normal, const VertexReach& reach) {
  Vec3 way = index - anchor;
  const double along = way.dot(normal);
  way += (std::clamp(along, -reach.along, reach.along) - along) * normal;
  const double length = way.norm();
  return anchor + (length > reach.any ? reach.any / length : 1.0) * way;
}

}  // namespace

bool isCrossing(const Vec3& index) {
  int halves = 0;
  for (int a = 0; a < 3; ++a) {
    const double twice = 2 * index[a], whole = std::round(twice);
    if (std::abs(twice - whole) > 1e-6) return false;
    halves += static_cast<long>(whole) % 2 != 0;
  }
  return halves == 1;
}

SmoothSurface::SmoothSurface(const Mask& mask, const TriangleSoup& surface, const Vec3& sigma)
    : grid_(mask.grid),
      blurred_(mask, sigma),
      inVoxels_(onGrid(surface, mask.grid)),
      nearest_(inVoxels_),
      levels_(meanLevels(Mesh(surface))) {}

Vec3 SmoothSurface::towards(const VertexAim& place, int& hint) const {
  const Vec3 start = grid_.toIndex(place.from);
  Vec3 index = grid_.toIndex(place.to);
  if (hint < 0) nearest_.distance(index, &hint);
  const Triangle& t = inVoxels_.triangles[hint];
  const double level = (levels_[t[0]] + levels_[t[1]] + levels_[t[2]]) / 3;
  index += step(index, level);
  index += step(index, level);
  index += outwards(index, place.offset);
  const Vec3 normal = normalInVoxels(place.normal);
  index = withinReach(grid_.toIndex(place.anchor), index, normal, place.reach);
  for (int i = 0; i < 4; ++i, index = (index + start) / 2)
    if (nearest_.distance(index, &hint) <= kMaxMove && facesLike(normal, hint)) return grid_.toWorld(index);
  return place.from;
}

//! Normals go the other way than points: a plane stays a plane.
Vec3 SmoothSurface::normalInVoxels(const Vec3& normal) const {
  const double turned = grid_.direction.determinant() < 0 ? -1 : 1;
  return (turned * (grid_.direction.transpose() * normal).cwiseProduct(grid_.spacing)).normalized();
}

bool SmoothSurface::facesLike(const Vec3& normal, int triangle) const {
  const Triangle& t = inVoxels_.triangles[triangle];
  const Vec3& a = inVoxels_.points[t[0]];
  const Vec3 there = (inVoxels_.points[t[1]] - a).cross(inVoxels_.points[t[2]] - a);
  return normal.dot(there) > kSameWay * there.norm();
}

Vec3 SmoothSurface::step(const Vec3& index, double level) const {
  const Vec3 g = blurred_.gradient(index);
  const double squared = g.squaredNorm();
  if (squared < 1e-6) return Vec3::Zero();
  const Vec3 s = (level - blurred_.at(index)) / squared * g;
  const double length = s.norm();
  return length > kLongestStep ? s * (kLongestStep / length) : s;
}

//! Only where an edge of the grid crosses the surface is its place known without bias: what fills corners
//! begins with the mean of its neighbours.
double SmoothSurface::firstLevel(const Mesh& mesh, int v) const {
  if (isCrossing(inVoxels_.points[v])) return blurred_.at(inVoxels_.points[v]);
  double sum = 0;
  int n = 0;
  mesh.forEachNeighbour(v, [&](int w) {
    sum += blurred_.at(inVoxels_.points[w]);
    ++n;
  });
  return sum / n;
}

//! A way of `offset` mm, in voxels.
Vec3 SmoothSurface::outwards(const Vec3& index, double offset) const {
  const Vec3 g = blurred_.gradient(index).cwiseQuotient(grid_.spacing);  // per mm
  const double length = g.norm();
  if (offset == 0 || !(length > 0)) return Vec3::Zero();
  return (-offset / length * g).cwiseQuotient(grid_.spacing);
}

std::vector<double> SmoothSurface::meanLevels(const Mesh& mesh) const {
  std::vector<double> level(inVoxels_.points.size()), next(level.size());
  for (std::size_t v = 0; v < level.size(); ++v) level[v] = firstLevel(mesh, static_cast<int>(v));
  for (int pass = 0; pass < kLevelPasses; ++pass) {
    giveUpIfCancelled();
    for (int v = 0; v < mesh.vertexSlots(); ++v) {
      double sum = level[v];
      int n = 1;
      mesh.forEachNeighbour(v, [&](int w) {
        sum += level[w];
        ++n;
      });
      next[v] = sum / n;
    }
    level.swap(next);
  }
  return level;
}

}  // namespace handlebody
