#include "core/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace handlebody {

namespace {

TriangleSoup icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleSoup s;
  s.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return s;
}

//! Index of the point at parts (wa, wb, wc) of n along face (a, b, c); the same point for every face that has
//! it.
class PointTable {
 public:
  PointTable(const TriangleSoup& base, TriangleSoup& out) : base_(base), out_(out) {}
  int at(const Triangle& t, std::array<int, 3> w) {
    std::map<int, int> key;
    Vec3 p(0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i)
      if (w[i] > 0) {
        key[t[i]] = w[i];
      }
    for (const auto& [v, weight] : key) p += weight * base_.points[v];
    const auto [it, isNew] = known_.try_emplace(key, static_cast<int>(out_.points.size()));
    if (isNew) out_.points.push_back(p.normalized());
    return it->second;
  }

 private:
  const TriangleSoup& base_;
  TriangleSoup& out_;
  std::map<std::map<int, int>, int> known_;
};

}  // namespace

TriangleSoup icosphere(const Vec3& centre, double radius, double edgeLength) {
  const TriangleSoup base = icosahedron();
  // The longest edge of the projected subdivision is about 1.24 times the icosahedron's edge (1.0515 r) over
  // n.
  const int n = std::max(1, static_cast<int>(std::ceil(1.24 * 1.0515 * radius / edgeLength)));
  TriangleSoup s;
  PointTable table(base, s);
  for (const Triangle& t : base.triangles)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j + i < n; ++j) {
        const auto point = [&](int a, int b) { return table.at(t, {n - a - b, a, b}); };
        s.triangles.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
        if (i + j + 2 <= n) s.triangles.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
      }
  for (Vec3& p : s.points) p = centre + radius * p;
  return s;
}

}  // namespace handlebody
