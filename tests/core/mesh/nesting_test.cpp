#include "core/mesh/nesting.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

TriangleSoup turnedInsideOut(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

std::vector<bool> misplaced(const TriangleSoup& soup) {
  const Mesh mesh(soup);
  const Components parts = findComponents(mesh);
  std::vector<bool> out;
  for (int c = 0; c < parts.count(); ++c) out.push_back(isMisplaced(mesh, parts, c));
  return out;
}

//! van Oosterom and Strackee, 1983.
double solidAngleOfAll(const Mesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const Triangle& t : mesh.faces()) {
    const Vec3 a = mesh.position(t[0]) - p, b = mesh.position(t[1]) - p, c = mesh.position(t[2]) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum;
}

const TriangleSoup kBody = zoo::ball(10, Vec3(0, 0, 0));

}  // namespace

TEST_CASE("the winding number is 1 in the body and 0 outside of it and in its cavities") {
  const Mesh mesh(zoo::both(kBody, turnedInsideOut(zoo::ball(3, Vec3(4, 0, 0)))));
  const Components parts = findComponents(mesh);
  constexpr int kNone = -1;
  CHECK(windingNumber(mesh, parts, kNone, Vec3(-4, 1, 2)) == 1);
  CHECK(windingNumber(mesh, parts, kNone, Vec3(4, 0.5, 0.5)) == 0);
  CHECK(windingNumber(mesh, parts, kNone, Vec3(20, 1, 2)) == 0);
  CHECK(windingNumber(mesh, parts, 1, Vec3(4, 0.5, 0.5)) == 1);
}

TEST_CASE("winding numbers at many places come in the order of the places") {
  const Mesh mesh(zoo::both(kBody, turnedInsideOut(zoo::ball(3, Vec3(4, 0, 0)))));
  const Components parts = findComponents(mesh);
  const std::vector<Vec3> places{Vec3(-4, 1, 6), Vec3(4, 0.5, 0.5), Vec3(-4, 1, 2), Vec3(20, 1, 2),
                                 Vec3(-4, 1, -6)};
  CHECK(windingNumbers(mesh, parts, places) == std::vector{1, 0, 1, 0, 1});
  CHECK(windingNumbers(mesh, parts, {}).empty());
}

TEST_CASE("the winding number is that of the solid angle, also where the ray meets vertices and edges") {
  const Mesh mesh(
      zoo::both(zoo::both(kBody, turnedInsideOut(zoo::torus(24, 12, 5, 2))), zoo::ball(4, Vec3(20, 0, 0))));
  const Components parts = findComponents(mesh);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-12, 24);
  std::uniform_int_distribution<int> vertex(0, mesh.vertexSlots() - 1);
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 &level = mesh.position(vertex(random)), &other = mesh.position(vertex(random));
    const Vec3 p(place(random), i % 2 == 0 ? level.y() : place(random), i % 4 == 0 ? level.z() : other.z());
    const double angle = solidAngleOfAll(mesh, p) / (4 * std::numbers::pi);
    CAPTURE(p.transpose(), angle);
    if (std::abs(angle - std::round(angle)) > 1e-6) continue;  // on the surface
    CHECK(windingNumber(mesh, parts, -1, p) == std::lround(angle));
    inside += std::lround(angle) != 0;
  }
  CHECK(inside > 40);
}

TEST_CASE("bodies beside each other, cavities and bodies in cavities lie where they can") {
  CHECK(misplaced(kBody) == std::vector<bool>{false});
  CHECK(misplaced(zoo::both(kBody, zoo::ball(3, Vec3(14, 0, 0)))) == std::vector<bool>{false, false});
  const TriangleSoup hollow = zoo::both(kBody, turnedInsideOut(zoo::ball(6, Vec3(0, 0, 0))));
  CHECK(misplaced(hollow) == std::vector<bool>{false, false});
  CHECK(misplaced(zoo::both(hollow, zoo::ball(3, Vec3(0, 0, 0)))) == std::vector<bool>{false, false, false});
}

TEST_CASE("a solid part in a body, and a cavity outside of one, are misplaced, the body is not") {
  CHECK(misplaced(zoo::both(kBody, zoo::ball(3, Vec3(0, 0, 0)))) == std::vector<bool>{false, true});
  CHECK(misplaced(zoo::both(kBody, turnedInsideOut(zoo::ball(3, Vec3(14, 0, 0))))) ==
        std::vector<bool>{false, true});
}

TEST_CASE("bodies that overlap in part are not misplaced") {
  CHECK(misplaced(zoo::both(kBody, zoo::ball(3, Vec3(10, 0, 0)))) == std::vector<bool>{false, false});
}
