#include "core/geometry/triangle_intersection.h"

#include <algorithm>
#include <array>
#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

using Points = std::array<Vec3, 3>;

bool intersect(const Points& a, const Points& b) {
  return trianglesIntersect(a[0], a[1], a[2], b[0], b[1], b[2]);
}

const Points kBase{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

}  // namespace

TEST_CASE("a triangle that pierces, touches or misses another") {
  CHECK(intersect(kBase, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 2, 3)}));
  CHECK(intersect(kBase, {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(2, 2, 3)}));   // corner inside
  CHECK(intersect(kBase, {Vec3(2, 2, 0), Vec3(3, 3, 1), Vec3(3, 3, -1)}));  // corner on an edge
  CHECK(intersect(kBase, {Vec3(4, 0, 0), Vec3(5, 0, 1), Vec3(5, 1, 1)}));   // corner on a corner
  CHECK(intersect(kBase, {Vec3(2, -1, 1), Vec3(2, 1, -1), Vec3(2, -5, -5)}));
  CHECK_FALSE(intersect(kBase, {Vec3(1, 1, 1e-60), Vec3(1, 1, 1), Vec3(2, 2, 3)}));
  CHECK_FALSE(intersect(kBase, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(5, 5, 0)}));
}

TEST_CASE("coplanar triangles") {
  CHECK(intersect(kBase, {Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(2, 1, 0)}));        // inside
  CHECK(intersect({Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(2, 1, 0)}, kBase));        // around
  CHECK(intersect(kBase, {Vec3(-1, 1, 0), Vec3(9, 1, 0), Vec3(9, 2, 0)}));       // across
  CHECK(intersect(kBase, {Vec3(4, 0, 0), Vec3(8, 0, 0), Vec3(8, 1, 0)}));        // corner to corner
  CHECK(intersect(kBase, {Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(2, -1, 0)}));       // edge on edge
  CHECK_FALSE(intersect(kBase, {Vec3(3, 3, 0), Vec3(4, 3, 0), Vec3(3, 4, 0)}));  // beside
}

TEST_CASE("degenerate triangles are segments and points") {
  const Points segment{Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 1, 1)};
  const Points point{Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)};
  const Points far{Vec3(5, 5, 0), Vec3(5, 5, 0), Vec3(5, 5, 1)};
  CHECK(intersect(kBase, segment));
  CHECK(intersect(segment, kBase));
  CHECK(intersect(kBase, point));
  CHECK(intersect(point, segment));
  CHECK(intersect(point, point));
  CHECK_FALSE(intersect(kBase, far));
  CHECK_FALSE(intersect(far, segment));
  CHECK_FALSE(intersect(far, point));
  CHECK(intersect(segment, {Vec3(0, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 0)}));
  CHECK_FALSE(intersect(segment, {Vec3(1, 1, 2), Vec3(1, 1, 3), Vec3(1, 1, 4)}));  // on one line, apart
}

TEST_CASE("triangles with a common vertex intersect only beyond it") {
  const Vec3 s(0, 0, 0);
  const auto test = [&](const Vec3& a, const Vec3& b) {
    return trianglesIntersectSharedVertex(s, Vec3(4, 0, 0), Vec3(0, 4, 0), a, b);
  };
  CHECK(test(Vec3(1, 1, -1), Vec3(1, 1, 1)));
  CHECK(test(Vec3(1, 1, 0), Vec3(0, 0, 1)));             // an edge runs into the other triangle
  CHECK(test(Vec3(9, 0, 0), Vec3(0, 0, 1)));             // two edges run along each other
  CHECK(test(Vec3(1, 2, 0), Vec3(-3, -1, 0)));           // coplanar, overlapping
  CHECK_FALSE(test(Vec3(-1, -1, -1), Vec3(-1, -1, 1)));  // crosses the plane on the other side
  CHECK_FALSE(test(Vec3(-1, 0, 0), Vec3(0, -1, 0)));     // coplanar, opposite
  CHECK_FALSE(test(Vec3(1, 1, 1), Vec3(2, 2, 1)));
  CHECK_FALSE(test(Vec3(-1, -1, 0), Vec3(-2, -2, 0)));  // a segment away from the triangle
  CHECK(test(Vec3(-1, -1, 0), Vec3(1, 1, 0)));          // a segment through the vertex
}

TEST_CASE("triangles with a common edge intersect only when folded flat") {
  const Vec3 s(0, 0, 0), t(4, 0, 0), a(1, 2, 0);
  CHECK(trianglesIntersectSharedEdge(s, t, a, Vec3(2, 1, 0)));
  CHECK(trianglesIntersectSharedEdge(s, t, a, a));
  CHECK_FALSE(trianglesIntersectSharedEdge(s, t, a, Vec3(2, -1, 0)));
  CHECK_FALSE(trianglesIntersectSharedEdge(s, t, a, Vec3(2, 1, 1e-60)));
  CHECK_FALSE(trianglesIntersectSharedEdge(s, t, a, Vec3(2, 0, 0)));
  CHECK_FALSE(trianglesIntersectSharedEdge(s, t, a, Vec3(9, 0, 0)));
  CHECK(trianglesIntersectSharedEdge(s, t, Vec3(9, 0, 0), Vec3(5, 0, 0)));
  CHECK_FALSE(trianglesIntersectSharedEdge(s, t, Vec3(9, 0, 0), Vec3(-5, 0, 0)));
}

TEST_CASE("the answer does not depend on the order of points and triangles or on exact rotation") {
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec3, 6> p;
    for (Vec3& q : p) {
      const double x = static_cast<double>(random() % 4), y = static_cast<double>(random() % 4),
                   z = static_cast<double>(random() % 4);
      q = Vec3(x, y, z);
    }
    Points a{p[0], p[1], p[2]};
    Points b{p[3], p[4], p[5]};
    const bool expected = intersect(a, b);
    REQUIRE(intersect(b, a) == expected);
    std::shuffle(a.begin(), a.end(), random);
    std::shuffle(b.begin(), b.end(), random);
    REQUIRE(intersect(a, b) == expected);
    for (Points* t : {&a, &b}) {
      for (Vec3& q : *t) q = Vec3(-q.z(), q.x(), -q.y());
    }
    REQUIRE(intersect(a, b) == expected);
  }
}
