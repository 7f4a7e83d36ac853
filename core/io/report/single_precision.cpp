#include "core/io/report/single_precision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/geometry/closest_points.h"

namespace handlebody {

namespace {

constexpr int kDistances = 9;  // 1, 2, 4 … kMaxNudge units; along the normals, and then at random

//! By way of a volatile: GCC 12 takes a vectorised conversion to float and back for nothing at all.
Vec3 rounded(const Vec3& p) {
  Vec3 out;
  for (int a = 0; a < 3; ++a) {
    const volatile float single = static_cast<float>(p[a]);
    out[a] = static_cast<double>(single);
  }
  return out;
}

//! Distance of two neighbouring floats at the largest coordinate of p.
double unitInLastPlace(const Vec3& p) {
  const float largest = static_cast<float>(p.cwiseAbs().maxCoeff());
  return static_cast<double>(std::nextafter(largest, std::numeric_limits<float>::infinity())) - largest;
}

struct Plane {
  Vec3 centre, normal;
};

Plane planeOf(const TriangleSoup& mesh, int face) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  return {(a + b + c) / 3, (b - a).cross(c - a).stableNormalized()};
}

using Votes = std::map<int, Vec3>;

void voteFor(int vertex, const Vec3& direction, Votes& votes) {
  votes.emplace(vertex, Vec3::Zero()).first->second += direction;
}

//! Where the vertices of a face should go: to the side of the plane, of the face that it meets, on which they
//! lie. Vertices that are not near that plane are not the cause. False if none is.
bool voteByPlane(const TriangleSoup& exact, int mine, int other, Votes& votes) {
  const Plane plane = planeOf(exact, other);
  bool any = false;
  for (int v : exact.triangles[mine]) {
    const Vec3& p = exact.points[v];
    const double side = (p - plane.centre).dot(plane.normal);
    if (std::abs(side) > kMaxNudge * unitInLastPlace(p)) continue;
    voteFor(v, side < 0 ? Vec3(-plane.normal) : plane.normal, votes);
    any = true;
  }
  return any;
}

//! Two edges that cross close by, with all corners far from the other face's plane: both faces go away from
//! each other along the shortest way between them.
void voteByWayBetween(const TriangleSoup& exact, int f, int g, Votes& votes) {
  const Triangle &s = exact.triangles[f], &t = exact.triangles[g];
  const auto corners = [&](const Triangle& face) {
    std::array<Vec3, 3> out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = exact.points[face[i]];
    return out;
  };
  const auto [p, q] = closestPoints(corners(s), corners(t));
  const Vec3 apart = (p - q).stableNormalized();
  for (const int v : s) voteFor(v, apart, votes);
  for (const int v : t) voteFor(v, -apart, votes);
}

void vote(const TriangleSoup& exact, const std::vector<FacePair>& pairs, Votes& votes) {
  for (const auto& [f, g] : pairs) {
    const bool mine = voteByPlane(exact, f, g, votes), other = voteByPlane(exact, g, f, votes);
    if (!mine && !other) voteByWayBetween(exact, f, g, votes);
  }
}

Vec3 randomDirection(int vertex, int turn) {
  std::mt19937 random(static_cast<unsigned>(vertex) * 31U + static_cast<unsigned>(turn));
  Vec3 d;
  for (double& x : d) x = static_cast<double>(random()) / 2147483648.0 - 1;
  return d;
}

}  // namespace

TriangleSoup roundedToSingle(const TriangleSoup& mesh) {
  TriangleSoup out = mesh;
  for (Vec3& p : out.points) p = rounded(p);
  Votes votes;  // of all turns, so that whole sheets move and not single vertices
  for (int turn = 0; turn < 2 * kDistances; ++turn) {
    const std::vector<FacePair> pairs = findSelfIntersections(out.points, out.triangles);
    if (pairs.empty()) break;
    vote(mesh, pairs, votes);
    const double units = std::exp2(turn % kDistances);
    for (const auto& [v, away] : votes) {
      const Vec3& p = mesh.points[v];
      Vec3 d = away.stableNormalized();
      if (turn >= kDistances) d = (d + randomDirection(v, turn) / 4).stableNormalized();
      out.points[v] = rounded(p + units * unitInLastPlace(p) * d);
    }
  }
  return out;
}

ReadInSingle readInSingle(const TriangleSoup& mesh) {
  ReadInSingle read{mesh};
  for (Vec3& p : read.mesh.points) {
    const Vec3 exact = p;
    p = rounded(exact);
    read.farthest = std::max(read.farthest, (p - exact).norm());
  }
  return read;
}

}  // namespace handlebody
