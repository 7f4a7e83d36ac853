#include "core/polish/cover.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/cancellation.h"
#include "core/geometry/triangle_distance.h"

namespace handlebody {

namespace {

constexpr int kFarthestSteps = 8;
constexpr double kSmallest = 0.04;  // of the distance: pieces that are not halved any more
constexpr int kMaxPieces = 20000;   // of one triangle: what is far larger than the distance is not shown

double squaredTo(const Vec3& p, const Corners& t) { return squaredDistance(p, t[0], t[1], t[2]); }

double distanceTo(const Vec3& p, std::span<const Corners> others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& t : others) least = std::min(least, squaredTo(p, t));
  return std::sqrt(least);
}

struct Piece {
  Corners corners;
  Vec3 centre;
  double radius;  // of a ball around the centre that holds it

  explicit Piece(const Corners& c) : corners(c), centre((c[0] + c[1] + c[2]) / 3), radius(0) {
    for (const Vec3& p : c) radius = std::max(radius, (p - centre).norm());
  }
};

bool isCoveredByOne(const Piece& piece, std::span<const Corners> others, double squared) {
  return std::any_of(others.begin(), others.end(), [&](const Corners& t) {
    return std::all_of(piece.corners.begin(), piece.corners.end(),
                       [&](const Vec3& p) { return squaredTo(p, t) <= squared; });
  });
}

//! Along its longest edge.
std::array<Corners, 2> halves(const Corners& c) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double l = (c[(i + 1) % 3] - c[i]).squaredNorm(); l > most) {
      most = l;
      longest = i;
    }
  const Vec3 &a = c[longest], &b = c[(longest + 1) % 3], &apex = c[(longest + 2) % 3];
  const Vec3 middle = (a + b) / 2;
  return {Corners{a, middle, apex}, Corners{middle, b, apex}};
}

}  // namespace

bool isCovered(const Corners& triangle, std::span<const Corners> where, std::span<const Corners> others,
               double distance) {
  std::vector<Piece> left{Piece(triangle)};
  for (int pieces = 0; !left.empty(); ++pieces) {
    giveUpIfCancelled();
    if (pieces > kMaxPieces) return false;
    const Piece piece = left.back();
    left.pop_back();
    const double there = where.empty() ? 0 : distanceTo(piece.centre, where);
    if (there > distance + piece.radius) continue;
    const double away = distanceTo(piece.centre, others);
    if (away + piece.radius <= distance) continue;
    if (away > distance && there <= distance) return false;
    if (isCoveredByOne(piece, others, distance * distance)) continue;
    if (piece.radius < kSmallest * distance) return false;
    for (const Corners& half : halves(piece.corners)) left.emplace_back(half);
  }
  return true;
}

bool isCovered(const Corners& triangle, std::span<const Corners> others, double distance) {
  return isCovered(triangle, {}, others, distance);
}

double farthestFrom(const Corners& triangle, std::span<const Corners> others) {
  double farthest = 0;
  for (int i = 0; i <= kFarthestSteps; ++i)
    for (int j = 0; i + j <= kFarthestSteps; ++j) {
      const double u = static_cast<double>(i) / kFarthestSteps, v = static_cast<double>(j) / kFarthestSteps;
      const Vec3 p = (1 - u - v) * triangle[0] + u * triangle[1] + v * triangle[2];
      farthest = std::max(farthest, distanceTo(p, others));
    }
  return farthest;
}

}  // namespace handlebody
