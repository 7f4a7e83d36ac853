#include "core/mesh/topology.h"

#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/validity.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

TriangleSoup insideOut(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

}  // namespace

TEST_CASE("components are labelled in the order of their lowest vertex") {
  const TriangleSoup a = zoo::sphere(2), b = zoo::moved(zoo::torus(9, 6, 2, 0.5), Vec3(9, 0, 0)),
                     c = zoo::moved(zoo::cube(2), Vec3(0, 9, 0));
  const Mesh mesh(zoo::both(zoo::both(a, b), c));
  const Components parts = findComponents(mesh);
  REQUIRE(parts.count() == 3);
  CHECK(parts.vertices == std::vector<int>{static_cast<int>(a.points.size()), 54, 26});
  CHECK(parts.faces == std::vector<int>{static_cast<int>(a.triangles.size()), 108, 48});
  CHECK(parts.ofVertex.front() == 0);
  CHECK(parts.ofVertex[a.points.size()] == 1);
  CHECK(parts.ofVertex.back() == 2);
}

TEST_CASE("the volume of a component is positive for a solid and negative for a cavity") {
  const Mesh mesh(
      zoo::both(zoo::cube(3), insideOut(zoo::moved(zoo::scaled(zoo::cube(2), 0.5), Vec3(0.25, 0.25, 0.25)))));
  const Components parts = findComponents(mesh);
  REQUIRE(parts.count() == 2);
  CHECK(parts.volume[0] == Approx(1));
  CHECK(parts.volume[1] == Approx(-0.125));
}

TEST_CASE("the volume of a component does not depend on where it lies") {
  const double expected = 2 * std::numbers::pi * std::numbers::pi * 3;  // 2π²Rr², r = 1
  const TriangleSoup torus = zoo::torus(120, 60, 3, 1);
  for (const Vec3& by : {Vec3(0, 0, 0), Vec3(100, -50, 20)})
    CHECK(findComponents(Mesh(zoo::moved(torus, by))).volume[0] == Approx(expected).epsilon(0.01));
}

TEST_CASE("the extent of a component is the longest side of its bounding box") {
  TriangleSoup box = zoo::cube(2);
  for (Vec3& p : box.points) p = p.cwiseProduct(Vec3(2, 7, 3));
  const Components parts = findComponents(Mesh(zoo::both(box, zoo::moved(zoo::cube(1), Vec3(50, 0, 0)))));
  CHECK(parts.extent == std::vector<double>{7, 1});
}

TEST_CASE("a deleted component leaves the others as they are, in their slots") {
  const TriangleSoup a = zoo::torus(12, 8, 2, 0.5), b = zoo::moved(zoo::sphere(3), Vec3(9, 0, 0));
  Mesh mesh(zoo::both(zoo::both(a, b), zoo::moved(zoo::cube(2), Vec3(0, 9, 0))));
  const Mesh before = mesh;
  const int inB = static_cast<int>(a.points.size()) + 5;
  deleteComponent(mesh, inB);
  expectValid(mesh);
  expectTopology(mesh, 2, 1);
  CHECK(mesh.vertexCount() == before.vertexCount() - static_cast<int>(b.points.size()));
  CHECK(findComponents(mesh).ofVertex[inB] == -1);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) REQUIRE(mesh.position(v) == before.position(v));
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) REQUIRE(mesh.face(f) == before.face(f));
}

TEST_CASE("the last component can be deleted, and leaves nothing") {
  Mesh mesh(zoo::sphere(2));
  deleteComponent(mesh, 0);
  CHECK(mesh.vertexCount() == 0);
  CHECK(mesh.faceCount() == 0);
  CHECK(findComponents(mesh).count() == 0);
}

TEST_CASE(
    "a body as thin as rounding, far from the origin, is told as a body, by step and certificate alike") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-600, 600), side(0.2, 1);
  for (int k = 0; k < 300; ++k) {
    const Vec3 at(place(random), place(random), place(random));
    const Vec3 u(side(random), 0, 0), v(0.3 * side(random), side(random), 0);
    Vec3 top = at + Vec3(0.2, 0.2, 0);  // doubles lie 1e-13 mm apart there
    for (int n = 0; n < 2; ++n) top.z() = std::nextafter(top.z(), 1e9);
    const TriangleSoup thin{{at, at + u, at + v, top}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    const TriangleSoup both = zoo::both(zoo::moved(zoo::cube(2), at + Vec3(5, 0, 0)), thin);
    const Mesh mesh(both);
    REQUIRE(findComponents(mesh).volume[1] > 0);
    REQUIRE(examine(mesh).cavities == 0);
    REQUIRE(examine(both).cavities == 0);
    REQUIRE(examine(both).misplaced == 0);
  }
}
