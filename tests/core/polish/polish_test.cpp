#include "core/polish/polish.h"

#include <Eigen/Geometry>
#include <atomic>
#include <random>
#include <tuple>

#include "core/cancellation.h"
#include "core/collision/body_contact.h"
#include "core/collision/certify.h"
#include "core/collision/closest_point.h"
#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "core/polish/patch_search.h"
#include "core/solid/mask_surface.h"
#include "core/surgery/plane_cut.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

TriangleSoup inSingle(TriangleSoup mesh) {
  for (Vec3& p : mesh.points) p = handlebody::inSingle(p);
  return mesh;
}

PolishOptions within(double distance) {
  PolishOptions options;
  options.bounds.distance = distance;
  return options;
}

//! The largest distance of points that lie densely in the faces of one mesh from the other.
double farthestOneWay(const TriangleSoup& from, const TriangleSoup& to) {
  constexpr int kSteps = 6;
  const ClosestPoint nearest(to);
  double farthest = 0;
  for (const Triangle& t : from.triangles)
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
        const auto p = [&](std::size_t c) { return from.points[t[c]]; };
        farthest = std::max(farthest, nearest.distance((1 - u - v) * p(0) + u * p(1) + v * p(2)));
      }
  return farthest;
}

double farthest(const TriangleSoup& a, const TriangleSoup& b) {
  return std::max(farthestOneWay(a, b), farthestOneWay(b, a));
}

//! Every mutation test ends with this.
//! `mayEndEarly`: what cannot be bettered may take all the work there is.
void expectPolished(const TriangleSoup& before, const PolishedMesh& done, double distance,
                    bool mayEndEarly = false) {
  const Certificate was = certify(before), is = certify(done.mesh);
  REQUIRE(was.passes());
  CHECK(is.passes());
  expectValid(Mesh(done.mesh));
  CHECK(is.components == was.components);
  CHECK(is.genus == was.genus);
  CHECK(is.cavities == was.cavities);
  CHECK(is.misplaced == was.misplaced);
  CHECK(farthest(before, done.mesh) <= distance * (1 + 1e-9));
  CHECK(done.report.farthest <= distance * (1 + 1e-9));
  for (const Vec3& p : done.mesh.points) CHECK(p == handlebody::inSingle(p));
  const MeshQuality quality = meshQuality(done.mesh), first = meshQuality(before);
  CHECK(done.report.before.leastAngle == Approx(first.angles.least));
  CHECK(done.report.after.leastAngle == Approx(quality.angles.least));
  CHECK(done.report.after.leastDihedral == Approx(quality.dihedral.least));
  CHECK(quality.angles.least >= std::min(15.0, first.angles.least));
  CHECK_FALSE(done.report.isRefused);
  CHECK((mayEndEarly || !done.report.isCutShort));
}

void expectGood(const PolishedMesh& done) {
  INFO(sentence(polishWarning(done.report)));
  CHECK(done.report.after.faces == 0);
  CHECK(done.report.after.edges == 0);
  CHECK(meshQuality(done.mesh).angles.least >= 15);
  CHECK(meshQuality(done.mesh).dihedral.least >= 20);
  CHECK_FALSE(polishWarning(done.report).any());
}

double meanEdge(const TriangleSoup& mesh) { return meshQuality(mesh).edges.median; }

//! Edges split next to one of their ends: needles there.
TriangleSoup withNeedles(const TriangleSoup& soup, int count, unsigned seed) {
  Mesh mesh(soup);
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    const int h = static_cast<int>(random() % static_cast<unsigned>(3 * mesh.faceSlots()));
    const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h));
    const Vec3 p = a + 0.03 * (b - a);
    mesh.splitEdge(h, p);
  }
  return inSingle(mesh.compact());
}

//! Edges split, and the new point put next to the middle of another edge: caps, with an angle near 180°.
TriangleSoup withCaps(const TriangleSoup& soup, int count, unsigned seed) {
  Mesh mesh(soup);
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    const int h = static_cast<int>(random() % static_cast<unsigned>(3 * mesh.faceSlots()));
    const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h)),
               &c = mesh.position(mesh.apex(h));
    const Vec3 p = 0.04 * a + 0.48 * (b + c);
    mesh.splitEdge(h, p);
  }
  return inSingle(mesh.compact());
}

}  // namespace

TEST_CASE("a mesh without bad triangles stays bit for bit", "[polish]") {
  for (const TriangleSoup& mesh : {zoo::sphere(6), zoo::torus(30, 12, 3, 1), zoo::cube(4)}) {
    const PolishedMesh done = polished(mesh, within(0.1));
    CHECK(done.mesh.points == mesh.points);
    CHECK(done.mesh.triangles == mesh.triangles);
    CHECK_FALSE(done.report.isChanged());
    CHECK(done.report.farthest == 0);
  }
}

