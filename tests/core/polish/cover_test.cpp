#include "core/polish/cover.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "core/geometry/triangle_angles.h"
#include "core/geometry/triangle_distance.h"
#include "core/mesh/quality.h"
#include "core/polish/face_grid.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

Vec3 randomPoint(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> u(-size, size);
  const double x = u(random), y = u(random), z = u(random);
  return {x, y, z};
}

Corners randomTriangle(std::mt19937& random, double size) {
  const Vec3 at = randomPoint(random, 1);
  Corners c;
  for (Vec3& p : c) p = at + randomPoint(random, size);
  return c;
}

//! By brute force, at points that lie densely.
double farthestBruteForce(const Corners& t, const std::vector<Corners>& others) {
  constexpr int kSteps = 60;
  double farthest = 0;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
      const Vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
      double least = 1e300;
      for (const Corners& o : others) least = std::min(least, squaredDistance(p, o[0], o[1], o[2]));
      farthest = std::max(farthest, std::sqrt(least));
    }
  return farthest;
}

}  // namespace

TEST_CASE("a triangle is covered where all of it lies near to others, and where not it is not", "[polish]") {
  std::mt19937 random(5);
  int covered = 0, bare = 0;
  for (int i = 0; i < 400; ++i) {
    const Corners t = randomTriangle(random, 0.5);
    std::vector<Corners> others;
    for (int n = 0; n < 12; ++n) others.push_back(randomTriangle(random, 0.8));
    const double farthest = farthestBruteForce(t, others);
    // Between points that lie densely the distance changes by less than their spacing.
    if (isCovered(t, others, farthest)) CHECK(isCovered(t, others, 1.01 * farthest));
    CHECK(isCovered(t, others, 1.15 * farthest));
    CHECK_FALSE(isCovered(t, others, 0.99 * farthest));
    ++(isCovered(t, others, 0.5) ? covered : bare);
  }
  CHECK(covered > 20);
  CHECK(bare > 20);
}

TEST_CASE("what lies far from a place need not be covered there", "[polish]") {
  const Corners wide{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  const Corners here{Vec3(0, 0, 0.1), Vec3(1, 0, 0.1), Vec3(0, 1, 0.1)};
  const Corners cover{Vec3(-1, -1, -0.1), Vec3(4, -1, -0.1), Vec3(-1, 4, -0.1)};
  CHECK_FALSE(isCovered(wide, std::vector{cover}, 0.3));
  CHECK(isCovered(wide, std::vector{here}, std::vector{cover}, 0.3));
  const Corners far{Vec3(-1, -1, -0.4), Vec3(4, -1, -0.4), Vec3(-1, 4, -0.4)};
  CHECK_FALSE(isCovered(wide, std::vector{here}, std::vector{far}, 0.3));
  CHECK(isCovered(wide, std::vector{here}, std::vector{far}, 0.05));  // nothing of it lies there
}

TEST_CASE("no face near a box is missed, while faces come and go", "[polish]") {
  std::mt19937 random(7);
  FaceGrid grid;
  std::vector<Corners> faces;
  std::vector<bool> isThere;
  for (int i = 0; i < 300; ++i) {
    faces.push_back(randomTriangle(random, i % 7 == 0 ? 2.0 : i % 5 == 0 ? 1e-9 : 0.1));
    isThere.push_back(true);
    grid.add(i, boxAround(faces.back()));
  }
  for (int i = 0; i < 300; i += 3) {
    grid.remove(i, boxAround(faces[i]));
    isThere[i] = false;
  }
  std::vector<int> found;
  for (int q = 0; q < 100; ++q) {
    const Box box = boxAround(randomTriangle(random, q % 2 == 0 ? 0.05 : 1.5));
    grid.findNear(box, found);
    CHECK(std::is_sorted(found.begin(), found.end()));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const bool isFound = std::binary_search(found.begin(), found.end(), static_cast<int>(i));
      if (!isThere[i]) CHECK_FALSE(isFound);
      if (isThere[i] && boxAround(faces[i]).overlaps(box)) CHECK(isFound);
    }
  }
}

TEST_CASE("shapes are measured as check measures them", "[polish]") {
  for (const TriangleSoup& mesh : {zoo::torus(9, 7, 3, 1), zoo::spikySphere(4), zoo::cube(2)}) {
    const MeshQuality quality = meshQuality(mesh);
    double angle = 180, dihedral = 180;
    const Mesh structure(mesh);
    for (int f = 0; f < structure.faceSlots(); ++f) {
      const Triangle& t = structure.face(f);
      angle = std::min(
          angle, leastAngle(structure.position(t[0]), structure.position(t[1]), structure.position(t[2])));
      for (int h = 3 * f; h < 3 * f + 3; ++h)
        dihedral =
            std::min(dihedral, dihedralAngle(structure.position(structure.origin(h)),
                                             structure.position(structure.target(h)),
                                             structure.position(structure.apex(h)),
                                             structure.position(structure.apex(structure.opposite(h)))));
    }
    CHECK(angle == Approx(quality.angles.least));
    CHECK(dihedral == Approx(quality.dihedral.least));
  }
}
