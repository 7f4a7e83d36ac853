#include <Eigen/Geometry>

#include "tests/collision_oracle/oracle.h"
#include "tests/support/catch.h"
#include "tests/support/graded_mesh.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

std::size_t agreesWithCgal(const TriangleSoup& s) {
  const auto expected = oracle::selfIntersections(s);
  REQUIRE(findSelfIntersections(s.points, s.triangles) == expected);
  return expected.size();
}

TriangleSoup rotated(TriangleSoup s, double angle, const Vec3& axis) {
  const Eigen::Matrix3d r = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (Vec3& p : s.points) p = r * p;
  return s;
}

}  // namespace

TEST_CASE("clean meshes have no intersections, as CGAL says") {
  CHECK(agreesWithCgal(zoo::sphere(12)) == 0);
  CHECK(agreesWithCgal(zoo::torus(60, 20, 2, 0.7)) == 0);
  CHECK(agreesWithCgal(zoo::cube(6)) == 0);
  CHECK(agreesWithCgal(zoo::bumpySphere(16, 0.3)) == 0);
  CHECK(agreesWithCgal(zoo::rose(9, 1)) == 0);
}

TEST_CASE("overlapping bumpy spheres give CGAL's pairs at every scale and rotation") {
  const TriangleSoup s = zoo::overlappingSpheres(14);
  const std::size_t n = agreesWithCgal(s);
  CHECK(n > 50);
  for (const double scale : {0.0009765625, 1024.0}) CHECK(agreesWithCgal(zoo::scaled(s, scale)) == n);
  for (const double scale : {1e-3, 1e3, 1e-30, 1e30}) agreesWithCgal(zoo::scaled(s, scale));
  for (int i = 1; i < 5; ++i) agreesWithCgal(rotated(s, 0.7 * i, Vec3(i, 1, -2)));
  agreesWithCgal(zoo::moved(s, Vec3(1000, -3000, 500)));
}

TEST_CASE("noise of any strength gives CGAL's pairs, folded stars and edges included") {
  std::size_t all = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    for (const double amount : {0.01, 0.03, 0.06, 0.15, 0.5, 2.0}) {
      all += agreesWithCgal(zoo::perturbed(zoo::sphere(8), amount, seed));
      all += agreesWithCgal(zoo::perturbed(zoo::torus(24, 12, 2, 0.7), amount, seed));
      all += agreesWithCgal(zoo::perturbed(zoo::cube(5), amount, seed));
    }
  }
  CHECK(all > 10000);
}

TEST_CASE("folded roses, whose normals lie in a cone, are found") {
  for (int k = 5; k <= 15; ++k) {
    for (int turns = 2; 2 * turns < k; ++turns) {
      if (k % turns != 0) CHECK(agreesWithCgal(zoo::rose(k, turns)) > 0);
    }
  }
}

TEST_CASE("stars of all kinds agree with CGAL") {
  std::mt19937 random(11);
  const auto unit = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1; };
  for (int i = 0; i < 4000; ++i) {
    TriangleSoup s = zoo::rose(3 + static_cast<int>(random() % 7), 1);
    const double noise = std::abs(unit());
    for (Vec3& p : s.points) p += noise * Vec3(unit(), unit(), unit());
    agreesWithCgal(s);
  }
}

TEST_CASE("graded meshes, whose edges differ up to twelvefold, give CGAL's pairs") {
  std::size_t all = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const double noise : {0.0, 0.004, 0.02}) {
      TriangleSoup s = zoo::graded(zoo::sphere(10 + static_cast<int>(seed)));
      const TriangleSoup other = rotated(zoo::graded(zoo::sphere(12)), 0.4 * seed, Vec3(1, -2, seed));
      const int shift = static_cast<int>(s.points.size());
      for (const Vec3& p : other.points) s.points.push_back(p + Vec3(0.3, 0.1 * seed, 0.2));
      for (Triangle t : other.triangles) {
        for (int& v : t) v += shift;
        s.triangles.push_back(t);
      }
      all += agreesWithCgal(zoo::perturbed(s, noise, seed));
    }
  CHECK(all > 3000);
}

TEST_CASE("meshes with very uneven edges take another way to the same answer") {
  agreesWithCgal(zoo::spikySphere(20));
  TriangleSoup s = zoo::overlappingSpheres(12);
  s.points[5] *= 200;  // one long spike
  agreesWithCgal(s);
}

TEST_CASE("spheres that touch, coincide or nest agree with CGAL") {
  const TriangleSoup c = zoo::cube(4);
  for (const Vec3& by : {Vec3(1, 0, 0), Vec3(0.5, 0, 0), Vec3(0.25, 0.25, 0.25), Vec3(0, 0, 0), Vec3(1, 1, 1),
                         Vec3(0.5, 0.5, 1), Vec3(0.3, 0.2, 0.1)}) {
    CHECK(agreesWithCgal(zoo::both(c, zoo::moved(c, by))) > 0);
  }
  CHECK(agreesWithCgal(zoo::both(zoo::sphere(6), zoo::scaled(zoo::sphere(6), 0.5))) == 0);
}

TEST_CASE("soups of lattice triangles, degenerate and duplicate ones too, agree with the definition") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    for (const int size : {3, 5, 9}) {
      const TriangleSoup s = zoo::latticeSoup(40, 60, size, seed);
      CHECK(findSelfIntersections(s.points, s.triangles) == oracle::selfIntersectionsByDefinition(s));
    }
  }
}

TEST_CASE("small triangles of a soup scattered in space agree with the definition") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    const auto c = [&](unsigned n) { return static_cast<double>(random() % n); };
    TriangleSoup s;
    for (int t = 0; t < 200; ++t) {
      const double x = c(9), y = c(9), z = c(9);
      for (int i = 0; i < 3; ++i) {
        const double dx = c(3), dy = c(3), dz = c(3);
        s.points.emplace_back(x + dx, y + dy, z + dz);
      }
      s.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const auto expected = oracle::selfIntersectionsByDefinition(s);
    CHECK(expected.size() > 100);
    CHECK(findSelfIntersections(s.points, s.triangles) == expected);
  }
}
