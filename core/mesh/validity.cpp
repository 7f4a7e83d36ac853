#include "core/mesh/validity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/mesh/component_volume.h"
#include "core/mesh/nesting.h"
#include "core/mesh/structure.h"
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

//! Those of all faces, sorted: by a counting sort along the lower ends, which hold few each.
std::vector<Edge> sortedEdges(const TriangleSoup& soup) {
  const auto forEachEdge = [&](auto&& f) {
    for (const Triangle& t : soup.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        f(Edge{std::min(a, b), std::max(a, b), a < b});
      }
  };
  std::vector<std::size_t> start(soup.points.size() + 1, 0);
  forEachEdge([&](const Edge& e) { ++start[e.low + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Edge> edges(3 * soup.triangles.size());
  std::vector<std::size_t> fill(start.begin(), start.end() - 1);
  forEachEdge([&](const Edge& e) { edges[fill[e.low]++] = e; });
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(start[v]),
              edges.begin() + static_cast<std::ptrdiff_t>(start[v + 1]));
  return edges;
}

EdgeNumbers examineEdges(const TriangleSoup& soup) {
  const std::vector<Edge> edges = sortedEdges(soup);
  EdgeNumbers n;
  n.distinct.reserve(edges.size() / 2 + 1);
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
    for (int v : t) ++start[v + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::array<int, 2>> spokes(start[n]);
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) spokes[fill[t[i]]++] = {t[(i + 1) % 3], t[(i + 2) % 3]};
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

//! Volume and area, relative to the first point, so that a mesh far from the origin loses no digits.
struct Measures {
  double volume = 0, area = 0;
};
class Measuring {
 public:
  explicit Measuring(const TriangleSoup& soup)
      : points_(soup.points), origin_(points_[soup.triangles[0][0]]) {}
  void add(const Triangle& t, Measures& to) const {
    const Vec3 &a = at(t[0]), &b = at(t[1]), &p = at(t[2]);
    to.volume += (a - origin_).dot((b - origin_).cross(p - origin_)) / 6;
    to.area += (b - a).cross(p - a).norm() / 2;
  }

 private:
  const Vec3& at(int v) const { return points_[v]; }
  const std::vector<Vec3>& points_;
  const Vec3& origin_;
};

//! The components of a soup, with their Euler numbers.
struct SoupComponents {
  Components parts;
  std::vector<int> euler;
};

SoupComponents componentsOf(const TriangleSoup& soup, const std::vector<Edge>& edges) {
  UnionFind joined(soup.points.size());
  SoupComponents out;
  std::vector<int>& label = out.parts.ofVertex;
  label.assign(soup.points.size(), -1);
  for (const Triangle& t : soup.triangles) {
    for (int v : t) label[v] = 0;
    joined.join(t[0], t[1]);
    joined.join(t[0], t[2]);
  }
  for (std::size_t v = 0; v < label.size(); ++v) {
    if (label[v] < 0) continue;
    const int lowest = joined.find(static_cast<int>(v));
    if (lowest == static_cast<int>(v)) {
      label[v] = out.parts.count();
      out.parts.vertices.push_back(0);
    }
    label[v] = label[lowest];
    ++out.parts.vertices[label[v]];
  }
  out.euler = out.parts.vertices;
  for (const Edge& e : edges) --out.euler[label[e.low]];
  for (const Triangle& t : soup.triangles) ++out.euler[label[t[0]]];
  return out;
}

std::vector<double> volumesOf(const TriangleSoup& soup, const Components& parts) {
  std::vector<int> first(parts.vertices.size(), -1);
  for (std::size_t v = parts.ofVertex.size(); v-- > 0;)
    if (parts.ofVertex[v] >= 0) first[parts.ofVertex[v]] = static_cast<int>(v);
  std::vector<double> volumes(parts.vertices.size(), 0);
  for (const Triangle& t : soup.triangles) {
    const int part = parts.ofVertex[t[0]];
    volumes[part] +=
        volumeTerm(soup.points[first[part]], soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  }
  return volumes;
}

//! Cavities, and components that are in each other's way. Precondition: closed, manifold, oriented.
void examineNesting(const LabelledSurface& surface, Certificate& c) {
  c.cavities = static_cast<int>(std::count_if(surface.parts.volume.begin(), surface.parts.volume.end(),
                                              [](double v) { return v < 0; }));
  c.misplaced = static_cast<int>(misplacedComponents(surface).size());
}

}  // namespace

Certificate examine(const TriangleSoup& soup) {
  Certificate c;
  c.faces = static_cast<int>(soup.triangles.size());
  if (c.faces == 0) return c;
  const Measuring measuring(soup);
  Measures all;
  for (const Triangle& t : soup.triangles) measuring.add(t, all);
  c.volume = all.volume;
  c.area = all.area;
  const EdgeNumbers edges = examineEdges(soup);
  c.closed = edges.closed;
  c.manifold = facesAreProper(soup) && edges.manifold && linksAreSingle(soup);
  c.oriented = edges.oriented && c.volume > 0;

  SoupComponents s = componentsOf(soup, edges.distinct);
  c.components = s.parts.count();
  for (const int n : s.parts.vertices) c.vertices += n;
  for (const int euler : s.euler) c.euler += euler;
  if (!c.closed || !c.manifold || !edges.oriented) return c;
  for (const int euler : s.euler) c.genus.push_back((2 - euler) / 2);
  if (!c.oriented) return c;
  s.parts.volume = volumesOf(soup, s.parts);
  examineNesting({soup.points, soup.triangles, s.parts}, c);
  return c;
}

Certificate examine(const Mesh& mesh) {
  if (findStructureFault(mesh)) return examine(mesh.compact());
  Certificate c;
  const Components parts = findComponents(mesh);
  c.vertices = mesh.vertexCount();
  c.faces = mesh.faceCount();
  c.components = parts.count();
  for (std::size_t i = 0; i < parts.vertices.size(); ++i) {
    const int euler = parts.vertices[i] - parts.faces[i] / 2;  // 2 E = 3 F
    c.euler += euler;
    c.genus.push_back((2 - euler) / 2);
    c.volume += parts.volume[i];
  }
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) c.area += mesh.areaVector(f).norm() / 2;
  c.closed = c.manifold = c.faces > 0;
  c.oriented = c.volume > 0;
  if (c.oriented) examineNesting(labelled(mesh, parts), c);
  return c;
}

}  // namespace handlebody
