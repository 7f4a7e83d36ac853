#include "core/collision/star_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

//! A star of k faces around vertex 0: edges of 0.7 to 1.3 at even angles, out of the plane by up to `rough`.
struct RandomStar {
  std::vector<Vec3> points{Vec3(0, 0, 0)};
  std::vector<Corner> corners;

  RandomStar(int k, double rough, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < k; ++i) {
      const double angle = 2 * M_PI * (i + 0.2 * unit(random)) / k, length = 1 + 0.3 * unit(random);
      points.emplace_back(length * std::cos(angle), length * std::sin(angle), rough * unit(random));
      corners.push_back({i, 1 + i, 1 + (i + 1) % k});
    }
  }
};

//! Squared radius of the smallest circle around a triangle: over two points, or else through all three.
double smallestEnclosingCircle(const Vec3& a, const Vec3& b, const Vec3& c) {
  double best = std::numeric_limits<double>::infinity();
  const Vec3* corners[] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const Vec3 &p = *corners[i], &q = *corners[(i + 1) % 3], &r = *corners[(i + 2) % 3];
    const double squared = (q - p).squaredNorm() / 4;
    if ((r - (p + q) / 2).squaredNorm() <= squared) best = std::min(best, squared);
  }
  if (std::isfinite(best)) return best;
  // The centre u = a + s(b-a) + t(c-a) is as far from all three: two linear equations.
  const Vec3 e = b - a, f = c - a;
  const double ee = e.squaredNorm(), ff = f.squaredNorm(), ef = e.dot(f), det = ee * ff - ef * ef;
  const double s = ff * (ee - ef) / (2 * det), t = ee * (ff - ef) / (2 * det);
  return (s * e + t * f).squaredNorm();
}

}  // namespace

TEST_CASE("a star's circle holds every face, and is hardly larger than the smallest that does") {
  std::mt19937 random(17);
  for (int round = 0; round < 2000; ++round) {
    const RandomStar star(3 + round % 8, round % 3 * 0.2, random);  // up to 7 faces in single precision
    double longestEdge = 0, enclosingCircle = 0;
    for (const Corner& c : star.corners) {
      const Vec3 &a = star.points[c.next], &b = star.points[c.prev];
      longestEdge = std::max({longestEdge, a.squaredNorm(), b.squaredNorm()});
      enclosingCircle = std::max(enclosingCircle, smallestEnclosingCircle(star.points[0], a, b));
    }
    StarSize tested;
    StarTest().isEmbedded(star.points, 0, star.corners, tested);
    for (const StarSize& size : {tested, measureStar(star.points, 0, star.corners)}) {
      INFO("round " << round);
      REQUIRE(size.longestEdge >= longestEdge * (1 - 1e-14));
      REQUIRE(size.longestEdge <= longestEdge * (1 + 0x1p-18));
      REQUIRE(size.enclosingCircle >= enclosingCircle * (1 - 1e-14));
      REQUIRE(size.enclosingCircle <= enclosingCircle * (1 + 0x1p-9));
    }
  }
}

TEST_CASE("the circle of a thin face is not too small") {
  for (double height : {1e-2, 1e-4, 1e-9, 0.0}) {
    const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, height, 0)};
    const std::vector<Corner> corners{{0, 1, 2}};
    const double enclosingCircle = measureStar(points, 0, corners).enclosingCircle;
    CHECK(enclosingCircle >= 0.25 * (1 + height * height) * (1 - 1e-14));
    CHECK(enclosingCircle <= 0.34);  // a third of the longest edge's square
  }
}
