#include "core/collision/closest_point.h"

#include <cmath>
#include <random>

#include "core/geometry/triangle_distance.h"
#include "core/mesh/nesting.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

double bruteDistance(const TriangleSoup& mesh, const Vec3& p) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mesh.points[t[i]]; };
    squared = std::min(squared, squaredDistance(p, at(0), at(1), at(2)));
  }
  return std::sqrt(squared);
}

std::vector<Vec3> somePoints(int n, double reach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

}  // namespace

TEST_CASE("the nearest distance is that of a search through all triangles", "[closest]") {
  for (const TriangleSoup& mesh : {zoo::bumpySphere(6, 0.3), zoo::torus(17, 9, 1, 0.4), zoo::cube(3),
                                   zoo::spikySphere(8), zoo::latticeSoup(40, 90, 4, 3)}) {
    const ClosestPoint tree(mesh);
    int hint = -1;
    for (const Vec3& p : somePoints(300, 3)) {
      CHECK(tree.distance(p) == Approx(bruteDistance(mesh, p)).epsilon(1e-12));
      CHECK(tree.distance(p, &hint) == Approx(bruteDistance(mesh, p)).epsilon(1e-12));
      const Triangle& t = mesh.triangles[hint];
      const auto at = [&](std::size_t i) { return mesh.points[t[i]]; };
      CHECK(std::sqrt(squaredDistance(p, at(0), at(1), at(2))) == Approx(tree.distance(p)).epsilon(1e-12));
    }
  }
}

TEST_CASE("the winding number is that of a look at all triangles", "[closest]") {
  for (const TriangleSoup& mesh :
       {zoo::bumpySphere(6, 0.3), zoo::torus(17, 9, 1, 0.4), zoo::overlappingSpheres(4), zoo::cube(3)}) {
    const ClosestPoint tree(mesh);
    int inside = 0;
    for (const Vec3& p : somePoints(500, 1.3)) {
      int winding = 0;
      for (const Triangle& t : mesh.triangles) {
        const auto at = [&](std::size_t i) { return mesh.points[t[i]]; };
        winding += crossing(at(0), at(1), at(2), p);
      }
      CHECK(tree.windingNumber(p) == winding);
      inside += winding > 0;
    }
    CHECK(inside > 20);
  }
}

TEST_CASE("nothing is near where there are no triangles", "[closest]") {
  const TriangleSoup none;
  const ClosestPoint tree(none);
  CHECK(std::isinf(tree.distance(Vec3(1, 2, 3))));
  CHECK(tree.windingNumber(Vec3(1, 2, 3)) == 0);
}
