#include "core/surgery/nesting.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace handlebody {

namespace {

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

//! False only if the ray from p along x cannot meet the triangle.
bool mayMeetRay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto below = [](double u, double v, double w, double limit) {
    return (u < limit) & (v < limit) & (w < limit);
  };
  return !(below(a.x(), b.x(), c.x(), p.x()) | below(a.y(), b.y(), c.y(), p.y()) |
           below(a.z(), b.z(), c.z(), p.z()) | below(-a.y(), -b.y(), -c.y(), -p.y()) |
           below(-a.z(), -b.z(), -c.z(), -p.z()));
}

}  // namespace

int crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  if (!mayMeetRay(a, b, c, p)) return 0;
  const int covers = coverage(a, b, c, p);
  return covers != 0 && orient3d(a, b, c, p) == -covers ? covers : 0;  // it lies ahead
}

int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p) {
  int crossings = 0;
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const int crossed = crossing(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), p);
    if (crossed != 0 && parts.ofVertex[static_cast<std::size_t>(t[0])] != component) crossings += crossed;
  }
  return crossings;
}

bool isMisplaced(const Mesh& mesh, const Components& parts, int component) {
  const auto c = static_cast<std::size_t>(component);
  const int proper = parts.volume[c] < 0 ? 1 : 0;
  const int stride = std::max(1, parts.vertices[c] / kNestingSamples);
  int seen = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (parts.ofVertex[static_cast<std::size_t>(v)] != component || seen++ % stride != 0) continue;
    if (windingNumber(mesh, parts, component, mesh.position(v)) == proper) return false;
  }
  return true;
}

}  // namespace handlebody
