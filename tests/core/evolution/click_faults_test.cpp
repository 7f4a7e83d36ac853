#include "core/evolution/click_faults.h"

#include "core/errors.h"
#include "core/evolution/active_contour.h"
#include "core/evolution/clicked_object.h"
#include "core/mesh/shapes.h"
#include "core/mesh/topology.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;

namespace {

const Vec3 kCentre(20, 20, 20);
constexpr double kRadius = 12;

Seed inside(const Vec3& place) { return {place, {}, false}; }
Seed outside(const Vec3& place) { return {place, {}, true}; }

//! A ball with a hollow of half its radius.
Mesh shell() {
  TriangleSoup all = icosphere(kCentre, kRadius, 1);
  const TriangleSoup hollow = icosphere(kCentre, kRadius / 2, 1);
  const int shift = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), hollow.points.begin(), hollow.points.end());
  for (const Triangle& t : hollow.triangles)
    all.triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
  return Mesh(all);
}

//! `beyond` mm further from the centre than a vertex of the ball. Nothing of the ball is nearer to it than
//! that vertex, as all of it lies within the sphere on which its vertices lie.
Vec3 placeBeyond(double beyond) {
  const Vec3 corner = icosphere(kCentre, kRadius, 1).points[7];
  return corner + beyond * (corner - kCentre).normalized();
}

std::vector<FindingKind> kindsOf(const std::vector<Finding>& findings) {
  std::vector<FindingKind> kinds;
  for (const Finding& f : findings) kinds.push_back(f.kind);
  return kinds;
}

double distanceOf(const Finding& f) { return f.number("distance_mm"); }

}  // namespace

TEST_CASE("a seed and a click outside in one voxel contradict each other, and both are named") {
  const Grid grid = cubicGrid(41);
  const Vec3 near = kCentre + Vec3(0.4, -0.4, 0), far = kCentre + Vec3(0.6, 0, 0);
  const auto found = contradictionOf(grid, {inside(far), inside(kCentre), outside(near)});
  REQUIRE(found);
  CHECK(found->kind == FindingKind::clicksContradict);
  CHECK(sentence(*found) ==
        "The seed at 20.0,20.0,20.0 mm and the click outside of the object at 20.4,19.6,20.0 mm contradict "
        "each other: both lie in one voxel.");
  CHECK_FALSE(contradictionOf(grid, {inside(kCentre), outside(far)}));
  CHECK_FALSE(contradictionOf(grid, {inside(kCentre), inside(near), outside(far), outside(far)}));
}

TEST_CASE("a ball outside contradicts the seeds in it") {
  const Grid grid = cubicGrid(41);
  Seed ball = outside(kCentre + Vec3(6, 0, 0));
  ball.radius = 6.5;
  const auto found = contradictionOf(grid, {inside(kCentre - Vec3(3, 0, 0)), inside(kCentre), ball});
  REQUIRE(found);
  CHECK(sentence(*found) ==
        "The seed at 20.0,20.0,20.0 mm lies in the ball of 6.5 mm around the click outside of the object at "
        "26.0,20.0,20.0 mm: they contradict each other.");
  ball.radius = 5.5;
  CHECK_FALSE(contradictionOf(grid, {inside(kCentre), ball}));
  Seed wide = inside(kCentre);  // the start of a surface may lie around the object
  wide.radius = 10;
  CHECK_FALSE(contradictionOf(grid, {wide, ball}));
}

TEST_CASE("a click outside at the deepest place of a start is told of the start, not of a seed") {
  const Volume empty = testing::volumeByIndex(cubicGrid(41), [](int, int, int) { return 0; });
  StartSurface start;
  start.mesh = std::make_shared<const TriangleSoup>(icosphere(kCentre, kRadius, 3));
  start.inside = kCentre;
  Seed ball = outside(kCentre + Vec3(5, 0, 0));
  ball.radius = 6;
  for (const Seed& click : {outside(kCentre), ball})
    CHECK_THROWS_WITH(findClickedObject(empty, {click}, {}, nullptr, &start),
                      Contains("holds the deepest place of the surface to begin with"));
}

TEST_CASE("clicks that contradict each other are refused before anything grows, and on the way") {
  const Volume ball = testing::volumeByDistance(cubicGrid(41), 0, 100,
                                                [](const Vec3& p) { return (p - kCentre).norm() - kRadius; });
  const std::vector<Seed> clicks{inside(kCentre), outside(kCentre)};
  CHECK_THROWS_AS(ActiveContour(ball, clicks, {}), SeedError);
  ActiveContour contour(ball, {inside(kCentre)}, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  const double before = signedVolume(contour.mesh());
  CHECK_THROWS_AS(contour.change({clicks, {}, {}}), SeedError);
  CHECK(signedVolume(contour.mesh()) == before);
}

TEST_CASE("clicks on the wrong side of a surface are told with how far they lie from it") {
  const Mesh mesh = shell();
  const Grid grid = cubicGrid(41);
  const Vec3 within = kCentre + Vec3(0.75 * kRadius, 0, 0);
  CHECK(unheededClicks(mesh, grid, {inside(within), outside(kCentre), outside(placeBeyond(3))}).empty());
  const std::vector<Finding> wrong =
      unheededClicks(mesh, grid, {inside(placeBeyond(3)), inside(kCentre), inside(kCentre), outside(within)});
  REQUIRE(kindsOf(wrong) == std::vector{FindingKind::seedNotEnclosed, FindingKind::seedNotEnclosed,
                                        FindingKind::clickEnclosed});
  CHECK(distanceOf(wrong[0]) == Approx(3).epsilon(1e-9));
}

TEST_CASE("a ball outside is told where the surface reaches into it by more than what voxels tell") {
  const Grid grid = cubicGrid(41);
  Seed ball = outside(placeBeyond(6));
  ball.radius = 7;
  CHECK(unheededClicks(shell(), grid, {ball}).empty());
  ball.radius = 8;
  const std::vector<Finding> found = unheededClicks(shell(), grid, {ball, ball});
  REQUIRE(kindsOf(found) == std::vector{FindingKind::ballEntered});
  CHECK(distanceOf(found[0]) == Approx(2).epsilon(1e-9));
}

TEST_CASE("a click is not told within half a voxel of a surface, nor where there is none") {
  const Grid grid = cubicGrid(41);
  CHECK(unheededClicks(shell(), grid, {inside(placeBeyond(0.49))}).empty());
  CHECK(unheededClicks(shell(), grid, {inside(placeBeyond(0.51))}).size() == 1);
  CHECK(unheededClicks(Mesh(TriangleSoup()), grid, {inside(kCentre)}).empty());
}
