#include "core/surgery/nesting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handlebody {

double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

int windingNumber(const Mesh& mesh, const Components& parts, int component, const Vec3& p) {
  double angle = 0;
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    if (parts.ofVertex[static_cast<std::size_t>(t[0])] == component) continue;
    angle += solidAngle(mesh.position(t[0]) - p, mesh.position(t[1]) - p, mesh.position(t[2]) - p);
  }
  return static_cast<int>(std::lround(angle / (4 * std::numbers::pi)));
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
