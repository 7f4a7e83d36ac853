#include "core/mesh/nesting.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "core/geometry/predicates.h"

namespace handlebody {

namespace {

//! A place, and the component that does not count there.
struct Query {
  Vec3 place;
  int without = -1;
  int winding = 0;
  std::size_t number = 0;
};

//! How often the triangle winds around p in the projection along x: 1 or -1 if it covers p, else 0. An edge
//! holds its lower end and what lies beside it counts for one of its two triangles, so that a closed surface
//! covers every p without gaps or doubles (the half-open rule of crossing numbers, exact by orient2d).
int coverage(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  int covers = 0;
  const auto cross = [&](const Vec3& from, const Vec3& to) {
    if (from.z() <= p.z() && p.z() < to.z()) covers += orient2d(from, to, p, 0) > 0;
    if (to.z() <= p.z() && p.z() < from.z()) covers -= orient2d(from, to, p, 0) < 0;
  };
  cross(a, b);
  cross(b, c);
  cross(c, a);
  return covers;
}

//! False only if the ray from p along x cannot meet the triangle. Its range of z is left to coverage.
bool mayMeetRay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto below = [](double u, double v, double w, double limit) {
    return (u < limit) & (v < limit) & (w < limit);
  };
  return !(below(a.x(), b.x(), c.x(), p.x()) | below(a.y(), b.y(), c.y(), p.y()) |
           below(-a.y(), -b.y(), -c.y(), -p.y()));
}

}  // namespace

int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  if (!mayMeetRay(a, b, c, p)) return 0;
  const int covers = coverage(a, b, c, p);
  return covers != 0 && orient3d(a, b, c, p) == -covers ? covers : 0;  // it lies ahead
}

namespace {

//! The winding numbers of all queries, in one look at every face. Sorts them by z.
void wind(const LabelledSurface& surface, std::vector<Query>& queries) {
  const auto before = [](const Query& q, double z) { return q.place.z() < z; };
  std::sort(queries.begin(), queries.end(),
            [](const Query& a, const Query& b) { return a.place.z() < b.place.z(); });
  for (const Triangle& t : surface.faces) {
    if (t[0] < 0) continue;
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const double high = std::max({a.z(), b.z(), c.z()});
    auto q = std::lower_bound(queries.begin(), queries.end(), std::min({a.z(), b.z(), c.z()}), before);
    for (; q != queries.end() && q->place.z() <= high; ++q)
      if (surface.parts.ofVertex[t[0]] != q->without) q->winding += crossing(a, b, c, q->place);
  }
}

//! Of the components in `wanted` those of whose samples none fits, ascending.
std::vector<int> unfitOf(const LabelledSurface& surface, const std::vector<int>& wanted, int samples) {
  const Components& parts = surface.parts;
  std::vector<int> seen(parts.count(), -1);  // vertices of those that are wanted
  for (const int c : wanted) seen[c] = 0;
  std::vector<Query> queries;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const int c = parts.ofVertex[v];
    if (c < 0 || seen[c] < 0) continue;
    const int stride = std::max(1, parts.vertices[c] / samples);
    if (seen[c]++ % stride == 0) queries.push_back({surface.points[v], c, 0});
  }
  if (parts.count() > 1) wind(surface, queries);  // there is nothing to wind around a single one
  std::vector<unsigned char> fits(parts.count(), 0);
  for (const Query& q : queries)
    if (q.winding == (parts.volume[q.without] < 0 ? 1 : 0)) fits[q.without] = 1;
  std::vector<int> out;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(out), [&](int c) { return !fits[c]; });
  return out;
}

//! One vertex settles nearly all.
std::vector<int> misplacedOf(const LabelledSurface& surface, const std::vector<int>& wanted) {
  const std::vector<int> suspects = unfitOf(surface, wanted, 1);
  return suspects.empty() ? suspects : unfitOf(surface, suspects, kNestingSamples);
}

}  // namespace

int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p) {
  std::vector<Query> one{{p, component, 0}};
  wind(labelled(mesh, parts), one);
  return one[0].winding;
}

std::vector<int> windingNumbers(const Mesh& mesh, const Components& parts, std::span<const Vec3> places) {
  std::vector<Query> queries;
  for (const Vec3& place : places) queries.push_back({place, -1, 0, queries.size()});
  wind(labelled(mesh, parts), queries);
  std::vector<int> out(places.size());
  for (const Query& q : queries) out[q.number] = q.winding;
  return out;
}

bool isMisplaced(const Mesh& mesh, const Components& parts, int component) {
  return !misplacedOf(labelled(mesh, parts), {component}).empty();
}

std::vector<int> misplacedComponents(const LabelledSurface& surface) {
  std::vector<int> all(surface.parts.count());
  std::iota(all.begin(), all.end(), 0);
  return misplacedOf(surface, all);
}

}  // namespace handlebody
