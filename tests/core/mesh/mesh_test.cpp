#include "core/mesh/mesh.h"

#include <random>

#include "core/mesh/shapes.h"
#include "tests/support/expect_valid.h"

using namespace handlebody;

namespace {
Mesh sphere() { return Mesh(icosphere(Vec3(1, 2, 3), 10, 3)); }

int randomHalfedge(const Mesh& mesh, std::mt19937& random) {
  int f = 0;
  do f = static_cast<int>(random() % static_cast<unsigned>(mesh.faceSlots()));
  while (!mesh.isFace(f));
  return 3 * f + static_cast<int>(random() % 3);
}
}  // namespace

TEST_CASE("an icosphere is a closed sphere with the right area and edges no longer than asked") {
  const TriangleSoup soup = icosphere(Vec3(5, -3, 2), 10, 1);
  const Certificate c = examine(soup);
  CHECK(c.passes() == false);  // self-intersections have not been counted
  CHECK((c.closed && c.manifold && c.oriented));
  CHECK(c.genus == std::vector<int>{0});
  CHECK(c.volume == Approx(4.0 / 3 * M_PI * 1000).epsilon(0.01));
  CHECK(c.area == Approx(4 * M_PI * 100).epsilon(0.01));
  const Mesh mesh(soup);
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    CHECK((mesh.position(mesh.origin(h)) - mesh.position(mesh.target(h))).norm() <= 1.0);
  expectValid(mesh);
}

TEST_CASE("random splits, flips and collapses keep a mesh closed, manifold and of the same topology") {
  Mesh mesh = sphere();
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    const int h = randomHalfedge(mesh, random);
    const Vec3 middle = (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))) / 2;
    const auto what = random() % 3;
    if (what == 0) mesh.splitEdge(h, middle);
    if (what == 1 && mesh.canFlip(h)) mesh.flipEdge(h);
    if (what == 2 && mesh.canCollapse(h)) mesh.collapseEdge(h, middle);
  }
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("collapsing never goes below a tetrahedron") {
  Mesh mesh = sphere();
  for (bool any = true; any;) {
    any = false;
    for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
      if (mesh.isFace(h / 3) && mesh.canCollapse(h)) {
        mesh.collapseEdge(h, mesh.position(mesh.origin(h)));
        any = true;
      }
  }
  CHECK(mesh.vertexCount() == 4);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("faces removed around a vertex and added again give the mesh back") {
  Mesh mesh = sphere();
  std::vector<int> faces;
  std::vector<Triangle> triangles;
  mesh.forEachOutgoing(5, [&](int h) {
    faces.push_back(Mesh::faceOf(h));
    triangles.push_back(mesh.face(Mesh::faceOf(h)));
  });
  mesh.removeFaces(faces);
  CHECK(mesh.outgoing(5) < 0);
  for (const Triangle& t : triangles)
    for (int v : t) {
      if (v == 5) continue;
      int boundary = 0;
      mesh.forEachOutgoing(v, [&](int h) { boundary += mesh.opposite(h) < 0; });
      CHECK(boundary == 1);
      CHECK(mesh.valence(v) >= 4);
    }
  mesh.addFaces(triangles);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("the certificate sees an open, a non-manifold and an inside-out mesh") {
  TriangleSoup soup = icosphere(Vec3(0, 0, 0), 1, 2);
  TriangleSoup open = soup;
  open.triangles.pop_back();
  CHECK_FALSE(examine(open).closed);
  CHECK(examine(open).manifold);

  TriangleSoup insideOut = soup;
  for (Triangle& t : insideOut.triangles) std::swap(t[0], t[1]);
  CHECK_FALSE(examine(insideOut).oriented);

  TriangleSoup pinched = soup;  // two spheres that share one vertex
  const int n = static_cast<int>(soup.points.size());
  const TriangleSoup other = icosphere(soup.points[0] * 2, 1, 2);
  for (const Vec3& p : other.points) pinched.points.push_back(p);
  for (Triangle t : other.triangles) {
    for (int& v : t) v = v == 3 ? 0 : v + n;
    pinched.triangles.push_back(t);
  }
  CHECK(examine(pinched).closed);
  CHECK_FALSE(examine(pinched).manifold);

  TriangleSoup flipped = soup;
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  CHECK_FALSE(examine(flipped).oriented);
}
