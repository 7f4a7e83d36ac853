#include "core/surgery/opening.h"

#include <set>

#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;
using testing::areaOf;
using testing::graphDistances;
using testing::pinchingPair;
using testing::vertexNear;
using testing::volumeOf;

namespace {

//! Every loop edge is held in the loop's direction by a face that goes, in the other by one that stays.
void expectLoopsBoundOpening(const Mesh& mesh, const Opening& o) {
  const auto goes = [&](int h) { return std::binary_search(o.faces.begin(), o.faces.end(), h / 3); };
  std::size_t edges = 0;
  std::set<int> onLoops;
  for (const auto& loop : o.loops) {
    REQUIRE(loop.size() >= 3);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int h = mesh.findHalfedge(loop[i], loop[(i + 1) % loop.size()]);
      REQUIRE(h >= 0);
      REQUIRE(goes(h));
      REQUIRE_FALSE(goes(mesh.opposite(h)));
      REQUIRE(onLoops.insert(loop[i]).second);  // simple, and no two loops meet
      ++edges;
    }
  }
  std::size_t boundary = 0;
  for (int f : o.faces)
    for (int h = 3 * f; h < 3 * f + 3; ++h) boundary += !goes(mesh.opposite(h));
  REQUIRE(edges == boundary);
}

//! Every face with a vertex in Λ goes, and no other.
void expectStars(const Mesh& mesh, const Opening& o) {
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    const bool inStar = std::any_of(
        t.begin(), t.end(), [&](int v) { return std::binary_search(o.lambda.begin(), o.lambda.end(), v); });
    REQUIRE(inStar == std::binary_search(o.faces.begin(), o.faces.end(), f));
  }
}

std::vector<int> randomSet(const Mesh& mesh, std::mt19937& random, unsigned oneIn) {
  std::vector<int> lambda;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (random() % oneIn == 0) lambda.push_back(v);
  if (lambda.empty()) lambda.push_back(0);
  return lambda;
}

}  // namespace

TEST_CASE("the opening around one vertex is its star, bounded by its link") {
  const Mesh mesh(zoo::sphere(5));
  for (int v = 0; v < mesh.vertexSlots(); v += 7) {
    const auto o = planOpening(mesh, {v});
    REQUIRE(o);
    CHECK(o->lambda == std::vector<int>{v});
    CHECK(o->faces.size() == static_cast<std::size_t>(mesh.valence(v)));
    REQUIRE(o->loops.size() == 1);
    CHECK(o->loops[0].size() == static_cast<std::size_t>(mesh.valence(v)));
    expectLoopsBoundOpening(mesh, *o);
    expectStars(mesh, *o);
  }
}

TEST_CASE("enlarging a set adds its neighbours and nothing else") {
  const Mesh mesh(zoo::sphere(6));
  const std::vector<int> d = graphDistances(mesh, {3});
  std::vector<int> expected;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (d[v] <= 2) expected.push_back(v);
  CHECK(enlarge(mesh, enlarge(mesh, {3})) == expected);
}

TEST_CASE("planning an opening leaves the mesh unchanged, also where it is refused") {
  const Mesh mesh(zoo::sphere(8));
  Mesh same = mesh;
  CHECK(planOpening(same, {5}));
  CHECK_FALSE(planOpening(same, pinchingPair(mesh)));
  CHECK(same.compact().points == mesh.compact().points);
  CHECK(same.compact().triangles == mesh.compact().triangles);
}

TEST_CASE("a vertex enclosed by the set joins it") {
  const Mesh mesh(zoo::sphere(6));
  const int v = vertexNear(mesh, Vec3(0.3, 0.5, 0.8));
  std::vector<int> ring;
  mesh.forEachNeighbour(v, [&](int w) { ring.push_back(w); });
  std::sort(ring.begin(), ring.end());
  const auto o = planOpening(mesh, ring);
  REQUIRE(o);
  CHECK(std::binary_search(o->lambda.begin(), o->lambda.end(), v));
  CHECK(o->lambda.size() == ring.size() + 1);
  CHECK(o->loops.size() == 1);
  expectLoopsBoundOpening(mesh, *o);
}

