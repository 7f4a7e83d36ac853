#include "tests/collision_oracle/oracle.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace handlebody::oracle {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Exact::Point_3;
using Segment = Exact::Segment_3;
using Solid = Exact::Triangle_3;

Point point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

//! A face as a point set: one, two or three corners.
std::vector<Point> hull(const TriangleSoup& s, const Triangle& t) {
  std::vector<Point> p;
  for (const int v : t) p.push_back(point(s.points[v]));
  if (!CGAL::collinear(p[0], p[1], p[2])) return p;
  std::sort(p.begin(), p.end());
  if (p.front() == p.back()) return {p.front()};
  return {p.front(), p.back()};
}

//! The corners of the intersection of two convex sets; empty: no intersection.
struct Corners : boost::static_visitor<std::vector<Point>> {
  std::vector<Point> operator()(const Point& p) const { return {p}; }
  std::vector<Point> operator()(const Segment& s) const { return {s.source(), s.target()}; }
  std::vector<Point> operator()(const Solid& t) const { return {t[0], t[1], t[2]}; }
  std::vector<Point> operator()(const std::vector<Point>& p) const { return p; }
};

template <typename A, typename B>
std::vector<Point> meet(const A& a, const B& b) {
  const auto result = CGAL::intersection(a, b);
  return result ? boost::apply_visitor(Corners(), *result) : std::vector<Point>{};
}

template <typename A>
std::vector<Point> meetHull(const A& a, const std::vector<Point>& b) {
  if (b.size() == 3) return meet(a, Solid(b[0], b[1], b[2]));
  if (b.size() == 2) return meet(a, Segment(b[0], b[1]));
  return a.has_on(b[0]) ? std::vector<Point>{b[0]} : std::vector<Point>{};
}

std::vector<Point> meetHulls(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() == 3) return meetHull(Solid(a[0], a[1], a[2]), b);
  if (a.size() == 2) return meetHull(Segment(a[0], a[1]), b);
  if (b.size() > 1) return meetHulls(b, a);
  return a[0] == b[0] ? a : std::vector<Point>{};
}

}  // namespace

bool facesIntersect(const TriangleSoup& soup, const Triangle& a, const Triangle& b) {
  std::set<int> shared;
  for (const int v : a) {
    if (std::find(b.begin(), b.end(), v) != b.end()) shared.insert(v);
  }
  if (shared.size() == 3) return true;
  std::vector<Point> simplex;
  for (const int v : shared) simplex.push_back(point(soup.points[v]));
  const auto inShared = [&](const Point& p) {
    if (simplex.empty()) return false;
    if (simplex.size() == 1 || simplex[0] == simplex[1]) return p == simplex[0];
    return Segment(simplex[0], simplex[1]).has_on(p);
  };
  const std::vector<Point> corners = meetHulls(hull(soup, a), hull(soup, b));
  return !std::all_of(corners.begin(), corners.end(), inShared);
}

std::vector<FacePair> selfIntersectionsByDefinition(const TriangleSoup& soup) {
  std::vector<FacePair> pairs;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    for (std::size_t g = f + 1; g < soup.triangles.size(); ++g) {
      if (facesIntersect(soup, soup.triangles[f], soup.triangles[g])) {
        pairs.emplace_back(static_cast<int>(f), static_cast<int>(g));
      }
    }
  }
  return pairs;
}

struct PreparedMesh::Data {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  Mesh mesh;

  auto pairs() const {
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
    return found;
  }
};

PreparedMesh::PreparedMesh(const TriangleSoup& soup) : data_(std::make_unique<Data>()) {
  Data::Mesh& mesh = data_->mesh;
  std::vector<Data::Mesh::Vertex_index> vertex;
  for (const Vec3& p : soup.points) vertex.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle& t : soup.triangles) {
    const auto at = [&](std::size_t i) { return vertex[t[i]]; };
    if (mesh.add_face(at(0), at(1), at(2)) == Data::Mesh::null_face()) {
      throw std::invalid_argument("not a manifold");
    }
  }
}

PreparedMesh::~PreparedMesh() = default;

std::size_t PreparedMesh::countSelfIntersections() const { return data_->pairs().size(); }

std::vector<FacePair> PreparedMesh::selfIntersections() const {
  std::vector<FacePair> pairs;
  for (const auto& [f, g] : data_->pairs()) {
    const auto i = static_cast<int>(f.idx());
    const auto j = static_cast<int>(g.idx());
    pairs.emplace_back(std::min(i, j), std::max(i, j));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<FacePair> selfIntersections(const TriangleSoup& soup) {
  return PreparedMesh(soup).selfIntersections();
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return CGAL::orientation(point(a), point(b), point(c), point(d));
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const auto flat = [&](const Vec3& p) { return Exact::Point_2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
  return CGAL::orientation(flat(a), flat(b), flat(c));
}

}  // namespace handlebody::oracle
