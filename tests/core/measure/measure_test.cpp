// Sizes, intensities, gaps and walls of bodies whose figures are known.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/measure/intensity_inside.h"
#include "core/measure/shape_measures.h"
#include "core/measure/surface_gap.h"
#include "core/measure/wall_thickness.h"
#include "core/mesh/quality.h"
#include "core/volume/not_a_number.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

using std::numbers::pi;

//! A turn about no axis in particular.
Eigen::Matrix3d someTurn() {
  return (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-0.4, Vec3::UnitX()))
      .toRotationMatrix();
}

TriangleSoup placed(TriangleSoup s, const Vec3& scale, const Eigen::Matrix3d& turn, const Vec3& move) {
  for (Vec3& p : s.points) p = turn * scale.cwiseProduct(p) + move;
  return s;
}

TriangleSoup ball(double radius, const Vec3& centre, int fineness = 24) {
  return placed(zoo::sphere(fineness), Vec3::Constant(radius), Eigen::Matrix3d::Identity(), centre);
}

double slowFarthest(const std::vector<Vec3>& points) {
  double best = 0;
  for (const Vec3& p : points)
    for (const Vec3& q : points) best = std::max(best, (p - q).norm());
  return best;
}

TriangleSoup together(TriangleSoup a, const TriangleSoup& b, bool isCavity) {
  const int first = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (Triangle t : b.triangles) {
    if (isCavity) std::swap(t[1], t[2]);
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return a;
}

//! The value at a voxel's centre, in mm, of 40³ voxels of 0.5 × 0.5 × 1 mm.
template <typename F>
Volume volumeOf(F&& value) {
  Grid grid;
  grid.size = {40, 40, 40};
  grid.spacing = Vec3(0.5, 0.5, 1);
  grid.origin = Vec3(-10, -10, -20);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::float32, &buffer);
  auto* voxel = static_cast<float*>(buffer);
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) *voxel++ = static_cast<float>(value(grid.toWorld(Vec3(x, y, z))));
  return volume;
}

}  // namespace

