#include "core/mesh/nesting.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace handlebody {

namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! A place, and the component that does not count there.
struct Query {
  Vec3 place;
  int without = -1;
  int winding = 0;
};

int sign(double x) { return (x > 0) - (x < 0); }

//! The side of the line ab on which p lies, seen along z. Points on it count to one side: p is taken to lie
//! beside itself by an infinitely small step along x and a smaller one along y, so that a line through p
//! meets no edge and no vertex.
int side(const Vec3& a, const Vec3& b, const Vec3& p) {
  const int exact = orient2d(a, b, p, 2);
  if (exact != 0) return exact;
  return a.y() != b.y() ? sign(a.y() - b.y()) : sign(b.x() - a.x());
}

//! What the face adds to the winding number of p: 1 if it lies above p and looks up, -1 if it looks down.
int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const int turn = side(a, b, p);
  if (turn == 0 || side(b, c, p) != turn || side(c, a, p) != turn) return 0;
  return orient3d(a, b, c, p) == -turn ? turn : 0;
}

//! The winding numbers of all queries, in one look at every face. Sorts them by x.
void wind(const LabelledSurface& surface, std::vector<Query>& queries) {
  const auto before = [](const Query& q, double x) { return q.place.x() < x; };
  std::sort(queries.begin(), queries.end(),
            [](const Query& a, const Query& b) { return a.place.x() < b.place.x(); });
  for (const Triangle& t : surface.faces) {
    if (t[0] < 0) continue;
    const Vec3 &a = surface.points[idx(t[0])], &b = surface.points[idx(t[1])], &c = surface.points[idx(t[2])];
    const double high = std::max({a.x(), b.x(), c.x()});
    auto q = std::lower_bound(queries.begin(), queries.end(), std::min({a.x(), b.x(), c.x()}), before);
    for (; q != queries.end() && q->place.x() <= high; ++q) {
      const double y = q->place.y();
      if ((a.y() < y && b.y() < y && c.y() < y) || (a.y() > y && b.y() > y && c.y() > y)) continue;
      if (surface.parts.ofVertex[idx(t[0])] != q->without) q->winding += crossing(a, b, c, q->place);
    }
  }
}

//! Of the components that `wanted` holds, those that are misplaced, ascending.
std::vector<int> misplacedOf(const LabelledSurface& surface, const std::vector<unsigned char>& wanted) {
  const Components& parts = surface.parts;
  std::vector<Query> queries;
  std::vector<int> seen(idx(parts.count()), 0);
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const int c = parts.ofVertex[v];
    if (c < 0 || wanted[idx(c)] == 0) continue;
    const int stride = std::max(1, parts.vertices[idx(c)] / kNestingSamples);
    if (seen[idx(c)]++ % stride == 0) queries.push_back({surface.points[v], c, 0});
  }
  if (parts.count() > 1) wind(surface, queries);  // there is nothing to wind around a single one
  std::vector<unsigned char> fits(idx(parts.count()), 0);
  for (const Query& q : queries)
    if (q.winding == (parts.volume[idx(q.without)] < 0 ? 1 : 0)) fits[idx(q.without)] = 1;
  std::vector<int> out;
  for (int c = 0; c < parts.count(); ++c)
    if (wanted[idx(c)] != 0 && fits[idx(c)] == 0) out.push_back(c);
  return out;
}

}  // namespace

int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p) {
  std::vector<Query> one{{p, component, 0}};
  wind(labelled(mesh, parts), one);
  return one[0].winding;
}

bool isMisplaced(const Mesh& mesh, const Components& parts, int component) {
  std::vector<unsigned char> wanted(idx(parts.count()), 0);
  wanted[idx(component)] = 1;
  return !misplacedOf(labelled(mesh, parts), wanted).empty();
}

std::vector<int> misplacedComponents(const LabelledSurface& surface) {
  return misplacedOf(surface, std::vector<unsigned char>(idx(surface.parts.count()), 1));
}

}  // namespace handlebody
