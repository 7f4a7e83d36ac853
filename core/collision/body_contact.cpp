#include "core/collision/body_contact.h"

#include <algorithm>
#include <vector>

#include "core/collision/box_tree.h"
#include "core/geometry/triangle_intersection.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

const Vec3& corner(const TriangleSoup& mesh, std::size_t triangle, std::size_t i) {
  return mesh.points[mesh.triangles[triangle][i]];
}

void addBoxes(const TriangleSoup& mesh, std::vector<Box>& boxes) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 &a = corner(mesh, t, 0), &b = corner(mesh, t, 1), &c = corner(mesh, t, 2);
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
}

bool surfacesMeet(const TriangleSoup& a, const TriangleSoup& b) {
  std::vector<Box> boxes;
  addBoxes(a, boxes);
  addBoxes(b, boxes);
  BoxTree tree;
  tree.build(boxes);
  const std::size_t first = a.triangles.size();
  bool meet = false;
  tree.forEachOverlap([&](int i, int j) {
    const std::size_t s = idx(std::min(i, j)), u = idx(std::max(i, j));
    if (meet || s >= first || u < first) return;
    const std::size_t t = u - first;
    meet = trianglesIntersect(corner(a, s, 0), corner(a, s, 1), corner(a, s, 2), corner(b, t, 0),
                              corner(b, t, 1), corner(b, t, 2));
  });
  return meet;
}

//! True if a part of `a` lies in `b`, whose surfaces do not meet: then a vertex of it tells.
bool liesIn(const TriangleSoup& a, const TriangleSoup& b) {
  const Components parts = findComponents(Mesh(a));
  std::vector<unsigned char> asked(parts.count(), 0);
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    if (parts.ofVertex[v] < 0 || asked[parts.ofVertex[v]]++ != 0) continue;
    asked[parts.ofVertex[v]] = 1;
    int winding = 0;
    for (std::size_t t = 0; t < b.triangles.size(); ++t)
      winding += crossing(corner(b, t, 0), corner(b, t, 1), corner(b, t, 2), a.points[v]);
    if (winding > 0) return true;
  }
  return false;
}

}  // namespace

BodyContact bodyContact(const TriangleSoup& a, const TriangleSoup& b) {
  if (surfacesMeet(a, b)) return BodyContact::surfaces;
  return liesIn(a, b) || liesIn(b, a) ? BodyContact::inside : BodyContact::none;
}

}  // namespace handlebody
