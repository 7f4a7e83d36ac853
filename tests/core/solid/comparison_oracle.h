#pragma once
// The figures of `compare` by the definitions of docs/compare.md, written once more: every piece against
// every triangle, every point of the lattice against every solid angle. Nothing is taken from the code under
// test.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/solid/overlap.h"
#include "tests/support/catch.h"

namespace handlebody::testing {

using Corners = std::array<Vec3, 3>;

inline Corners cornersOf(const TriangleSoup& mesh, const Triangle& t) {
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

// --- distances ---

inline double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double along = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::clamp(along, 0.0, 1.0) * (b - a)).norm();
}

//! From the plane where p lies over the triangle, else from the nearest side. It has an area.
inline double distanceToTriangle(const Vec3& p, const Corners& c) {
  const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
  const auto isLeftOf = [&](const Vec3& a, const Vec3& b) { return (b - a).cross(p - a).dot(normal) >= 0; };
  if (isLeftOf(c[0], c[1]) && isLeftOf(c[1], c[2]) && isLeftOf(c[2], c[0]))
    return std::abs((p - c[0]).dot(normal));
  return std::min(
      {distanceToSegment(p, c[0], c[1]), distanceToSegment(p, c[1], c[2]), distanceToSegment(p, c[2], c[0])});
}

inline double distanceTo(const TriangleSoup& mesh, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    nearest = std::min(nearest, distanceToTriangle(p, cornersOf(mesh, t)));
  return nearest;
}

struct Piece {
  double distance, area;
};

inline void addPieces(const Vec3& a, const Vec3& b, const Vec3& c, double h, const TriangleSoup& to,
                      std::vector<Piece>& pieces) {
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  if (std::max({ab, bc, ca}) > h) {
    if (bc > ab && bc >= ca) return addPieces(b, c, a, h, to, pieces);
    if (ca > ab && ca > bc) return addPieces(c, a, b, h, to, pieces);
    addPieces(a, (a + b) / 2, c, h, to, pieces);
    addPieces((a + b) / 2, b, c, h, to, pieces);
    return;
  }
  pieces.push_back({distanceTo(to, (a + b + c) / 3), (b - a).cross(c - a).norm() / 2});
}

inline std::vector<Piece> piecesOf(const TriangleSoup& from, const TriangleSoup& to, double h) {
  std::vector<Piece> pieces;
  for (const Triangle& t : from.triangles) {
    const Corners c = cornersOf(from, t);
    addPieces(c[0], c[1], c[2], h, to, pieces);
  }
  return pieces;
}

inline double areaOf(const std::vector<Piece>& pieces) {
  double area = 0;
  for (const Piece& p : pieces) area += p.area;
  return area;
}

inline double meanOf(const std::vector<Piece>& pieces) {
  double moment = 0;
  for (const Piece& p : pieces) moment += p.distance * p.area;
  return moment / areaOf(pieces);
}

inline double percentileOf(std::vector<Piece> pieces, double share) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.distance < b.distance; });
  const double area = areaOf(pieces);
  double below = 0;
  for (const Piece& p : pieces)
    if ((below += p.area) >= share * area * (1 - 1e-12)) return p.distance;
  return pieces.back().distance;
}

//! Of pieces and vertices: the smallest and the largest.
inline std::array<double, 2> extremesOf(const std::vector<Piece>& pieces, const TriangleSoup& from,
                                        const TriangleSoup& to) {
  std::vector<double> all;
  for (const Piece& p : pieces) all.push_back(p.distance);
  for (const Vec3& p : from.points) all.push_back(distanceTo(to, p));
  const auto [smallest, largest] = std::minmax_element(all.begin(), all.end());
  return {*smallest, *largest};
}

// --- inside ---

//! Of a triangle as seen from p (van Oosterom and Strackee 1983); positive seen from within.
inline double solidAngle(const Corners& corners, const Vec3& p) {
  const Vec3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

//! How often a closed surface winds around p.
inline int timesAround(const TriangleSoup& mesh, const Vec3& p) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += solidAngle(cornersOf(mesh, t), p);
  const double times = sum / (4 * std::numbers::pi);
  if (std::abs(times - std::round(times)) > 1e-6) FAIL("the point lies on the surface: no answer is right");
  return static_cast<int>(std::round(times));
}

//! A label map by the voxel around a point, a mesh that does not overlap itself by how often it winds.
class Inside {
 public:
  explicit Inside(const Solid& solid) : solid_(solid) {
    for (const Vec3& p : solid.surface.points) box_.extend(p);
  }
  bool operator()(const Vec3& p) const {
    if (!solid_.mask) return box_.contains(p) && timesAround(solid_.surface, p) == 1;
    const Vec3 i = solid_.mask->grid.toIndex(p);
    return solid_.mask->holds(nearest(i.x()), nearest(i.y()), nearest(i.z()));
  }

 private:
  static int nearest(double index) { return static_cast<int>(std::lround(index)); }
  const Solid& solid_;
  Eigen::AlignedBox3d box_;
};

//! Calls f(point) for the lattice's points around both.
template <typename F>
void forPointsAround(const Solid& a, const Solid& b, const Grid& lattice, F&& f) {
  constexpr int kMore = 4;  // steps: a voxel of the other label map reaches beyond its surface
  Eigen::AlignedBox3d box;
  for (const Solid* solid : {&a, &b})
    for (const Vec3& p : solid->surface.points) box.extend(lattice.toIndex(p));
  const Eigen::Vector3i low = box.min().cast<int>().array() - kMore,
                        high = box.max().cast<int>().array() + kMore;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) f(lattice.toWorld(Vec3(x, y, z)));
}

inline Overlap overlapByForce(const Solid& a, const Solid& b, const Grid& lattice) {
  const Inside inA(a), inB(b);
  const double each = lattice.voxelVolume();
  Overlap o;
  forPointsAround(a, b, lattice, [&](const Vec3& p) {
    const bool isInA = inA(p), isInB = inB(p);
    o.a += isInA ? each : 0;
    o.b += isInB ? each : 0;
    o.both += isInA && isInB ? each : 0;
  });
  return o;
}

}  // namespace handlebody::testing
