#pragma once
// Meshes for the tests of core/io, and their measures.

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "core/mesh/mesh.h"

namespace handlebody::test {

//! Octahedron subdivided `levels` times and pushed onto a sphere; outward.
inline TriangleSoup sphere(const Vec3& centre, double radius, int levels) {
  TriangleSoup s{
      {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(s.points.size()));
      if (fresh) s.points.push_back((s.points[a] + s.points[b]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : s.triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      for (const Triangle& f :
           {Triangle{t[0], ab, ca}, Triangle{ab, t[1], bc}, Triangle{ca, bc, t[2]}, Triangle{ab, bc, ca}})
        finer.push_back(f);
    }
    s.triangles = std::move(finer);
  }
  for (Vec3& p : s.points) p = centre + radius * p;
  return s;
}

inline double signedVolume(const TriangleSoup& s) {
  double sum = 0;
  for (const Triangle& t : s.triangles) {
    const auto p = [&](std::size_t c) -> const Vec3& { return s.points[t[c]]; };
    sum += p(0).dot(p(1).cross(p(2))) / 6;
  }
  return sum;
}

inline double area(const TriangleSoup& s) {
  double sum = 0;
  for (const Triangle& t : s.triangles) {
    const auto p = [&](std::size_t c) -> const Vec3& { return s.points[t[c]]; };
    sum += (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
  }
  return sum;
}

//! Winding number by solid angles (Van Oosterom and Strackee): the oracle of rasterize.
inline double windingNumber(const TriangleSoup& s, const Vec3& q) {
  double angle = 0;
  for (const Triangle& t : s.triangles) {
    const Vec3 a = s.points[t[0]] - q, b = s.points[t[1]] - q, c = s.points[t[2]] - q;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * M_PI);
}

}  // namespace handlebody::test
