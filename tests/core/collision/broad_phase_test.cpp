#include <algorithm>
#include <random>

#include "core/collision/box_tree.h"
#include "core/collision/near_faces.h"
#include "core/collision/vertex_stars.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

TEST_CASE("the box tree finds every overlapping pair exactly once") {
  std::mt19937 random(1);
  const auto c = [&](unsigned n) { return static_cast<double>(random() % n); };
  for (const int n : {0, 1, 4, 5, 300}) {
    std::vector<Box> boxes;
    for (int i = 0; i < n; ++i) {
      const double x = c(30), y = c(30), z = c(30);
      const double dx = c(4), dy = c(4), dz = i % 40 == 0 ? 60 : c(4);
      boxes.push_back({Vec3(x, y, z), Vec3(x + dx, y + dy, z + dz)});
    }
    std::vector<std::pair<int, int>> found, expected;
    BoxTree tree;
    tree.build(boxes);
    tree.forEachOverlap([&](int i, int j) { found.emplace_back(std::min(i, j), std::max(i, j)); });
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        if (boxes[i].overlaps(boxes[j])) {
          expected.emplace_back(i, j);
        }
      }
    }
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
  }
}

TEST_CASE("no point of a triangle is within the radius when the vertex is said to be far") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  int far = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 u = point(), a = point(), b = i % 5 == 0 ? Vec3(2 * a - u) : point(), p = 2 * point();
    const double radius = std::abs(normal(random));
    if (!isFarFrom(p, u, a, b, radius * radius)) continue;
    ++far;
    for (int s = 0; s <= 10; ++s) {
      for (int t = 0; s + t <= 10; ++t) {
        REQUIRE((u + 0.1 * s * (a - u) + 0.1 * t * (b - u) - p).norm() > radius);
      }
    }
  }
  CHECK(far > 5000);
}

TEST_CASE("stars of a closed surface are cycles in order, others are not") {
  const TriangleSoup s = zoo::shuffled(zoo::torus(12, 8, 2, 0.5), 3);
  VertexStars stars;
  stars.build(s.points.size(), s.triangles);
  for (int v = 0; v < stars.vertexCount(); ++v) {
    REQUIRE(stars.isCycle(v));
    const auto corners = stars.corners(v);
    REQUIRE(corners.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) REQUIRE(corners[i].prev == corners[(i + 1) % 6].next);
  }
  TriangleSoup open = s;
  const Triangle removed = open.triangles.back();
  open.triangles.back() = {-1, -1, -1};
  stars.build(open.points.size(), open.triangles);
  for (const int v : removed) CHECK_FALSE(stars.isCycle(v));
}

TEST_CASE("stars with many faces are put in order too, and two cones at one vertex are no cycle") {
  for (const int k : {5, 31, 32, 33, 500}) {
    const TriangleSoup one = zoo::shuffled(zoo::rose(k, 1), 5);
    VertexStars stars;
    stars.build(one.points.size(), one.triangles);
    for (int v = 0; v < stars.vertexCount(); ++v) {
      REQUIRE(stars.isCycle(v));
      const auto corners = stars.corners(v);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        REQUIRE(corners[i].prev == corners[(i + 1) % corners.size()].next);
      }
    }
    TriangleSoup two = zoo::both(zoo::rose(k, 1), zoo::rose(k, 1));
    for (Triangle& t : two.triangles) {
      for (int& v : t) v = v == 2 * k + 2 ? k : v;  // the tips become one vertex
    }
    stars.build(two.points.size(), two.triangles);
    CHECK_FALSE(stars.isCycle(k));
    CHECK(stars.corners(k).size() > static_cast<std::size_t>(k));
  }
}
