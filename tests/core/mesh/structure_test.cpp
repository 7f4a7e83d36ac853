#include "core/mesh/structure.h"

#include <random>

#include "core/mesh/validity.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

int anyHalfedge(const Mesh& mesh, std::mt19937& random) {
  int h = 0;
  do h = static_cast<int>(random() % static_cast<unsigned>(3 * mesh.faceSlots()));
  while (!mesh.isFace(Mesh::faceOf(h)));
  return h;
}

void remesh(Mesh& mesh, std::mt19937& random, int times) {
  for (int i = 0; i < times; ++i) {
    const int h = anyHalfedge(mesh, random);
    const Vec3 middle = (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))) / 2;
    const auto what = random() % 3;
    if (what == 0) mesh.splitEdge(h, middle);
    if (what == 1 && mesh.canFlip(h)) mesh.flipEdge(h);
    if (what == 2 && mesh.canCollapse(h)) mesh.collapseEdge(h, middle);
  }
}

//! Damages that go through the mesh's own operations.
void damage(Mesh& mesh, std::mt19937& random, unsigned kind) {
  const int h = anyHalfedge(mesh, random), f = Mesh::faceOf(h);
  const Triangle t = mesh.face(f);
  switch (kind) {
    case 0:
      return mesh.removeFaces(std::vector{f});
    case 1:
      mesh.removeFaces(std::vector{f});
      return mesh.addFaces(std::vector<Triangle>{{t[0], t[2], t[1]}});
    case 2:
      return mesh.addFaces(std::vector<Triangle>{t});
    case 3:
      mesh.addVertex(Vec3(9, 9, 9));
      return;
    default:  // the link condition does not hold: a handle is pinched to a point, or an edge doubled
      if (!mesh.canCollapse(h)) mesh.collapseEdge(h, mesh.position(mesh.origin(h)));
  }
}

bool isSound(const Mesh& mesh) {
  const Certificate c = examine(mesh.compact());
  return c.closed && c.manifold && c.oriented && c.vertices == mesh.vertexCount();
}

//! The torus of seven vertices (Möbius, Császár), in which every two of them have an edge.
TriangleSoup sevenVertexTorus() {
  TriangleSoup s;
  for (int i = 0; i < 7; ++i) s.points.emplace_back(i, i * i % 7, 3 * i % 7);
  for (int i = 0; i < 7; ++i) {
    s.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    s.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return s;
}

}  // namespace

TEST_CASE("valid meshes of any genus have no fault, and the empty one has none") {
  for (const TriangleSoup& s :
       {zoo::sphere(5), zoo::torus(9, 7, 2, 1), zoo::cube(3), sevenVertexTorus(), TriangleSoup()})
    CHECK_FALSE(findStructureFault(Mesh(s)));
}

TEST_CASE("remeshing leaves no fault, whether all of the mesh is looked at or what has changed") {
  std::mt19937 random(5);
  Mesh mesh(zoo::torus(20, 12, 2, 1));
  StructureCheck check;
  for (int round = 0; round < 60; ++round) {
    const Mesh before = mesh;
    remesh(mesh, random, 15);
    CHECK_FALSE(check.examineChanges(before, mesh));
    CHECK_FALSE(check.examine(mesh));
  }
}

TEST_CASE("what the check of the changes finds is what the certificate of the triangles alone finds") {
  std::mt19937 random(11);
  const Mesh start(zoo::torus(12, 8, 2, 1));
  StructureCheck check;
  int broken = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Mesh before = start;
    remesh(before, random, 120);  // few are left that may be collapsed everywhere
    Mesh mesh = before;
    remesh(mesh, random, 3);
    if (trial % 6 < 5) damage(mesh, random, static_cast<unsigned>(trial % 6));
    CAPTURE(trial);
    const bool sound = isSound(mesh);
    broken += !sound;
    CHECK(check.examineChanges(before, mesh).has_value() == !sound);
    CHECK(check.examine(mesh).has_value() == !sound);
  }
  CHECK(broken > 300);
}

TEST_CASE("an edge that is there twice is a fault") {
  Mesh mesh(sevenVertexTorus());
  const Mesh before = mesh;
  REQUIRE_FALSE(mesh.canFlip(0));
  mesh.flipEdge(0);
  for (const auto& fault : {findStructureFault(mesh), StructureCheck().examineChanges(before, mesh)}) {
    REQUIRE(fault);
    CHECK(fault->what == FindingKind::edgesTwice);
  }
}

TEST_CASE("the faces that are new since before are listed, and those only beside them are not") {
  Mesh mesh(zoo::sphere(4));
  const Mesh before = mesh;
  mesh.splitEdge(0, mesh.position(mesh.origin(0)));
  StructureCheck check;
  CHECK_FALSE(check.examineChanges(before, mesh));
  CHECK(check.newFaces().size() == 4);
}

TEST_CASE("the certificate of a mesh is that of its triangles, and tells cavities and misplaced parts") {
  const TriangleSoup body = zoo::scaled(zoo::sphere(6), 3), small = zoo::sphere(3);
  TriangleSoup cavity = small;
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  const auto numbers = [](const TriangleSoup& s) {
    const Certificate a = examine(s), b = examine(Mesh(s));
    CHECK(a.volume == Approx(b.volume));
    CHECK(a.area == Approx(b.area));
    CHECK(a.genus == b.genus);
    CHECK((a.vertices == b.vertices && a.faces == b.faces && a.euler == b.euler && a.closed == b.closed));
    CHECK((a.components == b.components && a.cavities == b.cavities && a.misplaced == b.misplaced));
    return std::pair(a.cavities, a.misplaced);
  };
  CHECK(numbers(body) == std::pair(0, 0));
  CHECK(numbers(zoo::both(body, cavity)) == std::pair(1, 0));
  CHECK(numbers(zoo::both(body, small)) == std::pair(0, 1));
  CHECK(numbers(zoo::both(body, zoo::moved(cavity, Vec3(9, 0, 0)))) == std::pair(1, 1));
  CHECK(numbers(zoo::both(zoo::both(body, cavity), zoo::scaled(small, 0.5))) == std::pair(1, 0));
  TriangleSoup open = body;
  open.triangles.pop_back();
  CHECK(examine(open).misplaced == -1);
  CHECK(examine(Mesh(open)).cavities == -1);
}
