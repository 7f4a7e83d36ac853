#include "core/mesh/quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/triangle_angles.h"

namespace handlebody {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

struct Side {
  int low, high;  // vertices
  int face;
};

Vec3 at(const TriangleSoup& mesh, int v) { return mesh.points[v]; }

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = [&](double part) {
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  return {values.front(), rank(0.05), rank(0.5), values.back()};
}

double angle(const Vec3& u, const Vec3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)) * kDegrees; }

//! 2r/R = 16·area² / (abc · (a+b+c)).
double radiusRatio(const Vec3& p, const Vec3& q, const Vec3& r) {
  const double a = (q - r).norm(), b = (r - p).norm(), c = (p - q).norm();
  const double twice = (q - p).cross(r - p).norm(), below = a * b * c * (a + b + c);
  return below > 0 ? 4 * twice * twice / below : 0;
}

std::vector<Side> sidesOf(const TriangleSoup& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = mesh.triangles[f][c], w = mesh.triangles[f][(c + 1) % 3];
      sides.push_back({std::min(v, w), std::max(v, w), static_cast<int>(f)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.face < b.face;
  });
  return sides;
}

//! Whichever way the faces are oriented.
double dihedral(const TriangleSoup& mesh, const Side& a, const Side& b) {
  const auto apex = [&](int face) {
    const Triangle& t = mesh.triangles[face];
    return at(mesh, t[0] + t[1] + t[2] - a.low - a.high);
  };
  return dihedralAngle(at(mesh, a.low), at(mesh, a.high), apex(a.face), apex(b.face));
}

void addEdges(const TriangleSoup& mesh, MeshQuality& quality) {
  const std::vector<Side> sides = sidesOf(mesh);
  std::vector<double> lengths, dihedrals;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    const Side& side = sides[first];
    while (end < sides.size() && sides[end].low == side.low && sides[end].high == side.high) ++end;
    lengths.push_back((at(mesh, side.high) - at(mesh, side.low)).norm());
    if (end - first == 2 && side.low != side.high)
      dihedrals.push_back(dihedral(mesh, side, sides[first + 1]));
  }
  quality.edges = spreadOf(std::move(lengths));
  quality.dihedral = spreadOf(std::move(dihedrals));
}

}  // namespace

MeshQuality meshQuality(const TriangleSoup& mesh) {
  MeshQuality quality;
  std::vector<double> angles, ratios;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = at(mesh, t[0]), b = at(mesh, t[1]), c = at(mesh, t[2]);
    angles.insert(angles.end(), {angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
    ratios.push_back(radiusRatio(a, b, c));
    if (!((b - a).cross(c - a).norm() > 0)) ++quality.flat;
  }
  quality.angles = spreadOf(std::move(angles));
  quality.radiusRatio = spreadOf(std::move(ratios));
  addEdges(mesh, quality);
  return quality;
}

}  // namespace handlebody
