#include "core/surgery/closing.h"

#include <Eigen/Geometry>
#include <set>

#include "core/surgery/handle_fitting.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;
using testing::graphDistances;
using testing::intersections;
using testing::vertexNear;
using testing::verticesNear;
using testing::volumeOf;

namespace {

//! A pyramid: apex 4 over the square 0 1 2 3, whose diagonal 0–2 is an edge of the base.
Mesh pyramid() {
  TriangleSoup s;
  s.points = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}, {0.5, 0.5, 1}};
  s.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
  return Mesh(s);
}

//! Least area of all triangulations of the polygon i … j, by trying them all.
double leastArea(const std::vector<Vec3>& p, std::size_t i, std::size_t j) {
  if (j - i < 2) return 0;
  double best = 1e300;
  for (std::size_t m = i + 1; m < j; ++m)
    best =
        std::min(best, (p[m] - p[i]).cross(p[j] - p[i]).norm() / 2 + leastArea(p, i, m) + leastArea(p, m, j));
  return best;
}

bool staysOpen(const std::vector<Opening>& openings, int f) {
  return std::none_of(openings.begin(), openings.end(), [f](const Opening& o) {
    return std::binary_search(o.faces.begin(), o.faces.end(), f);
  });
}

//! Edges of the patch inside it (not on a loop) that the opened mesh holds as well.
int repeatedEdges(const Mesh& mesh, const std::vector<Opening>& openings, const Patch& patch) {
  std::set<std::pair<int, int>> onLoop;
  for (const Opening& o : openings)
    for (const auto& loop : o.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        onLoop.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  int repeated = 0;
  for (const Triangle& t : patch.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const int u = t[i], v = t[(i + 1) % 3];
      if (u >= patch.firstNew || v >= patch.firstNew || onLoop.count(std::minmax(u, v))) continue;
      const int h = mesh.findHalfedge(u, v);
      if (h >= 0) repeated += staysOpen(openings, h / 3) || staysOpen(openings, mesh.opposite(h) / 3);
    }
  return repeated;
}

//! Openings around two vertices at the given graph distance.
std::vector<Opening> openingsApart(const Mesh& mesh, int from, int distance) {
  const std::vector<int> d = graphDistances(mesh, {from});
  const auto to = std::find(d.begin(), d.end(), distance);
  REQUIRE(to != d.end());
  return {*planOpening(mesh, {from}), *planOpening(mesh, {static_cast<int>(to - d.begin())})};
}

std::vector<std::vector<int>> firstLoops(const std::vector<Opening>& openings) {
  std::vector<std::vector<int>> loops;
  for (const Opening& o : openings) loops.push_back(o.loops[0]);
  return loops;
}

}  // namespace

TEST_CASE("a fan cap closes a hole round the polygon's barycentre") {
  Mesh mesh(zoo::sphere(6));
  const Opening o = *planOpening(mesh, verticesNear(mesh, Vec3(0, 0, 1), 0.3));
  REQUIRE(o.loops.size() == 1);
  const Patch cap = fanCap(mesh, o.loops[0]);
  Vec3 sum(0, 0, 0);
  double length = 0;
  for (int v : o.loops[0]) sum += mesh.position(v);
  REQUIRE(cap.points.size() == 1);
  CHECK((cap.points[0] - sum / static_cast<double>(o.loops[0].size())).norm() < 1e-14);
  for (int v : o.loops[0]) length += (mesh.position(v) - cap.points[0]).norm();
  CHECK(cap.length == Approx(length));
  testing::apply(mesh, {o}, cap);
  CHECK(intersections(mesh).empty());
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("a cap of least area closes a hole without a new vertex") {
  Mesh mesh(zoo::sphere(6));
  const Opening o = *planOpening(mesh, verticesNear(mesh, Vec3(0, 0, 1), 0.3));
  const auto cap = leastAreaCap(mesh, o, o.loops[0]);
  REQUIRE(cap);
  CHECK(cap->points.empty());
  CHECK(cap->faces.size() == o.loops[0].size() - 2);
  CHECK(area(mesh, *cap) <= area(mesh, fanCap(mesh, o.loops[0])));
  testing::apply(mesh, {o}, *cap);
  CHECK(intersections(mesh).empty());
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("the cap of least area has the least area of all triangulations") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Mesh mesh(zoo::perturbed(zoo::sphere(4), 0.1, seed));
    const Opening o =
        *planOpening(mesh, {static_cast<int>(seed), mesh.target(mesh.outgoing(static_cast<int>(seed)))});
    REQUIRE(o.loops.size() == 1);
    const auto cap = leastAreaCap(mesh, o, o.loops[0]);
    REQUIRE(cap);
    std::vector<Vec3> p;
    for (int v : o.loops[0]) p.push_back(mesh.position(v));
    CHECK(area(mesh, *cap) == Approx(leastArea(p, 0, p.size() - 1)));
  }
}

