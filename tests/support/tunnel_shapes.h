#pragma once
// Surfaces with tunnels, from formulas.

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "tests/support/mesh_zoo.h"

namespace handlebody::zoo {

inline TriangleSoup insideOut(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

//! The surface of the unit cubes (i, j, k) in [0, n)³ of which `holds` is true, each side divided in parts².
//! Precondition: no two cubes meet in an edge or corner only.
inline TriangleSoup blocks(int n, int parts, const std::function<bool(int, int, int)>& holds) {
  TriangleSoup s;
  std::map<std::array<int, 3>, int> known;
  const int m = n * parts;
  const auto solid = [&](const std::array<int, 3>& c) {
    for (const int x : c)
      if (x < 0 || x >= m) return false;
    return holds(c[0] / parts, c[1] / parts, c[2] / parts);
  };
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, isNew] = known.try_emplace(p, static_cast<int>(s.points.size()));
    if (isNew) s.points.push_back(Vec3(p[0], p[1], p[2]) / parts);
    return it->second;
  };
  std::array<int, 3> c{};
  for (c[0] = 0; c[0] < m; ++c[0])
    for (c[1] = 0; c[1] < m; ++c[1])
      for (c[2] = 0; c[2] < m; ++c[2])
        for (std::size_t axis = 0; solid(c) && axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> beside = c;
            beside[axis] += side == 0 ? -1 : 1;
            if (solid(beside)) continue;
            std::array<int, 3> p = c;
            p[axis] += side;
            std::array<int, 4> q{};
            for (int k = 0; k < 4; ++k) {
              std::array<int, 3> corner = p;
              corner[(axis + 1) % 3] += k == 1 || k == 2;
              corner[(axis + 2) % 3] += k >= 2;
              q[k] = vertex(corner);
            }
            if (side == 0) std::swap(q[1], q[3]);
            s.triangles.push_back({q[0], q[1], q[2]});
            s.triangles.push_back({q[0], q[2], q[3]});
          }
  return s;
}

//! The twelve edges of a cube as bars of 1 × 1, 3 long: genus 5.
inline TriangleSoup frame(int parts) {
  return blocks(3, parts, [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) <= 1; });
}

//! A tube of radius r around a trefoil knot of about 6 across: a torus that no disc outside closes.
inline TriangleSoup trefoil(int around, int across, double r) {
  const auto curve = [](double t) {
    return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
  };
  TriangleSoup s = torus(around, across, 2, 1);
  for (int i = 0; i < around; ++i) {
    const double t = 2 * std::numbers::pi * i / around;
    const Vec3 along = (curve(t + 1e-4) - curve(t - 1e-4)).normalized();
    const Vec3 out = along.cross(Vec3(0.1, 0.2, 1)).normalized(), up = out.cross(along);
    for (int j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across;
      at(s, i * across + j) = curve(t) + r * (std::cos(v) * out + std::sin(v) * up);
    }
  }
  return s;
}

}  // namespace handlebody::zoo
