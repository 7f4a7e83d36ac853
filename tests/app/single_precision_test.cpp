#include "core/io/report/single_precision.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/collision/certify.h"
#include "core/io/report/result.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

constexpr double kUnit = 7.62939453125e-6;  // of single precision between 64 and 128

bool isSingle(const TriangleSoup& mesh) {
  for (const Vec3& p : mesh.points)
    for (double x : p)
      if (static_cast<double>(static_cast<float>(x)) != x) return false;
  return true;
}

double farthestMove(const TriangleSoup& a, const TriangleSoup& b) {
  double farthest = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    farthest = std::max(farthest, (a.points[i] - b.points[i]).cwiseAbs().maxCoeff());
  return farthest;
}

TriangleSoup plainlyRounded(TriangleSoup mesh) {
  for (Vec3& p : mesh.points)
    for (double& x : p) {
      const volatile float single = static_cast<float>(x);
      x = single;
    }
  return mesh;
}

//! Two cubes of 10 mm whose faces lie face to face, `gap` mm apart. `turn` tilts both, so that no coordinate
//! is special.
TriangleSoup cubesApart(double gap, double turn) {
  TriangleSoup both = zoo::both(zoo::scaled(zoo::cube(4), 10),
                                zoo::moved(zoo::scaled(zoo::cube(5), 10), Vec3(10 + gap, 0.31, 0.17)));
  for (Vec3& p : both.points)
    p = Eigen::AngleAxisd(turn, Vec3(1, 2, -1).normalized()) * p + Vec3(80.1, 80.2, 80.3);
  return both;
}

//! A block of 10 mm whose top and bottom are dented until only `thickness` mm are left between them.
TriangleSoup dentedBlock(double thickness, double turn) {
  TriangleSoup s = zoo::scaled(zoo::cube(6), 10);
  for (Vec3& p : s.points) {
    const double rim = std::max(std::abs(p.x() - 5), std::abs(p.y() - 5));
    if (rim < 4 && (p.z() == 0 || p.z() == 10)) p.z() = 5 + (p.z() - 5) * thickness / 10;
    p = Eigen::AngleAxisd(turn, Vec3(1, 2, -1).normalized()) * p + Vec3(80.1, 80.2, 80.3);
  }
  return s;
}

//! Two cubes of 10 mm, each standing on an edge, one upside down above the other: their edges cross, `gap` mm
//! apart, far from all corners.
TriangleSoup crossedEdges(double gap, double turn) {
  TriangleSoup lower = zoo::scaled(zoo::cube(2), 10), upper = lower;
  const double quarter = std::acos(0.0) / 2, half = 5 * std::sqrt(2.0);
  for (Vec3& p : lower.points)
    p = Eigen::AngleAxisd(quarter, Vec3::UnitX()) * (p - Vec3::Constant(5)) - Vec3(0, 0, half);
  for (Vec3& p : upper.points)
    p = Eigen::AngleAxisd(quarter, Vec3::UnitY()) * (p - Vec3::Constant(5)) + Vec3(1.9, 2.3, half + gap);
  TriangleSoup both = zoo::both(lower, upper);
  for (Vec3& p : both.points)
    p = Eigen::AngleAxisd(turn, Vec3(1, 2, -1).normalized()) * p + Vec3(80.1, 80.2, 80.3);
  return both;
}

}  // namespace

TEST_CASE("a mesh whose rounding keeps it apart is rounded to the nearest, and nothing else") {
  const TriangleSoup sphere = zoo::moved(zoo::sphere(6), Vec3(0.1, 0.2, 70.3));
  CHECK(roundedToSingle(sphere).points == plainlyRounded(sphere).points);
  CHECK(roundedToSingle(sphere).triangles == sphere.triangles);
}

TEST_CASE("sheets that rounding makes touch are moved apart by a few units in the last place") {
  int touched = 0;
  for (double gap : {0.02 * kUnit, 0.1 * kUnit, 0.5 * kUnit})
    for (double turn : {0.0, 0.3, 1.1}) {
      CAPTURE(gap, turn);
      const TriangleSoup mesh = cubesApart(gap, turn);
      if (!certify(mesh).passes()) continue;  // turning them in double precision has made them touch
      touched += !certify(plainlyRounded(mesh)).passes();
      const TriangleSoup rounded = roundedToSingle(mesh);
      CHECK(isSingle(rounded));
      CHECK(certify(rounded).passes());
      CHECK(farthestMove(mesh, rounded) <= (kMaxNudge + 1) * kUnit);
      CHECK(certifiedForExport(mesh).certificate.passes());
    }
  CHECK(touched > 3);  // the test would be empty if rounding did no harm
}

TEST_CASE("edges that cross so close that rounding makes them touch are moved apart") {
  int touched = 0;
  for (const double gap : {0.02, 0.1, 0.4})
    for (int i = 0; i < 20; ++i) {
      const double turn = 0.1 + 0.15 * i;
      CAPTURE(gap, turn);
      const TriangleSoup mesh = crossedEdges(gap * kUnit, turn);
      REQUIRE(certify(mesh).passes());
      touched += !certify(plainlyRounded(mesh)).passes();
      const TriangleSoup rounded = roundedToSingle(mesh);
      CHECK(certify(rounded).passes());
      CHECK(farthestMove(mesh, rounded) <= (kMaxNudge + 1) * kUnit);
    }
  CHECK(touched > 10);
}

TEST_CASE("a part so thin that rounding makes its sides touch keeps them apart") {
  int touched = 0;
  for (double thickness : {0.05 * kUnit, 0.3 * kUnit})
    for (double turn : {0.3, 1.1}) {
      CAPTURE(thickness, turn);
      const TriangleSoup mesh = dentedBlock(thickness, turn);
      if (!certify(mesh).passes()) continue;
      touched += !certify(plainlyRounded(mesh)).passes();
      const TriangleSoup rounded = roundedToSingle(mesh);
      CHECK(certify(rounded).passes());
      CHECK(farthestMove(mesh, rounded) <= (kMaxNudge + 1) * kUnit);
    }
  CHECK(touched > 0);
}

TEST_CASE("a mesh that truly intersects itself is not talked out of it") {
  const TriangleSoup mesh = zoo::overlappingSpheres(4);
  CHECK_FALSE(certify(roundedToSingle(mesh)).passes());
  CHECK_THROWS_AS(certifiedForExport(mesh), std::runtime_error);
}

TEST_CASE("rounding gives the same mesh every time") {
  const TriangleSoup mesh = cubesApart(0.1 * kUnit, 0.3);
  CHECK(roundedToSingle(mesh).points == roundedToSingle(mesh).points);
}
