#include "core/mesh/nesting.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

TriangleSoup turnedInsideOut(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

TriangleSoup ball(double radius, const Vec3& at) {
  return zoo::moved(zoo::scaled(zoo::sphere(4), radius), at);
}

std::vector<bool> misplaced(const TriangleSoup& soup) {
  const Mesh mesh(soup);
  const Components parts = findComponents(mesh);
  std::vector<bool> out;
  for (int c = 0; c < parts.count(); ++c) out.push_back(isMisplaced(mesh, parts, c));
  return out;
}

const TriangleSoup kBody = ball(10, Vec3(0, 0, 0));

}  // namespace

TEST_CASE("the winding number is 1 in the body and 0 outside of it and in its cavities") {
  const Mesh mesh(zoo::both(kBody, turnedInsideOut(ball(3, Vec3(4, 0, 0)))));
  const Components parts = findComponents(mesh);
  constexpr int kNone = -1;
  CHECK(windingNumber(mesh, parts, kNone, Vec3(-4, 1, 2)) == 1);
  CHECK(windingNumber(mesh, parts, kNone, Vec3(4, 0.5, 0.5)) == 0);
  CHECK(windingNumber(mesh, parts, kNone, Vec3(20, 1, 2)) == 0);
  CHECK(windingNumber(mesh, parts, 1, Vec3(4, 0.5, 0.5)) == 1);
}

TEST_CASE("bodies beside each other, cavities and bodies in cavities lie where they can") {
  CHECK(misplaced(kBody) == std::vector<bool>{false});
  CHECK(misplaced(zoo::both(kBody, ball(3, Vec3(14, 0, 0)))) == std::vector<bool>{false, false});
  const TriangleSoup hollow = zoo::both(kBody, turnedInsideOut(ball(6, Vec3(0, 0, 0))));
  CHECK(misplaced(hollow) == std::vector<bool>{false, false});
  CHECK(misplaced(zoo::both(hollow, ball(3, Vec3(0, 0, 0)))) == std::vector<bool>{false, false, false});
}

TEST_CASE("a solid part in a body, and a cavity outside of one, are misplaced, the body is not") {
  CHECK(misplaced(zoo::both(kBody, ball(3, Vec3(0, 0, 0)))) == std::vector<bool>{false, true});
  CHECK(misplaced(zoo::both(kBody, turnedInsideOut(ball(3, Vec3(14, 0, 0))))) ==
        std::vector<bool>{false, true});
}

TEST_CASE("bodies that overlap in part are not misplaced") {
  CHECK(misplaced(zoo::both(kBody, ball(3, Vec3(10, 0, 0)))) == std::vector<bool>{false, false});
}