TEST_CASE("a cap on a flat hole has the area of the hole") {
  const Mesh mesh(zoo::cube(8));
  const Opening o = *planOpening(mesh, verticesNear(mesh, Vec3(0.5, 0.5, 1), 0.2));
  double hole = 0;
  for (int f : o.faces) hole += mesh.areaVector(f).norm() / 2;
  CHECK(area(mesh, *leastAreaCap(mesh, o, o.loops[0])) == Approx(hole));
}

TEST_CASE("a cap on a hole with straight sides has no face without area") {
  const Mesh mesh(zoo::cube(8));
  std::vector<int> square;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3 d = (mesh.position(v) - Vec3(0.5, 0.5, 1)).cwiseAbs();
    if (d.maxCoeff() < 0.26) square.push_back(v);
  }
  const Opening o = *planOpening(mesh, square);
  REQUIRE(o.loops.size() == 1);
  const auto cap = leastAreaCap(mesh, o, o.loops[0]);
  REQUIRE(cap);
  for (const Triangle& t : cap->faces) {
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    CHECK((b - a).cross(c - a).norm() > 1e-3);
  }
}

TEST_CASE("a cap of least area does not repeat an edge that the mesh has outside the hole") {
  Mesh mesh = pyramid();
  const Opening o = *planOpening(mesh, {4});
  const auto cap = leastAreaCap(mesh, o, o.loops[0]);
  REQUIRE(cap);
  CHECK(repeatedEdges(mesh, {o}, *cap) == 0);
  testing::apply(mesh, {o}, *cap);
  CHECK(mesh.vertexCount() == 4);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("handles between two loops join the mesh without repeating an edge, near and far") {
  const Mesh mesh(zoo::sphere(7));
  for (int distance : {3, 4, 6})
    for (int from = 0; from < mesh.vertexSlots(); from += 31) {
      CAPTURE(distance, from);
      const auto openings = openingsApart(mesh, from, distance);
      const auto handles = handlesBetween(mesh, openings, firstLoops(openings), 5);
      CHECK(!handles.empty());
      double last = 0;
      for (const Patch& handle : handles) {
        CHECK(repeatedEdges(mesh, openings, handle) == 0);
        CHECK(handle.length >= last);
        last = handle.length;
        Mesh joined = mesh;
        testing::apply(joined, openings, handle);
        expectValid(joined);
        expectTopology(joined, 1, 1);
      }
    }
}

TEST_CASE("no more handles are made than asked for") {
  const Mesh mesh(zoo::sphere(7));
  const auto openings = openingsApart(mesh, 0, 5);
  CHECK(handlesBetween(mesh, openings, firstLoops(openings), 1).size() == 1);
  CHECK(handlesBetween(mesh, openings, firstLoops(openings), 3).size() == 3);
}

TEST_CASE("the volume gained by a patch is the difference of the volumes of the meshes") {
  const Mesh mesh(zoo::moved(zoo::perturbed(zoo::sphere(7), 0.02, 5), Vec3(30, -20, 10)));
  const auto openings = openingsApart(mesh, 12, 5);
  const std::vector<Opening> first{openings[0]};
  std::vector<std::pair<std::vector<Opening>, Patch>> cases{
      {first, fanCap(mesh, openings[0].loops[0])},
      {first, *leastAreaCap(mesh, openings[0], openings[0].loops[0])}};
  for (const Patch& p : handlesBetween(mesh, openings, firstLoops(openings), 4))
    cases.emplace_back(openings, p);
  for (const auto& [opened, patch] : cases) {
    Mesh closed = mesh;
    testing::apply(closed, opened, patch);
    CHECK(volumeGain(mesh, opened, patch) == Approx(volumeOf(closed) - volumeOf(mesh)).margin(1e-9));
  }
}

TEST_CASE("patches appended to each other keep their own new vertices") {
  Mesh mesh(zoo::sphere(7));
  const auto openings = openingsApart(mesh, 12, 5);
  Patch both = fanCap(mesh, openings[0].loops[0]);
  const Patch second = fanCap(mesh, openings[1].loops[0]);
  const double length = both.length + second.length;
  both.append(second);
  CHECK(both.points.size() == 2);
  CHECK(both.length == Approx(length));
  testing::apply(mesh, openings, both);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("a cap fits its hole, one that reaches through the far side does not") {
  const Mesh mesh(zoo::sphere(7));
  const std::vector<Opening> o{*planOpening(mesh, verticesNear(mesh, Vec3(0, 0, 1), 0.3))};
  const Surroundings around(mesh, FaceBlocks(mesh), o, {});
  Patch cap = fanCap(mesh, o[0].loops[0]);
  CHECK(around.fits(cap));
  cap.points[0] = Vec3(0, 0, 2);  // a spike outwards is ugly, but intersects nothing
  CHECK(around.fits(cap));
  cap.points[0] = Vec3(1.2, 0.1, 0.9);  // through the side of the sphere
  CHECK_FALSE(around.fits(cap));
}

TEST_CASE("a patch that intersects itself does not fit") {
  const Mesh mesh(zoo::both(zoo::sphere(5), zoo::moved(zoo::sphere(5), Vec3(0, 0, 3))));
  const int top = vertexNear(mesh, Vec3(0, 0, 1)), bottom = vertexNear(mesh, Vec3(0, 0, 2));
  const std::vector<Opening> o{*planOpening(mesh, {top}), *planOpening(mesh, {bottom})};
  const Surroundings around(mesh, FaceBlocks(mesh), o, {});
  Patch caps = fanCap(mesh, o[0].loops[0]);
  caps.append(fanCap(mesh, o[1].loops[0]));
  CHECK(around.fits(caps));
  std::swap(caps.points[0], caps.points[1]);  // the caps run through each other
  CHECK_FALSE(around.fits(caps));
}

TEST_CASE("a patch does not fit where its face is one of the mesh already") {
  TriangleSoup s;
  s.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Mesh tetrahedron(s);
  const std::vector<Opening> o{*planOpening(tetrahedron, {3})};
  const auto cap = leastAreaCap(tetrahedron, o[0], o[0].loops[0]);
  CHECK((!cap || !Surroundings(tetrahedron, FaceBlocks(tetrahedron), o, {}).fits(*cap)));
}

TEST_CASE("faces that are ignored do not stand in the way of a patch") {
  const Mesh mesh(zoo::both(zoo::sphere(7), zoo::moved(zoo::scaled(zoo::sphere(2), 0.1), Vec3(0, 0, 0.97))));
  const int n = Mesh(zoo::sphere(7)).faceSlots();
  const std::vector<Opening> hole{*planOpening(mesh, {vertexNear(Mesh(zoo::sphere(7)), Vec3(0, 0, 1))})};
  const Patch cap = fanCap(mesh, hole[0].loops[0]);
  CHECK_FALSE(Surroundings(mesh, FaceBlocks(mesh), hole, {}).fits(cap));
  std::vector<unsigned char> ignored(mesh.faceSlots(), 0);
  for (int f = n; f < mesh.faceSlots(); ++f) ignored[f] = 1;
  CHECK(Surroundings(mesh, FaceBlocks(mesh), hole, ignored).fits(cap));
}
