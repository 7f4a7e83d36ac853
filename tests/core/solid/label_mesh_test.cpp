#include "core/solid/label_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/collision/certify.h"
#include "core/collision/closest_point.h"
#include "core/geometry/triangle_angles.h"
#include "core/mesh/quality.h"
#include "core/solid/guarded_mesh.h"
#include "core/solid/mask_surface.h"
#include "core/solid/simplify.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

template <typename Body>
Mask draw(const Vec3& spacing, int n, Body&& distance) {
  Mask mask;
  mask.grid.size = {n, n, n};
  mask.grid.spacing = spacing;
  mask.grid.direction = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  mask.grid.origin = -(mask.grid.direction * ((n - 1) / 2.0 * spacing));
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        mask.inside.push_back(distance(mask.grid.toWorld(Vec3(x, y, z))) < 0 ? 1 : 0);
  return mask;
}

double torus(const Vec3& p, double around, double tube) {
  return std::hypot(std::hypot(p.x(), p.y()) - around, p.z()) - tube;
}

//! Balls of a voxel or a few at random places: blobs that touch along faces, edges and at corners.
Mask blobs(unsigned seed) {
  std::mt19937 random(seed);
  const int n = 8 + static_cast<int>(random() % 8);
  Mask mask = randomMask({n, n, n}, 0.01 * (seed % 4), seed);
  for (int i = 0; i < 12; ++i) {
    const auto any = [&] { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const Vec3 centre(any(), any(), any());
    const double radius = 0.5 + 0.3 * static_cast<double>(random() % 10);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
          if ((Vec3(x, y, z) - centre).norm() <= radius) mask.inside[mask.at(x, y, z)] = i % 4 != 3;
  }
  return mask;
}

//! A box of so many voxels of 0.5 × 0.5 × 5 mm.
Mask thickSlices(const std::array<int, 3>& voxels) {
  Mask mask;
  mask.grid.size = voxels;
  mask.grid.spacing = Vec3(0.5, 0.5, 5);
  mask.inside.assign(mask.grid.voxelCount(), 1);
  return mask;
}

void requireMeshOf(const Mask& mask) {
  const VoxelTopology counted = voxelTopology(mask);
  if (counted.components == 0) return;
  const LabelMesh made = meshOf(mask, {});
  const Certificate c = certify(made.mesh);
  REQUIRE(c.boundsBody());
  REQUIRE(c.cavities == counted.cavities);
  REQUIRE(c.components == counted.components + counted.cavities);
  REQUIRE(tunnelsOf(c) == counted.tunnels);
  REQUIRE(made.farthest <= kMaxApart);
  // No sharper folds than the steps have, or than what a mesher fills.
  const double steps = meshQuality(maskSurface(mask)).dihedral.least;
  REQUIRE(meshQuality(made.mesh).dihedral.least >= std::min(steps, kSharpest) - 1e-3);
}

void requireRandomMeshes(unsigned first, unsigned last) {
  for (unsigned seed = first; seed < last; ++seed) {
    INFO(seed);
    const int n = 3 + static_cast<int>(seed % 6);
    Mask mask = seed % 3 == 0 ? randomMask({n, n + 1, n + 2}, 0.1 + 0.1 * (seed / 3 % 9), seed) : blobs(seed);
    if (seed % 2 == 1) makeOblique(mask.grid);
    requireMeshOf(mask);
  }
}

//! Mean angle between the normals and the gradient of a distance, weighted by area, radians.
template <typename Body>
double normalError(const TriangleSoup& mesh, Body&& distance) {
  double moment = 0, area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]],
               middle = (a + b + c) / 3;
    const Vec3 n = (b - a).cross(c - a);
    Vec3 g;
    for (int i = 0; i < 3; ++i)
      g[i] = distance(middle + 1e-4 * Vec3::Unit(i)) - distance(middle - 1e-4 * Vec3::Unit(i));
    moment += n.norm() * std::acos(std::clamp(n.dot(g) / (n.norm() * g.norm()), -1.0, 1.0));
    area += n.norm();
  }
  return moment / area;
}

}  // namespace

TEST_CASE("meshes of random label maps are certified and have the topology of their voxels",
          "[solid][label-mesh]") {
  requireRandomMeshes(0, 60);
}

TEST_CASE("meshes of more random label maps", "[.][label-mesh-slow]") {
  const char* const wanted = std::getenv("HANDLEBODY_LABEL_MAPS");  // 500 take a minute and a half
  requireRandomMeshes(60, 60 + (wanted ? static_cast<unsigned>(std::atoi(wanted)) : 60));
}