TEST_CASE("needles and caps go, and the surface stays where it is", "[polish]") {
  for (const TriangleSoup& shape : {zoo::sphere(8), zoo::torus(36, 14, 3, 1), zoo::bumpySphere(9, 0.3)}) {
    const double distance = 0.1 * meanEdge(shape);
    for (const TriangleSoup& mesh : {withNeedles(shape, 12, 3), withCaps(shape, 12, 4)}) {
      const PolishedMesh done = polished(mesh, within(distance));
      CHECK(done.report.before.faces > 0);
      expectPolished(mesh, done, distance);
      expectGood(done);
    }
  }
}

TEST_CASE("ridges and corners stay where slivers beside them go", "[polish]") {
  const TriangleSoup mesh = withNeedles(zoo::cube(4), 12, 9);
  const double distance = 0.1 * 0.25;
  const PolishedMesh done = polished(mesh, within(distance));
  expectPolished(mesh, done, distance);
  expectGood(done);
}

TEST_CASE("vertices that were pushed about along the surface are put in order", "[polish]") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const TriangleSoup mesh = inSingle(zoo::perturbed(zoo::sphere(8), 0.045, seed));
    if (!certify(mesh).passes()) continue;
    const double distance = 0.1 * meanEdge(mesh);
    const PolishedMesh done = polished(mesh, within(distance));
    expectPolished(mesh, done, distance);
    CHECK(done.report.after.leastAngle >= done.report.before.leastAngle);
  }
}

TEST_CASE("nearly all thin faces of a plane cut go, and the others are told", "[polish]") {
  for (int i = 0; i < 2; ++i) {
    const Mesh ball{zoo::bumpySphere(6, 0.1 * i)};
    const TouchedMesh cut =
        cutByPlane(ball, {Vec3(0.05 * i, 0.02, 0.1), Vec3(1 - 3 * i, 2, 9), KeptSide::positive});
    REQUIRE(cut.isDone());
    const TriangleSoup mesh = inSingle(cut.mesh.compact());
    const double distance = 0.1 * meanEdge(ball.compact());
    const PolishedMesh done = polished(mesh, within(distance));
    expectPolished(mesh, done, distance);
    CHECK(done.report.before.faces >= 10);
    CHECK(10 * done.report.after.faces <= done.report.before.faces);
    CHECK(polishWarning(done.report).any() != (done.report.after.faces + done.report.after.edges == 0));
  }
}

// Noise whose parts come within a voxel of each other: much of it cannot be bettered within a tenth of a
// voxel.
TEST_CASE("what cannot be bettered does not take the work of all others", "[polish]") {
  Mask mask = testing::randomMask({12, 12, 12}, 0.25, 1);
  mask.grid.spacing = Vec3(0.7, 0.9, 2.5);
  const TriangleSoup mesh = inSingle(maskSurface(mask));  // smooth ones have hardly a thin triangle
  const PolishedMesh done = polished(mesh, within(0.05));
  expectPolished(mesh, done, 0.05, true);
  const PolishCount &was = done.report.before, &is = done.report.after;
  CAPTURE(was.faces, was.edges, is.faces, is.edges);
  REQUIRE(was.faces + was.edges > 50);
  CHECK(3 * (is.faces + is.edges) < 2 * (was.faces + was.edges));
}

TEST_CASE("what the shape forces stays and is told", "[polish]") {
  // A wedge of 8 degrees, far longer than any polish reaches.
  TriangleSoup mesh;
  mesh.points = {{0, 0, 0}, {0, 10, 0}, {20, 0, 1.4}, {20, 10, 1.4}, {20, 0, -1.4}, {20, 10, -1.4}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 1, 5}, {0, 4, 2}, {1, 3, 5}, {2, 4, 5}, {2, 5, 3}};
  mesh = inSingle(zoo::scaled(mesh, 0.25));
  REQUIRE(certify(mesh).passes());
  const PolishedMesh done = polished(mesh, within(0.05));
  expectPolished(mesh, done, 0.05, true);
  CHECK(done.report.after.edges > 0);
  CHECK_FALSE(done.report.left.empty());
  CHECK_THAT(sentence(polishWarning(done.report)), Contains("sharp edge"));
}

TEST_CASE("a sheet close by is not run into", "[polish]") {
  const TriangleSoup ball = withCaps(withNeedles(zoo::sphere(8), 15, 21), 15, 22);
  const double distance = 0.1 * meanEdge(ball);
  // Around it with next to no gap: a chord of its mesh would leave it.
  TriangleSoup shell = ball;
  for (Vec3& p : shell.points) p *= 1.002;
  for (Triangle& t : shell.triangles) std::swap(t[1], t[2]);
  PolishOptions options = within(distance);
  const std::vector<const TriangleSoup*> obstacles{&shell};
  options.bounds.obstacles = obstacles;
  const PolishedMesh done = polished(ball, options);
  expectPolished(ball, done, distance);
  CHECK(done.report.isChanged());
  CHECK(certify(zoo::both(done.mesh, shell)).selfIntersections == 0);
}

