#pragma once
// How far a surface keeps from walls, by formulas of its own: brute force over all faces and walls.

#include <algorithm>
#include <limits>

#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"

namespace handlebody::testing {

//! Distance of p from a triangle by minimizing over it: the foot in its plane, or the nearest of its edges.
inline double bruteDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto toSegment = [&](const Vec3& from, const Vec3& end) {
    const double l = (end - from).squaredNorm();
    const double along = l > 0 ? std::clamp((p - from).dot(end - from) / l, 0.0, 1.0) : 0;
    return (from + along * (end - from) - p).norm();
  };
  double best = std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
  // Cramer's rule: Eigen's decompositions take 8 s to compile in each file that reads this.
  const Vec3 u = b - a, v = c - a, to = p - a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  if (determinant <= 0) return best;
  const double s = (vv * u.dot(to) - uv * v.dot(to)) / determinant;
  const double t = (uu * v.dot(to) - uv * u.dot(to)) / determinant;
  if (s >= 0 && t >= 0 && s + t <= 1) best = std::min(best, (s * u + t * v - to).norm());
  return best;
}

//! mm that the faces keep from the nearest ball: negative if one lies in it.
inline double clearance(const Mesh& mesh, const std::vector<WallBall>& balls) {
  double least = std::numeric_limits<double>::infinity();
  for (const WallBall& w : balls)
    for (const Triangle& t : mesh.faces()) {
      if (t[0] < 0) continue;
      const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
      const double size = std::max((b - a).norm(), (c - a).norm());
      if ((a - w.centre).norm() - size - w.radius > least) continue;
      least = std::min(least, bruteDistance(w.centre, a, b, c) - w.radius);
    }
  return least;
}

//! True if a point of a fine sampling of the faces lies in a voxel of the map.
inline bool entersMap(const Mesh& mesh, const WallMap& map, const Grid& grid) {
  constexpr int kFine = 12;
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    for (int i = 0; i <= kFine; ++i)
      for (int j = 0; i + j <= kFine; ++j) {
        const double u = double(i) / kFine, v = double(j) / kFine;
        const Vec3 p = (1 - u - v) * mesh.position(t[0]) + u * mesh.position(t[1]) + v * mesh.position(t[2]);
        const Vec3 index = grid.toIndex(p);
        if (!grid.contains(index)) continue;
        const auto at = [&](int a) { return static_cast<std::size_t>(std::floor(index[a] + 0.5)); };
        const auto n0 = static_cast<std::size_t>(grid.size[0]), n1 = static_cast<std::size_t>(grid.size[1]);
        if ((*map.voxels)[(at(2) * n1 + at(1)) * n0 + at(0)]) return true;
      }
  }
  return false;
}

//! A map of the voxels for which f(i, j, k) holds.
template <typename F>
WallMap wallMap(const Grid& grid, F&& f) {
  std::vector<bool> voxels;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) voxels.push_back(f(i, j, k));
  return {{}, {}, std::make_shared<const std::vector<bool>>(std::move(voxels))};
}

}  // namespace handlebody::testing