TEST_CASE("a mesh of a label map has no steps, keeps its volume and stays close to the voxels",
          "[solid][label-mesh]") {
  const auto ring = [](const Vec3& p) { return torus(p, 13, 5); };
  const Mask mask = draw(Vec3(1, 0.9, 1.2), 45, ring);
  const TriangleSoup steps = maskSurface(mask);
  const LabelMesh made = meshOf(mask, {});
  CHECK(made.certificate.boundsBody());
  CHECK(made.certificate.genus == std::vector<int>{1});
  CHECK(normalError(made.mesh, ring) < normalError(steps, ring) / 3);
  CHECK(made.certificate.volume ==
        Approx(static_cast<double>(mask.count()) * mask.grid.voxelVolume()).epsilon(0.005));
  TriangleSoup inVoxels = steps;
  for (Vec3& p : inVoxels.points) p = mask.grid.toIndex(p);
  const ClosestPoint nearest(inVoxels);
  double farthest = 0;
  for (const Vec3& p : made.mesh.points)
    farthest = std::max(farthest, nearest.distance(mask.grid.toIndex(p)));
  CHECK(farthest <= kMaxApart);
  CHECK(farthest == Approx(made.farthest));
}

TEST_CASE("a tube of one voxel, and a single voxel, keep their volume and topology", "[solid][label-mesh]") {
  const Mask tube = draw(Vec3(1, 1, 1), 30, [](const Vec3& p) { return torus(p, 10, 0.8); });
  REQUIRE(voxelTopology(tube).tunnels > 0);
  requireMeshOf(tube);
  Mask voxel;
  voxel.grid.size = {1, 1, 1};
  voxel.grid.spacing = Vec3(0.5, 0.6, 3);
  voxel.inside = {1};
  requireMeshOf(voxel);
}

TEST_CASE("what is a few voxels wide keeps its volume in thick slices, and where it does not that is told",
          "[solid][label-mesh]") {
  for (const auto& voxels : {std::array{30, 3, 1}, std::array{1, 1, 12}}) {
    const Mask mask = thickSlices(voxels);
    requireMeshOf(mask);
    const LabelMesh made = meshOf(mask, {});
    CHECK(labelMeshWarnings(made.mesh, made.certificate, mask, {}).empty());
  }
  const Mask few = thickSlices({2, 2, 1});
  const LabelMesh made = meshOf(few, {});
  const double volume = certify(made.mesh).volume;
  const std::vector<Finding> told = labelMeshWarnings(made.mesh, made.certificate, few, {});
  REQUIRE(told.size() == 1);
  CHECK(told[0].kind == FindingKind::volumeOffVoxels);
  CHECK(told[0].number("voxels_ml") == Approx(0.005));
  CHECK(told[0].number("mesh_ml") == Approx(volume / 1000));
  CHECK(told[0].number("percent") == std::round(100 * (volume / 5 - 1)));
}

TEST_CASE("a mesh of a label map does not depend on the number of threads", "[solid][label-mesh]") {
  const Mask mask = blobs(3);
  LabelMeshOptions three;
  three.threads = 3;
  CHECK(meshOf(mask, {}).mesh.points == meshOf(mask, three).mesh.points);
}

TEST_CASE("edges of several voxels are reached where the object is large enough, and told where not",
          "[solid][label-mesh]") {
  const Mask ball = draw(Vec3(1, 1, 1), 24, [](const Vec3& p) { return p.norm() - 9.3; });
  LabelMeshOptions options;
  for (const double asked : {3.0, 4.0}) {
    options.edgeLength = asked;
    const LabelMesh made = meshOf(ball, options);
    CHECK(meshQuality(made.mesh).edges.median == Approx(asked).epsilon(0.25));
    CHECK(labelMeshWarnings(made.mesh, made.certificate, ball, options).empty());
  }
  options.edgeLength = 20;
  const LabelMesh made = meshOf(ball, options);
  const std::vector<Finding> told = labelMeshWarnings(made.mesh, made.certificate, ball, options);
  REQUIRE_FALSE(told.empty());
  CHECK(told.back().kind == FindingKind::edgesNotAsAsked);
  CHECK(told.back().number("asked_mm") == 20);
  CHECK(told.back().number("median_mm") < kShortestWanted * 20);
}

TEST_CASE("without smoothing the mesh is the surface between the voxels", "[solid][label-mesh]") {
  const Mask mask = blobs(5);
  LabelMeshOptions none;
  none.smoothing = 0;
  CHECK(meshOf(mask, none).mesh.points == maskSurface(mask).points);
}

TEST_CASE("vertices that would cross other faces go back, and the others move", "[solid][label-mesh]") {
  const TriangleSoup two = zoo::both(zoo::sphere(6), zoo::moved(zoo::sphere(6), Vec3(2.3, 0, 0)));
  GuardedMesh guarded{Mesh(two)};
  std::vector<Vec3> targets = two.points;
  for (std::size_t v = 0; v < targets.size(); ++v)  // both grow until they overlap
    targets[v] += 0.3 * (v < targets.size() / 2 ? targets[v] : Vec3(targets[v] - Vec3(2.3, 0, 0)));
  guarded.move(targets);
  CHECK(certify(guarded.mesh().compact()).boundsBody());
  CHECK(certify(guarded.mesh().compact()).volume > 1.5 * certify(two).volume);
}