TEST_CASE("a set all round a larger part leaves it enclosed, with a polygon of its own") {
  const Mesh mesh(zoo::sphere(10));
  const std::vector<int> d = graphDistances(mesh, {vertexNear(mesh, Vec3(0, 0, 1))});
  std::vector<int> ring;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (d[v] == 3) ring.push_back(v);
  const auto o = planOpening(mesh, ring);
  REQUIRE(o);
  CHECK(o->lambda == ring);
  CHECK(o->loops.size() == 2);
  expectLoopsBoundOpening(mesh, *o);
  expectStars(mesh, *o);
}

TEST_CASE("a set that is a whole component has no boundary") {
  const Mesh mesh(zoo::both(zoo::sphere(2), zoo::moved(zoo::sphere(2), Vec3(5, 0, 0))));
  std::vector<int> first;
  for (int v = 0; v < mesh.vertexSlots() / 2; ++v) first.push_back(v);
  const auto o = planOpening(mesh, first);
  REQUIRE(o);
  CHECK(o->loops.empty());
  CHECK(o->faces.size() == static_cast<std::size_t>(mesh.faceCount() / 2));
}

TEST_CASE("where the boundary is simple the mesh is not refined") {
  Mesh mesh(zoo::sphere(8));
  const int before = mesh.vertexCount();
  CHECK_FALSE(openWithRefinement(mesh, {5}).isRefined);
  CHECK(mesh.vertexCount() == before);
}

TEST_CASE("a pinched boundary is refined and the surface does not move") {
  Mesh mesh(zoo::sphere(8));
  const Mesh before = mesh;
  const std::vector<int> lambda = pinchingPair(mesh);
  REQUIRE(lambda.size() == 2);
  const Opening o = openWithRefinement(mesh, lambda);
  CHECK(o.lambda == lambda);
  CHECK(o.isRefined);
  CHECK(o.loops.size() == 2);  // the two stars have come apart
  CHECK(mesh.vertexCount() > before.vertexCount());
  expectLoopsBoundOpening(mesh, o);
  for (int v = 0; v < before.vertexSlots(); ++v) REQUIRE(mesh.position(v) == before.position(v));
  CHECK(areaOf(mesh) == Approx(areaOf(before)).epsilon(1e-12));
  CHECK(volumeOf(mesh) == Approx(volumeOf(before)).epsilon(1e-12));
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("any set can be opened after refinement, on a sphere and on a torus") {
  std::mt19937 random(11);
  for (int n = 0; n < 80; ++n) {
    const bool isTorus = n % 2 == 0;
    Mesh mesh(isTorus ? zoo::torus(16, 9, 2, 0.7) : zoo::sphere(6));
    const double area = areaOf(mesh), volume = volumeOf(mesh);
    const std::vector<int> lambda = randomSet(mesh, random, 2 + static_cast<unsigned>(n) / 4);
    const Opening o = openWithRefinement(mesh, lambda);
    CHECK(std::includes(o.lambda.begin(), o.lambda.end(), lambda.begin(), lambda.end()));
    expectLoopsBoundOpening(mesh, o);
    expectStars(mesh, o);
    CHECK(areaOf(mesh) == Approx(area).epsilon(1e-12));
    CHECK(volumeOf(mesh) == Approx(volume).epsilon(1e-12));
    expectValid(mesh);
    expectTopology(mesh, 1, isTorus ? 1 : 0);
  }
}

TEST_CASE("an opening closed by caps is a closed manifold again") {
  std::mt19937 random(12);
  for (int n = 0; n < 40; ++n) {
    Mesh mesh(zoo::sphere(6));
    const Opening o = openWithRefinement(mesh, randomSet(mesh, random, 3 + static_cast<unsigned>(n) / 2));
    Patch caps;
    caps.firstNew = mesh.vertexSlots();
    for (const auto& loop : o.loops) caps.append(fanCap(mesh, loop));
    testing::apply(mesh, {o}, caps);
    if (mesh.faceCount() == 0) continue;  // everything was taken out
    expectValid(mesh);
    const Certificate c = examine(mesh.compact());
    CHECK(c.euler == 2 * c.components);  // a cut sphere falls into spheres
  }
}
