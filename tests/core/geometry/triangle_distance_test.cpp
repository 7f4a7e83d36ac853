#include "core/geometry/triangle_distance.h"

#include <array>
#include <random>

#include "core/geometry/triangle_intersection.h"
#include "tests/support/catch.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

Vec3 randomPoint(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-2, 2);
  const double x = u(random), y = u(random);
  return {x, y, u(random)};
}

}  // namespace

TEST_CASE("the distance from a triangle is that of its nearest point") {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = randomPoint(random), b = randomPoint(random), c = randomPoint(random);
    const Vec3 p = randomPoint(random);
    CHECK(std::sqrt(squaredDistance(p, a, b, c)) == Approx(bruteDistance(p, a, b, c)).margin(1e-9));
  }
  const Vec3 a(0, 0, 0), b(2, 0, 0), p(1, 1, 0);
  CHECK(squaredDistance(p, a, b, b) == Approx(1));  // a segment
  CHECK(squaredDistance(p, a, a, a) == Approx(2));  // a point
}

TEST_CASE("a triangle meets a box where the nearest of its points in the box's norm does") {
  std::mt19937 random(2);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = randomPoint(random), b = randomPoint(random), c = randomPoint(random);
    const Vec3 half(0.3, 0.5, 0.2);
    // The least of max |p_i| / half_i over a fine sampling: 1 is where a box of that size begins.
    double least = 1e300;
    constexpr int kFine = 60;
    for (int u = 0; u <= kFine; ++u)
      for (int v = 0; u + v <= kFine; ++v) {
        const Vec3 p = a + double(u) / kFine * (b - a) + double(v) / kFine * (c - a);
        least = std::min(least, p.cwiseAbs().cwiseQuotient(half).maxCoeff());
      }
    const bool meets = meetsBox(a, b, c, half);
    met += meets;
    if (least <= 1) CHECK(meets);
    if (least > 1.6) CHECK_FALSE(meets);  // the sampling is coarse by 0.1 mm, half of the thinnest axis
  }
  CHECK(met > 100);
}

TEST_CASE("the distance of two triangles is that of the nearest of their points") {
  std::mt19937 random(3);
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    std::array<Vec3, 3> s, t;
    for (Vec3& p : s) p = randomPoint(random);
    for (Vec3& p : t) p = randomPoint(random);
    if (trianglesIntersect(s[0], s[1], s[2], t[0], t[1], t[2])) continue;
    double least = 1e300;
    constexpr int kFine = 40;
    for (int u = 0; u <= kFine; ++u)
      for (int v = 0; u + v <= kFine; ++v) {
        const Vec3 p = s[0] + double(u) / kFine * (s[1] - s[0]) + double(v) / kFine * (s[2] - s[0]);
        least = std::min(least, bruteDistance(p, t[0], t[1], t[2]));
      }
    const double distance = std::sqrt(squaredDistance(s, t));
    CHECK(distance <= least + 1e-9);
    CHECK(distance >= least - 6.0 / kFine);  // no point is further from a sample
    CHECK(squaredDistance(t, s) == Approx(squaredDistance(s, t)));
    ++apart;
  }
  CHECK(apart > 100);
  const std::array<Vec3, 3> edge{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, -3)};
  const std::array<Vec3, 3> across{Vec3(0, -1, 0.5), Vec3(0, 1, 0.5), Vec3(0, 0, 3)};
  CHECK(squaredDistance(edge, across) == Approx(0.25));  // of two edges
}