TEST_CASE("where no face may lie none is put, and what is held stays", "[polish]") {
  const TriangleSoup mesh = withNeedles(zoo::sphere(6), 8, 31);
  PolishOptions options = within(0.1 * meanEdge(mesh));
  options.bounds.forbids = [](const Vec3& a, const Vec3& b, const Vec3& c) { return (a + b + c).x() > 0; };
  options.bounds.isHeld.assign(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.points[v].x() < 0 && mesh.points[v].y() > 0) options.bounds.isHeld[v] = 1;
  const PolishedMesh done = polished(mesh, options);
  expectPolished(mesh, done, options.bounds.distance, true);
  CHECK(done.report.isChanged());
  const auto facesWhere = [](const TriangleSoup& m, auto&& isWanted) {
    std::vector<std::array<double, 9>> all;
    for (const Triangle& t : m.triangles) {
      std::array<Vec3, 3> c;
      for (std::size_t i = 0; i < 3; ++i) c[i] = m.points[t[i]];
      if (!isWanted(c)) continue;
      std::rotate(c.begin(),
                  std::min_element(c.begin(), c.end(),
                                   [](const Vec3& x, const Vec3& y) {
                                     return std::tuple(x.x(), x.y(), x.z()) < std::tuple(y.x(), y.y(), y.z());
                                   }),
                  c.end());
      all.push_back(
          {c[0].x(), c[0].y(), c[0].z(), c[1].x(), c[1].y(), c[1].z(), c[2].x(), c[2].y(), c[2].z()});
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto isHeld = [](const auto& c) {
    return std::all_of(c.begin(), c.end(), [](const Vec3& p) { return p.x() < 0 && p.y() > 0; });
  };
  const auto isForbidden = [](const auto& c) { return (c[0] + c[1] + c[2]).x() > 0; };
  const auto heldBefore = facesWhere(mesh, isHeld), heldAfter = facesWhere(done.mesh, isHeld);
  CHECK(std::includes(heldAfter.begin(), heldAfter.end(), heldBefore.begin(), heldBefore.end()));
  const auto there = facesWhere(mesh, isForbidden), now = facesWhere(done.mesh, isForbidden);
  CHECK(std::includes(there.begin(), there.end(), now.begin(), now.end()));
}

TEST_CASE("only its own bad triangles are bettered where that is asked for", "[polish]") {
  const TriangleSoup mesh = withNeedles(zoo::sphere(6), 12, 41);
  PolishOptions options = within(0.1 * meanEdge(mesh));
  for (const Triangle& t : mesh.triangles) options.isOwn.push_back(mesh.points[t[0]].z() > 0.5 ? 1 : 0);
  const PolishedMesh done = polished(mesh, options);
  expectPolished(mesh, done, options.bounds.distance);
  CHECK(done.report.isChanged());
  for (const Vec3& p : mesh.points)
    if (p.z() < 0)
      CHECK(std::find(done.mesh.points.begin(), done.mesh.points.end(), p) != done.mesh.points.end());
}

TEST_CASE("the same mesh is polished to the same bits, and what was polished stays", "[polish]") {
  const TriangleSoup mesh = withCaps(withNeedles(zoo::torus(24, 10, 3, 1), 6, 51), 6, 52);
  const PolishOptions options = within(0.1 * meanEdge(mesh));
  const PolishedMesh one = polished(mesh, options), two = polished(mesh, options);
  CHECK(one.mesh.points == two.mesh.points);
  CHECK(one.mesh.triangles == two.mesh.triangles);
  const PolishedMesh again = polished(one.mesh, options);
  CHECK(again.mesh.points == one.mesh.points);
  CHECK(again.mesh.triangles == one.mesh.triangles);
}

TEST_CASE("polishing can be cancelled", "[polish]") {
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  const TriangleSoup mesh = withNeedles(zoo::sphere(8), 5, 61);
  CHECK_THROWS_AS(polished(mesh, within(0.1 * meanEdge(mesh))), Cancelled);
}

TEST_CASE("cavities, and bodies within them, stay in place", "[polish]") {
  TriangleSoup outer = withNeedles(zoo::sphere(8), 10, 71),
               inner = zoo::scaled(withCaps(zoo::sphere(8), 10, 72), 0.9);
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  const TriangleSoup mesh =
      inSingle(zoo::both(zoo::both(outer, inner), zoo::scaled(withNeedles(zoo::sphere(5), 6, 73), 0.7)));
  const double distance = 0.1 * meanEdge(mesh);
  const PolishedMesh done = polished(mesh, within(distance));
  expectPolished(mesh, done, distance);
  expectGood(done);
  CHECK(certify(done.mesh).boundsBody());
}
