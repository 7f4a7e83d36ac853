#include "sample_volumes/labyrinths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sample_volumes/curves.h"
#include "sample_volumes/distances.h"

namespace handlebody::phantoms {

namespace {

//! All points within `radius` of the segment ab.
double rodDistance(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
  const Vec3 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm() - radius;
}

}  // namespace

// Each ring runs through the middle of the other; the bridge leads from there to the rim.
double ringsDistance(const Vec3& p) {
  constexpr double kRing = 24, kTube = 6, kBridge = 5;
  const Vec3 middle(kRing / 2, 0, 0);
  const double rings = std::min(torusDistance(p + middle, Vec3::UnitZ(), kRing, kTube),
                                torusDistance(p - middle, Vec3::UnitY(), kRing, kTube));
  return std::min(rings, rodDistance(p, middle, middle + kRing * Vec3::UnitZ(), kBridge));
}

namespace {
constexpr double kTrefoilScale = 13;  // mm
}

Vec3 trefoilPoint(double t) {
  return kTrefoilScale *
         Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
}

Vec3 trefoilDerivative(double t) {
  return kTrefoilScale *
         Vec3(std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t), -3 * std::cos(3 * t));
}

namespace {
Vec3 trefoilSecond(double t) {
  return kTrefoilScale *
         Vec3(-std::sin(t) - 8 * std::sin(2 * t), -std::cos(t) + 8 * std::cos(2 * t), 9 * std::sin(3 * t));
}
}  // namespace

double trefoilDistance(const Vec3& p) {
  static const CurveDistance distance({trefoilPoint, trefoilDerivative, trefoilSecond});
  return distance(p) - kTrefoilTube;
}

// A trunk that forks twice; two anastomoses join the branches, and a third the crowns. 13 nodes, 15 edges,
// one component: 15 - 13 + 1 = 3 loops.
double treeDistance(const Vec3& p) {
  constexpr double kTube = 3;
  static const std::array<Vec3, 13> nodes{{{0, 0, -42},
                                           {0, 0, -20},
                                           {-18, 4, -2},
                                           {18, -4, -2},
                                           {-30, 14, 18},
                                           {-10, -12, 20},
                                           {10, 12, 20},
                                           {30, -14, 18},
                                           {-36, 18, 40},
                                           {-14, -20, 42},
                                           {14, 20, 42},
                                           {36, -18, 40},
                                           {0, 0, 34}}};
  static const std::array<std::array<std::size_t, 2>, 15> edges{{{0, 1},
                                                                 {1, 2},
                                                                 {1, 3},
                                                                 {2, 4},
                                                                 {2, 5},
                                                                 {3, 6},
                                                                 {3, 7},
                                                                 {4, 8},
                                                                 {5, 9},
                                                                 {6, 10},
                                                                 {7, 11},
                                                                 {5, 12},
                                                                 {6, 12},
                                                                 {4, 6},
                                                                 {5, 7}}};
  double distance = 1e9;
  for (const auto& [a, b] : edges) distance = std::min(distance, rodDistance(p, nodes[a], nodes[b], kTube));
  return distance;
}

double ballsDistance(const Vec3& p) {
  // The larger the cavity, the further from the others.
  static const std::array<Vec3, kBallsCavities> centres{{{-8, 22, 24},
                                                         {20, 10, 26},
                                                         {30, -16, -4},
                                                         {-30, -10, 14},
                                                         {6, -30, 12},
                                                         {-16, 26, -12},
                                                         {22, 24, -8},
                                                         {-18, -22, -18},
                                                         {14, -6, -26}}};
  double distance = ballDistance(p, 45);
  for (int i = 0; i < kBallsCavities; ++i) distance = std::max(distance, 2.0 + i - (p - centres[i]).norm());
  return distance;
}

double plateDistance(const Vec3& p) { return boxDistance(p, Vec3(36, 28, 2), 2); }

double neckDistance(const Vec3& p) {
  const double balls = ballDistance(Vec3(std::abs(p.x()) - 24, p.y(), p.z()), 16);
  return std::min(balls, capsuleDistance(p, 24, 2.5));
}

namespace {

double gyroid(const Vec3& p, Vec3* gradient) {
  constexpr double kWave = 2 * std::numbers::pi / 40;  // per mm
  const Vec3 q = kWave * p;
  const Vec3 s = q.array().sin(), c = q.array().cos();
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, d = (a + 2) % 3;
    (*gradient)[a] = kWave * (c[a] * c[b] - s[d] * s[a]);
  }
  return s[0] * c[1] + s[1] * c[2] + s[2] * c[0];
}

}  // namespace

double gyroidDistance(const Vec3& p) {
  constexpr double kBand = 5;  // mm
  const double box = boxDistance(p, Vec3(44, 44, 44), 10);
  if (box > kBand) return box;
  return std::max(implicitDistance(gyroid, p, kBand), box);
}

}  // namespace handlebody::phantoms
