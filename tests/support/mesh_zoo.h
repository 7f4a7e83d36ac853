#pragma once
// Meshes to test with: clean, folded, overlapping, degenerate, uneven. All from formulas and seeds.

#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/shapes.h"

namespace handlebody::zoo {

inline Vec3& at(TriangleSoup& s, int v) { return s.points[v]; }

//! Sphere of radius 1 with 20·n² triangles.
inline TriangleSoup sphere(int n) { return icosphere(Vec3(0, 0, 0), 1, 1.24 * 1.0515 / (n - 0.5)); }

//! Sphere with waves of height 0.1; phase in radians.
inline TriangleSoup bumpySphere(int n, double phase) {
  TriangleSoup s = sphere(n);
  for (Vec3& p : s.points) {
    p *= 1 + 0.1 * std::sin(7 * p.x() + phase) * std::sin(6 * p.y() - phase) * std::cos(5 * p.z());
  }
  return s;
}

inline TriangleSoup torus(int around, int across, double R, double r) {
  TriangleSoup s;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / across;
      const double w = R + r * std::cos(v);
      s.points.emplace_back(w * std::cos(u), w * std::sin(u), r * std::sin(v));
    }
  }
  const auto id = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return s;
}

//! Axis-aligned cube [0,1]³: the sphere of six n×n grids, everything coplanar.
inline TriangleSoup cube(int n) {
  TriangleSoup s;
  std::vector<int> known(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
  const auto id = [&](int i, int j, int k) {
    int& v = known[(i * (n + 1) + j) * (n + 1) + k];
    if (v < 0) {
      v = static_cast<int>(s.points.size());
      s.points.emplace_back(double(i) / n, double(j) / n, double(k) / n);
    }
    return v;
  };
  const auto quad = [&](int a, int b, int c, int d) {
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      quad(id(i, j, 0), id(i, j + 1, 0), id(i + 1, j + 1, 0), id(i + 1, j, 0));
      quad(id(i, j, n), id(i + 1, j, n), id(i + 1, j + 1, n), id(i, j + 1, n));
      quad(id(0, i, j), id(0, i, j + 1), id(0, i + 1, j + 1), id(0, i + 1, j));
      quad(id(n, i, j), id(n, i + 1, j), id(n, i + 1, j + 1), id(n, i, j + 1));
      quad(id(i, 0, j), id(i + 1, 0, j), id(i + 1, 0, j + 1), id(i, 0, j + 1));
      quad(id(i, n, j), id(i, n, j + 1), id(i + 1, n, j + 1), id(i + 1, n, j));
    }
  }
  return s;
}

//! Two cones over a polygon of k vertices that winds `turns` times around the axis. With turns = 2 all
//! normals of a cone lie within a half space although it intersects itself: a folded rose.
inline TriangleSoup rose(int k, int turns) {
  TriangleSoup s;
  for (int i = 0; i < k; ++i) {
    const double u = 2 * std::numbers::pi * turns * i / k;
    s.points.emplace_back(std::cos(u), std::sin(u), 0.05 * std::sin(3 * u + i));
  }
  s.points.emplace_back(0.01, 0.02, 0.4);
  s.points.emplace_back(-0.01, 0.02, -0.4);
  for (int i = 0; i < k; ++i) {
    s.triangles.push_back({k, i, (i + 1) % k});
    s.triangles.push_back({k + 1, (i + 1) % k, i});
  }
  return s;
}

//! A fine sphere with long spikes, some of which run through it: edges from 1/n to 150.
inline TriangleSoup spikySphere(int n) {
  TriangleSoup s = sphere(n);
  for (std::size_t v = 0; v < s.points.size(); v += 97)
    s.points[v] = (v % 2 == 0 ? 100.0 : -30.0) * s.points[v];
  return s;
}

//! Triangles with vertices drawn from random points of the lattice {0..size-1}³: not a manifold, many
//! degenerate, coplanar, touching and duplicate ones.
inline TriangleSoup latticeSoup(int points, int triangles, int size, unsigned seed) {
  std::mt19937 random(seed);
  TriangleSoup s;
  for (int i = 0; i < points; ++i) {
    const double x = static_cast<double>(random() % static_cast<unsigned>(size));
    const double y = static_cast<double>(random() % static_cast<unsigned>(size));
    const double z = static_cast<double>(random() % static_cast<unsigned>(size));
    s.points.emplace_back(x, y, z);
  }
  const auto any = [&] { return static_cast<int>(random() % static_cast<unsigned>(points)); };
  for (int i = 0; i < triangles; ++i) {
    const int a = any(), b = any(), c = any();
    s.triangles.push_back({a, b, c});
  }
  return s;
}

inline TriangleSoup perturbed(TriangleSoup s, double amount, unsigned seed) {
  std::mt19937 random(seed);
  const auto noise = [&] { return amount * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1); };
  for (Vec3& p : s.points) {
    const double x = noise(), y = noise(), z = noise();
    p += Vec3(x, y, z);
  }
  return s;
}

inline TriangleSoup moved(TriangleSoup s, const Vec3& by) {
  for (Vec3& p : s.points) p += by;
  return s;
}

inline TriangleSoup scaled(TriangleSoup s, double by) {
  for (Vec3& p : s.points) p *= by;
  return s;
}

inline TriangleSoup ball(double radius, const Vec3& at) { return moved(scaled(sphere(4), radius), at); }

inline TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
  const int shift = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

//! Two bumpy spheres with 40·n² triangles that overlap a little.
inline TriangleSoup overlappingSpheres(int n) {
  return both(bumpySphere(n, 0), moved(bumpySphere(n, 1), Vec3(1.7, 0.11, 0.07)));
}

//! All kinds that intersect themselves.
inline std::vector<TriangleSoup> intersecting() {
  return {overlappingSpheres(6),
          perturbed(sphere(6), 0.3, 1),
          perturbed(torus(20, 10, 2, 0.7), 0.5, 2),
          perturbed(cube(4), 0.15, 3),
          rose(9, 2),
          rose(50, 3),
          spikySphere(10),
          both(cube(3), cube(3)),
          latticeSoup(60, 120, 5, 4)};
}

//! The same mesh with vertices and faces in a random order and faces turned.
inline TriangleSoup shuffled(const TriangleSoup& s, unsigned seed, std::vector<int>* newFace = nullptr) {
  std::mt19937 random(seed);
  const auto permutation = [&](std::size_t n) {
    std::vector<int> p(n);
    for (std::size_t i = 0; i < n; ++i) p[i] = static_cast<int>(i);
    for (std::size_t i = n; i > 1; --i) std::swap(p[i - 1], p[random() % i]);
    return p;
  };
  const std::vector<int> vertex = permutation(s.points.size());
  const std::vector<int> face = permutation(s.triangles.size());
  TriangleSoup r = s;
  for (std::size_t v = 0; v < s.points.size(); ++v) at(r, vertex[v]) = s.points[v];
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    const Triangle& t = s.triangles[f];
    const std::size_t turn = random() % 3;
    Triangle& target = r.triangles[face[f]];
    for (std::size_t i = 0; i < 3; ++i) target[i] = vertex[t[(i + turn) % 3]];
  }
  if (newFace != nullptr) *newFace = face;
  return r;
}

}  // namespace handlebody::zoo
