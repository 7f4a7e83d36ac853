#include "core/io/single_precision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "core/collision/self_intersection.h"

namespace handlebody {

namespace {

constexpr int kDistances = 9;  // 1, 2, 4 … kMostNudge units; along the normals, and then at random

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
  const Triangle& t = mesh.triangles[static_cast<std::size_t>(face)];
  const Vec3 &a = mesh.points[static_cast<std::size_t>(t[0])],
             &b = mesh.points[static_cast<std::size_t>(t[1])],
             &c = mesh.points[static_cast<std::size_t>(t[2])];
  return {(a + b + c) / 3, (b - a).cross(c - a).stableNormalized()};
}

using Votes = std::map<int, Vec3>;

//! Where the vertices of the pairs should go: to the side of the plane, of the face that their own one meets,
//! on which they lie. Vertices that are not near that plane are not the cause.
void vote(const TriangleSoup& exact, const std::vector<FacePair>& pairs, Votes& votes) {
  for (const auto& [f, g] : pairs)
    for (const auto& [mine, other] : {std::pair(f, g), std::pair(g, f)}) {
      const Plane plane = planeOf(exact, other);
      for (int v : exact.triangles[static_cast<std::size_t>(mine)]) {
        const Vec3& p = exact.points[static_cast<std::size_t>(v)];
        const double side = (p - plane.centre).dot(plane.normal);
        if (std::abs(side) > kMostNudge * unitInLastPlace(p)) continue;
        votes.emplace(v, Vec3::Zero()).first->second += side < 0 ? Vec3(-plane.normal) : plane.normal;
      }
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
      const Vec3& p = mesh.points[static_cast<std::size_t>(v)];
      Vec3 d = away.stableNormalized();
      if (turn >= kDistances) d = (d + randomDirection(v, turn) / 4).stableNormalized();
      out.points[static_cast<std::size_t>(v)] = rounded(p + units * unitInLastPlace(p) * d);
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
