#include "core/geometry/predicates.h"

#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

__extension__ using Wide = __int128;

struct Lattice {
  long long x, y, z;
  Vec3 point() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
  Lattice operator-(const Lattice& o) const { return {x - o.x, y - o.y, z - o.z}; }
};

int sign(Wide x) { return (x > 0) - (x < 0); }

Wide cross(long long a, long long b, long long c, long long d) { return Wide(a) * d - Wide(b) * c; }

//! Exact as long as coordinates stay below 2^40.
int exactOrient3d(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& d) {
  const Lattice u = b - a, v = c - a, w = d - a;
  return sign(cross(u.y, u.z, v.y, v.z) * w.x + cross(u.z, u.x, v.z, v.x) * w.y +
              cross(u.x, u.y, v.x, v.y) * w.z);
}

int exactOrient2d(const Lattice& a, const Lattice& b, const Lattice& c) {
  const Lattice u = b - a, v = c - a;
  return sign(cross(u.x, u.y, v.x, v.y));
}

}  // namespace

TEST_CASE("orientation signs equal integer arithmetic, small and large coordinates") {
  std::mt19937_64 random(3);
  int flat = 0;
  for (const long long size : {2LL, 4LL, 1LL << 20, 1LL << 39}) {
    for (int i = 0; i < 5000; ++i) {
      const auto c = [&] { return static_cast<long long>(random() % static_cast<unsigned long long>(size)); };
      Lattice p[4];
      for (Lattice& q : p) q = {c(), c(), c()};
      if (i % 2 == 0) {  // one off the plane or in it, by the smallest step
        const long long s = c() % 3, t = c() % 3;
        p[3] = {p[0].x + s * (p[1].x - p[0].x) + t * (p[2].x - p[0].x),
                p[0].y + s * (p[1].y - p[0].y) + t * (p[2].y - p[0].y),
                p[0].z + s * (p[1].z - p[0].z) + t * (p[2].z - p[0].z) + c() % 2};
        if (size > (1LL << 30)) continue;  // the sum might leave the range of the oracle
      }
      const int expected = exactOrient3d(p[0], p[1], p[2], p[3]);
      flat += expected == 0;
      REQUIRE(orient3d(p[0].point(), p[1].point(), p[2].point(), p[3].point()) == expected);
      REQUIRE(detail::orient3dExact(p[0].point(), p[1].point(), p[2].point(), p[3].point()) == expected);
      REQUIRE(orient2d(p[0].point(), p[1].point(), p[2].point(), 2) == exactOrient2d(p[0], p[1], p[2]));
    }
  }
  CHECK(flat > 1000);
}

TEST_CASE("one unit in the last place decides") {
  const Vec3 a(0, 0, 0), b(1, 0, 1e-3), c(0, 1, 1e-3);
  const double z = 2e-3;
  const Vec3 on(1, 1, z);
  const Vec3 above(1, 1, std::nextafter(z, 1));
  const Vec3 below(1, 1, std::nextafter(z, 0));
  CHECK(orient3d(a, b, c, on) == 0);
  CHECK(orient3d(a, b, c, above) == 1);
  CHECK(orient3d(a, b, c, below) == -1);
}

TEST_CASE("a swap of two points changes the sign") {
  std::mt19937 random(4);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p[4];
    for (Vec3& q : p) {
      const double x = 0.1 * static_cast<double>(random() % 5), y = 0.1 * static_cast<double>(random() % 5),
                   z = 0.1 * static_cast<double>(random() % 5);
      q = Vec3(x, y, z);
    }
    const int s = orient3d(p[0], p[1], p[2], p[3]);
    REQUIRE(orient3d(p[1], p[0], p[2], p[3]) == -s);
    REQUIRE(orient3d(p[0], p[1], p[3], p[2]) == -s);
    REQUIRE(orient3d(p[1], p[2], p[0], p[3]) == s);
  }
}

TEST_CASE("signs hold at both ends of the stated domain") {
  for (const double unit : {1e-60, 1e60}) {
    const Vec3 a(0, 0, 0), b(unit, 0, 0), c(0, unit, 0);
    CHECK(orient3d(a, b, c, Vec3(unit, unit, unit)) == 1);
    CHECK(orient3d(a, b, c, Vec3(unit, unit, 0)) == 0);
    const double next = std::nextafter(unit, 1);
    CHECK(orient3d(Vec3(unit, unit, unit), Vec3(next, unit, unit), Vec3(unit, next, unit),
                   Vec3(unit, unit, next)) == (next > unit ? 1 : -1));
  }
}

TEST_CASE("collinear points are recognised exactly") {
  CHECK(collinear(Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(3, 6, 9)));
  CHECK(collinear(Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(2, 5, 3)));
  CHECK_FALSE(collinear(Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(3, 6, std::nextafter(9.0, 10.0))));
}