TEST_CASE("an ellipsoid has its volume, centroid, diameter and axes, wherever it lies", "[measure]") {
  const Eigen::Matrix3d turn = someTurn();
  const Vec3 centre(120, -340, 900);
  const ShapeMeasures m = shapeMeasures(placed(zoo::sphere(40), Vec3(12, 30, 20), turn, centre));
  CHECK(m.volume == Approx(4 * pi / 3 * 12 * 30 * 20).epsilon(0.005));
  CHECK((m.centroid - centre).norm() < 1e-6);
  CHECK(m.largest.distance == Approx(60).epsilon(0.005));
  CHECK((m.largest.from - m.largest.to).norm() == Approx(m.largest.distance));
  CHECK(m.extents[0] == Approx(60).epsilon(0.005));
  CHECK(m.extents[1] == Approx(40).epsilon(0.005));
  CHECK(m.extents[2] == Approx(24).epsilon(0.005));
  const std::array<int, 3> axes{1, 2, 0};
  for (int a = 0; a < 3; ++a) {
    const Vec3 expected = turn.col(axes[a]), found = m.axes.col(a);
    CHECK(std::abs(found.dot(expected)) == Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("a ball and a torus have their areas and extents", "[measure]") {
  const ShapeMeasures b = shapeMeasures(ball(15, Vec3(1, 2, 3)));
  CHECK(b.area == Approx(4 * pi * 225).epsilon(0.01));
  CHECK(b.largest.distance == Approx(30).epsilon(0.01));
  CHECK((b.box - Vec3(30, 30, 30)).cwiseAbs().maxCoeff() < 0.3);
  const ShapeMeasures t = shapeMeasures(zoo::torus(120, 60, 20, 5));
  CHECK(t.volume == Approx(2 * pi * pi * 20 * 25).epsilon(0.01));
  CHECK(t.area == Approx(4 * pi * pi * 20 * 5).epsilon(0.01));
  CHECK(t.largest.distance == Approx(50).epsilon(0.01));
  CHECK(t.extents[2] == Approx(10).epsilon(0.01));
  CHECK(std::abs(t.axes(2, 2)) == Approx(1));
}

TEST_CASE("a cavity is taken off the volume and added to the area", "[measure]") {
  const ShapeMeasures m = shapeMeasures(together(ball(10, Vec3(0, 0, 0)), ball(4, Vec3(3, 0, 0)), true));
  CHECK(m.volume == Approx(4 * pi / 3 * (1000 - 64)).epsilon(0.01));
  CHECK(m.area == Approx(4 * pi * (100 + 16)).epsilon(0.01));
  CHECK(m.centroid.x() == Approx(-3.0 * 64 / (1000 - 64)).epsilon(0.01));
}

TEST_CASE("the farthest pair is the one that all pairs give", "[measure]") {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 60; ++run) {
    std::vector<Vec3> points;
    const int n = 1 + static_cast<int>(random() % 400);
    const Vec3 scale(1, run % 3 == 0 ? 1 : 4, run % 5 == 0 ? 0 : 2);
    for (int i = 0; i < n; ++i) {
      Vec3 p(normal(random), normal(random), normal(random));
      if (run % 2 == 0) p.normalize();
      if (run % 7 == 0) p = p.array().round();
      points.push_back(scale.cwiseProduct(p));
    }
    CHECK(farthestPair(points).distance == slowFarthest(points));
  }
  CHECK(farthestPair({}).distance == 0);
}

TEST_CASE("intensities are those of the voxels whose centre is inside", "[measure]") {
  const Vec3 centre(0.1, -0.2, 0.3);
  const TriangleSoup mesh = ball(6, centre);
  const auto value = [](const Vec3& p) { return 3 * p.x() - p.y() + 0.5 * p.z(); };
  const IntensityInside found = intensityInside(mesh, volumeOf(value));
  CHECK(found.isWhole);
  CHECK(static_cast<double>(found.voxels) * 0.25 == Approx(4 * pi / 3 * 216).epsilon(0.01));
  CHECK(found.mean == Approx(value(centre)).margin(0.05));
  const double variance = (9 + 1 + 0.25) * 36 / 5;  // a coordinate in a ball: r²/5
  CHECK(found.deviation == Approx(std::sqrt(variance)).epsilon(0.01));
  const double most = std::sqrt(9 + 1 + 0.25) * 6;
  CHECK(found.maximum == Approx(value(centre) + most).margin(1.5));
  CHECK(found.maximum < value(centre) + most);
  CHECK(found.minimum == Approx(value(centre) - most).margin(1.5));
}

TEST_CASE("intensities of a mesh that leaves the volume, has no voxel or has none with a value",
          "[measure]") {
  const auto isNumber = [](const Vec3& p) { return p.x() < 0 ? std::nan("") : 7.0; };
  const IntensityInside half = intensityInside(ball(6, Vec3(0, 0, 0)), volumeOf(isNumber));
  CHECK(half.mean == 7);
  CHECK(half.deviation == 0);
  CHECK(half.withoutValue > 1000);
  const Volume volume = volumeOf([](const Vec3&) { return 1; });
  const IntensityInside beyond = intensityInside(ball(6, Vec3(9, 0, 0)), volume);
  CHECK_FALSE(beyond.isWhole);
  CHECK(beyond.voxels > 0);
  const IntensityInside none = intensityInside(ball(6, Vec3(90, 0, 0)), volume);
  CHECK(none.voxels == 0);
  CHECK_FALSE(none.isWhole);
  CHECK(intensityInside(ball(0.05, Vec3(0.2, 0.2, 0.2)), volume).voxels == 0);
}

TEST_CASE("the number that readers put in the place of NaN is no intensity, wherever the least one lies",
          "[measure]") {
  const float none = notANumberBelow(-1000.0F);
  const auto value = [none](const Vec3& p) {
    return p.norm() > 17 ? -1000 : p.x() < 0 ? none : 7.0F;  // the least lies outside of the ball
  };
  const IntensityInside found = intensityInside(ball(6, Vec3(0, 0, 0)), volumeOf(value));
  CHECK(found.minimum == 7);
  CHECK(found.mean == 7);
  CHECK(found.deviation == 0);
  CHECK(found.withoutValue > 1000);
  // Without a voxel just above it, it is a value like any other.
  const auto low = [none](const Vec3& p) { return p.x() < 0 ? none : 7.0F; };
  CHECK(intensityInside(ball(6, Vec3(0, 0, 0)), volumeOf(low)).withoutValue == 0);
}

TEST_CASE("two bodies are as far from each other as their nearest points", "[measure]") {
  const Vec3 far(20, 5, -3);
  const SurfaceGap gap = surfaceGap(ball(6, Vec3(0, 0, 0)), ball(4, far));
  CHECK(gap.contact == BodyContact::none);
  CHECK(gap.distance == Approx(far.norm() - 10).epsilon(0.01));
  CHECK((gap.onA - gap.onB).norm() == Approx(gap.distance));
  CHECK((gap.onA - 6 * far.normalized()).norm() < 0.8);
  const SurfaceGap within = surfaceGap(ball(10, Vec3(0, 0, 0), 60), ball(4, Vec3(3, 0, 0), 60));
  CHECK(within.contact == BodyContact::inside);
  CHECK(within.distance == Approx(3).epsilon(0.01));
  CHECK(surfaceGap(ball(10, Vec3(0, 0, 0)), ball(4, Vec3(8, 0, 0))).distance == 0);
  // Edge against edge: two wedges, crosswise.
  const TriangleSoup below{{Vec3(-5, 0, 0), Vec3(5, 0, 0), Vec3(0, 3, -4), Vec3(0, -3, -4)},
                           {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
  const TriangleSoup above{{Vec3(0, -5, 1), Vec3(0, 5, 1), Vec3(3, 0, 5), Vec3(-3, 0, 5)},
                           {{0, 1, 3}, {1, 0, 2}, {0, 3, 2}, {1, 2, 3}}};
  const SurfaceGap edges = surfaceGap(below, above);
  CHECK(edges.distance == Approx(1));
  CHECK((edges.onA - Vec3(0, 0, 0)).norm() < 1e-9);
}

TEST_CASE("every pair of bodies has its gap, once", "[measure]") {
  const TriangleSoup a = ball(6, Vec3(0, 0, 0)), b = ball(4, Vec3(20, 0, 0)), c = ball(3, Vec3(0, 15, 0));
  const std::vector<PairGap> gaps = pairGaps({&a, &b, &c});
  REQUIRE(gaps.size() == 3);
  const std::vector<const TriangleSoup*> bodies{&a, &b, &c};
  std::set<std::pair<int, int>> pairs;
  for (const PairGap& g : gaps) {
    CHECK(g.from < g.to);
    pairs.insert({g.from, g.to});
    const SurfaceGap alone = surfaceGap(*bodies[g.from], *bodies[g.to]);
    CHECK(g.gap.distance == alone.distance);
    CHECK(g.gap.onA == alone.onA);
  }
  CHECK(pairs.size() == 3);
  CHECK(pairGaps({&a}).empty());
  CHECK(pairGaps({}).empty());
}

TEST_CASE("the wall between two balls is as thick as their radii differ", "[measure]") {
  const TriangleSoup shell = together(ball(10, Vec3(0, 0, 0), 60), ball(7, Vec3(0, 0, 0), 60), true);
  const auto [outer, inner] = outerAndInner(shell);
  REQUIRE(outer.triangles.size() == inner.triangles.size());
  const WallThickness wall = wallThickness(outer, inner);
  for (const DirectedDistances& d : {wall.fromFirst, wall.fromSecond}) {
    CHECK(d.mean == Approx(3).epsilon(0.01));
    CHECK(d.smallest == Approx(3).epsilon(0.01));
    CHECK(d.percentile95 == Approx(3).epsilon(0.01));
  }
  CHECK(outerAndInner(ball(3, Vec3(0, 0, 0)))[1].triangles.empty());
}

TEST_CASE("the quality of a regular tetrahedron, a cube and a flat triangle", "[measure]") {
  const TriangleSoup tetrahedron{{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)},
                                 {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const MeshQuality q = meshQuality(tetrahedron);
  CHECK(q.angles.least == Approx(60));
  CHECK(q.angles.largest == Approx(60));
  CHECK(q.radiusRatio.least == Approx(1));
  CHECK(q.edges.median == Approx(std::sqrt(8)));
  CHECK(q.dihedral.least == Approx(std::acos(1.0 / 3) * 180 / pi));
  CHECK(q.flat == 0);
  const MeshQuality c = meshQuality(zoo::cube(3));
  CHECK(c.angles.least == Approx(45));
  CHECK(c.dihedral.least == Approx(90));
  CHECK(c.dihedral.largest == Approx(180));
  const MeshQuality f = meshQuality({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}}});
  CHECK(f.flat == 1);
  CHECK(f.radiusRatio.least == 0);
  CHECK(meshQuality({}).edges.largest == 0);
}
