// Theorem 4 of the paper and the sharper bound that the detection relies on (see self_intersection.cpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/geometry/triangle_intersection.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

using Pair = std::array<Vec3, 6>;

bool intersect(const Pair& p) { return trianglesIntersect(p[0], p[1], p[2], p[3], p[4], p[5]); }

//! Distance of the nearest vertices over the longest edge of both triangles; 0 if they do not intersect.
double badness(const Pair& p) {
  if (!intersect(p)) return 0;
  double longest = 0;
  double nearest = 1e300;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max({longest, (p[i] - p[(i + 1) % 3]).norm(), (p[3 + i] - p[3 + (i + 1) % 3]).norm()});
    for (std::size_t j = 3; j < 6; ++j) nearest = std::min(nearest, (p[i] - p[j]).norm());
  }
  return nearest / longest;
}

}  // namespace

TEST_CASE(
    "intersecting triangles have vertices nearer than sqrt(7/12) of the longest edge, and that is sharp") {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  double worst = 0;
  for (int start = 0; start < 30; ++start) {
    Pair best;
    double value = 0;
    double step = 1;
    for (Vec3& v : best) v = Vec3(normal(random), normal(random), normal(random));
    for (int i = 0; i < 6000; ++i) {  // climb towards the worst pair
      Pair next = best;
      for (Vec3& v : next) v += step * Vec3(normal(random), normal(random), normal(random));
      const double b = badness(next);
      REQUIRE(b <= std::sqrt(7.0 / 12.0) * (1 + 1e-12));
      if (b > value) {
        value = b;
        best = next;
      } else {
        step = std::max(1e-4, step * 0.998);
      }
    }
    worst = std::max(worst, value);
  }
  CHECK(std::sqrt(7.0 / 12.0) < std::sqrt(2.0 / 3.0));
  CHECK(worst > 0.75);
}

TEST_CASE("triangles of very different sizes have vertices as near as the edge of one and the other allow") {
  std::mt19937 random(21);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> octaves(-4, 0);
  int met = 0;
  for (int i = 0; i < 200000; ++i) {
    // A large triangle about the origin, and a smaller one near a point of it.
    Pair p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = Vec3(normal(random), normal(random), normal(random));
    const double size = std::exp2(octaves(random)), a = std::abs(normal(random)),
                 b = std::abs(normal(random)), c = std::abs(normal(random));
    const Vec3 at = (a * p[0] + b * p[1] + c * p[2]) / (a + b + c);
    for (std::size_t k = 3; k < 6; ++k)
      p[k] = at + size * Vec3(normal(random), normal(random), normal(random));
    if (!intersect(p)) continue;
    ++met;
    // Some vertex of one and some of the other: |PT|² <= (longest edge at P)²/4 + (longest edge of T)²/3.
    const auto longest = [&](std::size_t first) {
      double s = 0;
      for (std::size_t k = 0; k < 3; ++k)
        s = std::max(s, (p[first + k] - p[first + (k + 1) % 3]).squaredNorm());
      return s;
    };
    const auto atVertex = [&](std::size_t first, std::size_t k) {
      return std::max((p[first + k] - p[first + (k + 1) % 3]).squaredNorm(),
                      (p[first + k] - p[first + (k + 2) % 3]).squaredNorm());
    };
    double best = 1e300;  // of |PT|² less what is allowed
    for (const std::size_t first : {0u, 3u})
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j)
          best = std::min(best, (p[first + k] - p[3 - first + j]).squaredNorm() - atVertex(first, k) / 4 -
                                    longest(3 - first) / 3);
    REQUIRE(best <= 1e-9);
  }
  CHECK(met > 20000);
}