TEST_CASE("what would fold the surface goes back, though nothing would intersect", "[solid][label-mesh]") {
  const TriangleSoup sphere = zoo::sphere(6);
  TriangleSoup lens = sphere;  // ever so flat, and larger
  for (Vec3& p : lens.points) p = p.cwiseProduct(Vec3(40, 40, 0.1));
  REQUIRE(certify(lens).boundsBody());
  REQUIRE(meshQuality(lens).dihedral.least < kSharpest);
  GuardedMesh guarded{Mesh(sphere)};
  guarded.move(lens.points);
  const TriangleSoup after = guarded.mesh().compact();
  CHECK(certify(after).boundsBody());
  CHECK(meshQuality(after).dihedral.least >= kSharpest - 1e-6);
}

TEST_CASE("what would make triangles thin goes back, though nothing would intersect or fold",
          "[solid][label-mesh]") {
  const TriangleSoup sphere = zoo::sphere(6);
  std::vector<Vec3> spindle = sphere.points;
  for (Vec3& p : spindle) p.x() *= 8;
  REQUIRE(meshQuality({spindle, sphere.triangles}).angles.least < 10);
  REQUIRE(meshQuality({spindle, sphere.triangles}).dihedral.least > kSharpest);
  REQUIRE(meshQuality(sphere).angles.least > kThinnest);
  GuardedMesh guarded{Mesh(sphere)};
  guarded.move(spindle);
  CHECK(meshQuality(guarded.mesh().compact()).angles.least >= kThinnest);
}

TEST_CASE("a triangle that is thin from the start may become better, but no worse", "[solid][label-mesh]") {
  TriangleSoup spindle = zoo::sphere(6);
  for (Vec3& p : spindle.points) p.x() *= 8;
  const double thin = meshQuality(spindle).angles.least;
  std::vector<Vec3> longer = spindle.points, shorter = spindle.points;
  for (Vec3& p : longer) p.x() *= 1.1;
  for (Vec3& p : shorter) p.x() *= 0.9;
  GuardedMesh guarded{Mesh(spindle)};
  guarded.move(longer);
  CHECK(meshQuality(guarded.mesh().compact()).angles.least >= thin - 1e-9);
  guarded.move(shorter);
  CHECK(meshQuality(guarded.mesh().compact()).angles.least > thin + 0.3);
}

TEST_CASE("of a noisy label map hardly a triangle is thin", "[solid][label-mesh]") {
  double thin = 0, all = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const TriangleSoup mesh = meshOf(randomMask({10, 10, 10}, 0.3, seed), {}).mesh;
    for (const Triangle& t : mesh.triangles)
      thin += leastAngle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) < 15;
    all += static_cast<double>(mesh.triangles.size());
  }
  CAPTURE(thin, all);
  CHECK(thin <= 0.002 * all);
}

TEST_CASE("a component is not turned inside out, nor made to nothing", "[solid][label-mesh]") {
  const TriangleSoup two = zoo::both(zoo::sphere(4), zoo::moved(zoo::sphere(2), Vec3(5, 0, 0)));
  GuardedMesh guarded{Mesh(two)};
  std::vector<Vec3> targets = two.points;
  for (Vec3& p : targets)
    if (p.x() > 2) p = Vec3(10, 0, 0) - p;  // a point reflection: free of intersections, inside out
  guarded.move(targets);
  CHECK(guarded.mesh().compact().points == two.points);
}

TEST_CASE("the largest part is kept, and tunnels are closed or cut where fewest voxels change",
          "[solid][label-mesh]") {
  const Mask ring = draw(Vec3(1, 1, 1), 30, [](const Vec3& p) {
    return std::min(torus(p, 9, 2.5), (p - Vec3(0, 0, 11)).norm() - 2);
  });
  CHECK(voxelTopology(ring) == VoxelTopology{2, 0, 1});
  const Mask part = largestPart(ring);
  CHECK(voxelTopology(part) == VoxelTopology{1, 0, 1});
  CHECK(countTunnels(ring) == 1);
  CHECK(withFewerTunnels(ring, 1)->inside == ring.inside);
  const auto none = withFewerTunnels(part, 0);
  if (none) CHECK(voxelTopology(*none).tunnels == 0);
  const Mask pierced = draw(Vec3(1, 1, 1), 30, [](const Vec3& p) {
    return std::max(p.norm() - 10, 1.2 - std::hypot(p.x(), p.y()));
  });
  REQUIRE(voxelTopology(pierced).tunnels == 1);
  const auto filled = withFewerTunnels(pierced, 0);
  REQUIRE(filled);
  CHECK(voxelTopology(*filled).components == 1);
  CHECK(voxelTopology(*filled).tunnels == 0);
  CHECK(voxelTopology(*filled).cavities == 0);
  CHECK(filled->count() < pierced.count() + pierced.count() / 20);
}
