#include "core/mesh/certificate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/mesh/union_find.h"

namespace handlebody {

namespace {

struct Edge {
  int low, high;
  bool forward;  //!< the face holds it as low → high
  bool sameEdge(const Edge& o) const { return low == o.low && high == o.high; }
  bool operator<(const Edge& o) const { return low != o.low ? low < o.low : high < o.high; }
};

struct EdgeNumbers {
  bool closed = true, manifold = true, oriented = true;
  std::vector<Edge> distinct;
};

EdgeNumbers examineEdges(const TriangleSoup& soup) {
  std::vector<Edge> edges;
  edges.reserve(3 * soup.triangles.size());
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(edges.begin(), edges.end());
  EdgeNumbers n;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    int forward = 0;
    for (; j < edges.size() && edges[j].sameEdge(edges[i]); ++j) forward += edges[j].forward ? 1 : -1;
    n.closed = n.closed && j - i == 2;
    n.manifold = n.manifold && j - i <= 2;
    n.oriented = n.oriented && (j - i != 2 || forward == 0);
    n.distinct.push_back(edges[i]);
    i = j;
  }
  return n;
}

//! True if the faces around every vertex form one fan: the link is one cycle or one path.
bool linksAreSingle(const TriangleSoup& soup) {
  const std::size_t n = soup.points.size();
  std::vector<int> start(n + 1, 0);
  for (const Triangle& t : soup.triangles)
    for (int v : t) ++start[static_cast<std::size_t>(v) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::array<int, 2>> spokes(static_cast<std::size_t>(start[n]));
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      spokes[static_cast<std::size_t>(fill[static_cast<std::size_t>(t[i])]++)] = {t[(i + 1) % 3],
                                                                                  t[(i + 2) % 3]};
  std::vector<char> reached;
  std::vector<std::size_t> queue;
  for (std::size_t v = 0; v < n; ++v) {
    const std::span<const std::array<int, 2>> fan(spokes.data() + start[v],
                                                  static_cast<std::size_t>(start[v + 1] - start[v]));
    if (fan.empty()) continue;
    reached.assign(fan.size(), 0);
    reached[0] = 1;
    queue.assign(1, 0);
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (std::size_t j = 0; j < fan.size(); ++j)
        if (!reached[j]) {
          const auto& a = fan[queue[q]];
          const auto& b = fan[j];
          if (a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1]) continue;
          reached[j] = 1;
          queue.push_back(j);
        }
    if (queue.size() != fan.size()) return false;
  }
  return true;
}

bool facesAreProper(const TriangleSoup& soup) {
  return std::all_of(soup.triangles.begin(), soup.triangles.end(),
                     [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
}

}  // namespace

Certificate examine(const TriangleSoup& soup) {
  Certificate c;
  c.faces = static_cast<int>(soup.triangles.size());
  if (c.faces == 0) return c;
  UnionFind parts(soup.points.size());
  std::vector<char> used(soup.points.size(), 0);
  for (const Triangle& t : soup.triangles) {
    for (int v : t) used[static_cast<std::size_t>(v)] = 1;
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
    const Vec3 &a = soup.points[static_cast<std::size_t>(t[0])],
               &b = soup.points[static_cast<std::size_t>(t[1])],
               &p = soup.points[static_cast<std::size_t>(t[2])];
    // Relative to the first point, so that a mesh far from the origin loses no digits.
    const Vec3& o = soup.points[static_cast<std::size_t>(soup.triangles[0][0])];
    c.volume += (a - o).dot((b - o).cross(p - o)) / 6;
    c.area += (b - a).cross(p - a).norm() / 2;
  }
  const EdgeNumbers edges = examineEdges(soup);
  const bool proper = facesAreProper(soup);
  c.closed = edges.closed;
  c.manifold = proper && edges.manifold && linksAreSingle(soup);
  c.oriented = edges.oriented && c.volume > 0;

  std::vector<int> euler(soup.points.size(), 0);
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) {
      ++c.vertices;
      ++euler[static_cast<std::size_t>(parts.find(static_cast<int>(v)))];
    }
  for (const Edge& e : edges.distinct) --euler[static_cast<std::size_t>(parts.find(e.low))];
  for (const Triangle& t : soup.triangles) ++euler[static_cast<std::size_t>(parts.find(t[0]))];
  const bool genusDefined = c.closed && c.manifold && edges.oriented;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] && parts.find(static_cast<int>(v)) == static_cast<int>(v)) {
      ++c.components;
      c.euler += euler[v];
      if (genusDefined) c.genus.push_back((2 - euler[v]) / 2);
    }
  return c;
}

}  // namespace handlebody
