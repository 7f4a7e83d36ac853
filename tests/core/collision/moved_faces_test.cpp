#include "core/collision/moved_faces.h"

#include "tests/core/collision/detection_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::testing;

TEST_CASE("faces with a moved vertex and their vertices are marked, whether few have moved or many") {
  const TriangleSoup soup = zoo::sphere(6);
  VertexStars stars;
  stars.build(soup.points.size(), soup.triangles);
  MovedFaces marks;
  for (const unsigned every : {1u, 3u, 40u, 1000000u}) {
    const std::vector<unsigned char> moved = someMoved(soup.points.size(), every, 5);
    std::vector<int> vertices;
    marks.mark(soup.points.size(), soup.triangles, moved, stars, vertices);
    std::vector<unsigned char> expected(soup.points.size(), 0);
    std::size_t faces = 0;
    for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f) {
      const Triangle& t = soup.triangles[f];
      const bool isMoved = moved[t[0]] != 0 || moved[t[1]] != 0 || moved[t[2]] != 0;
      CHECK(marks.hasFace(f) == isMoved);
      faces += isMoved;
      for (const int v : t) expected[v] |= static_cast<unsigned char>(isMoved);
    }
    CHECK(marks.list().size() == faces);
    for (int v = 0; v < static_cast<int>(soup.points.size()); ++v)
      CHECK(marks.hasVertex(v) == (expected[v] != 0));
    sortUnique(vertices);
    CHECK(static_cast<long>(vertices.size()) == std::count(expected.begin(), expected.end(), 1));
    marks.clear(vertices);
  }
}

TEST_CASE("nothing is marked after the marks are taken back") {
  const TriangleSoup soup = zoo::sphere(4);
  VertexStars stars;
  stars.build(soup.points.size(), soup.triangles);
  MovedFaces marks;
  std::vector<int> vertices;
  marks.mark(soup.points.size(), soup.triangles, someMoved(soup.points.size(), 2, 3), stars, vertices);
  REQUIRE_FALSE(vertices.empty());
  marks.clear(vertices);
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f) CHECK_FALSE(marks.hasFace(f));
  for (int v = 0; v < static_cast<int>(soup.points.size()); ++v) CHECK_FALSE(marks.hasVertex(v));
}
