// The figures of `compare` against brute force (comparison_oracle.h), for label maps and meshes.

#include <numeric>

#include "core/mesh/shapes.h"
#include "core/solid/comparison.h"
#include "core/solid/mask_surface.h"
#include "tests/core/solid/comparison_oracle.h"
#include "tests/core/solid/drawn_masks.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! As voxel_topology.h counts: the components of the body and not of its surface.
VoxelTopology topologyOf(const Solid& solid) {
  const Certificate& c = solid.certificate;
  return {c.components - c.cavities, c.cavities, std::accumulate(c.genus.begin(), c.genus.end(), 0)};
}

//! `pieces`: of `from`, with their distances to `to`.
void requireDirectedByForce(const std::vector<Piece>& pieces, const TriangleSoup& from,
                            const TriangleSoup& to, const DirectedDistances& found) {
  const auto [smallest, largest] = extremesOf(pieces, from, to);
  CHECK(found.samples == pieces.size());
  CHECK(found.area == Approx(areaOf(pieces)).epsilon(1e-9));
  CHECK(found.mean == Approx(meanOf(pieces)).epsilon(1e-9));
  CHECK(found.percentile95 == Approx(percentileOf(pieces, 0.95)).epsilon(1e-9));
  CHECK(found.largest == Approx(largest).epsilon(1e-9));
  CHECK(found.smallest == Approx(smallest).epsilon(1e-9).margin(1e-9));
}

void requireDistancesByForce(const Solid& a, const Solid& b, const SurfaceDistances& found) {
  auto ofA = piecesOf(a.surface, b.surface, found.sampling);
  const auto ofB = piecesOf(b.surface, a.surface, found.sampling);
  requireDirectedByForce(ofA, a.surface, b.surface, found.ofA);
  requireDirectedByForce(ofB, b.surface, a.surface, found.ofB);
  CHECK(found.percentile95() ==
        Approx(std::max(percentileOf(ofA, 0.95), percentileOf(ofB, 0.95))).epsilon(1e-9));
  CHECK(found.hausdorff() == std::max(found.ofA.largest, found.ofB.largest));
  ofA.insert(ofA.end(), ofB.begin(), ofB.end());
  CHECK(found.mean() == Approx(meanOf(ofA)).epsilon(1e-9));
}

//! That of the label map with the smaller voxels; of two meshes a cubic one. Where that lies is no part of
//! the definition, and taken as it is (half a step into A's box): compared is which of its points count.
Grid latticeOf(const Solid& a, const Solid& b, double spacing) {
  if (a.mask && b.mask)
    return b.mask->grid.voxelVolume() < a.mask->grid.voxelVolume() ? b.mask->grid : a.mask->grid;
  if (a.mask || b.mask) return a.mask ? a.mask->grid : b.mask->grid;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : a.surface.points) box.extend(p);
  Grid lattice;
  lattice.spacing.setConstant(spacing);
  lattice.origin = box.min() + 0.5 * lattice.spacing;
  return lattice;
}

void requireOverlapByForce(const Solid& a, const Solid& b, double spacing, const Comparison& found) {
  const Overlap o = overlapByForce(a, b, latticeOf(a, b, spacing));
  REQUIRE(found.overlap);
  CHECK(found.overlap->onVoxels == (a.mask || b.mask));
  CHECK(found.overlap->a == Approx(o.a));
  CHECK(found.overlap->b == Approx(o.b));
  CHECK(found.overlap->both == Approx(o.both));
  CHECK(*found.dice == Approx(2 * o.both / (o.a + o.b)));
  CHECK(*found.iou == Approx(o.both / (o.a + o.b - o.both)));
  CHECK((o.both > 0 && o.both < std::min(o.a, o.b)));  // else little would be proved
}

void requireSame(const DirectedDistances& one, const DirectedDistances& other) {
  CHECK(one.mean == other.mean);
  CHECK(one.percentile95 == other.percentile95);
  CHECK(one.largest == other.largest);
}

//! Either way round.
void requireByForce(const Solid& a, const Solid& b, double sampling) {
  const Comparison found = compare(a, b, {sampling, 2}), turned = compare(b, a, {sampling, 2});
  requireOverlapByForce(a, b, sampling, found);
  requireOverlapByForce(b, a, sampling, turned);
  requireDistancesByForce(a, b, *found.distances);
  requireSame(turned.distances->ofA, found.distances->ofB);
  requireSame(turned.distances->ofB, found.distances->ofA);
  CHECK((found.warnings.empty() && turned.warnings.empty()));
}

//! A label map has the volume and the topology of its voxels, too.
Solid checkedSolid(const Mask& mask) {
  Solid solid = solidOf(mask);
  CHECK(solid.volume() == Approx(static_cast<double>(mask.count()) * mask.grid.voxelVolume()));
  CHECK(topologyOf(solid) == voxelTopology(mask));
  return solid;
}

//! A thick shell. No two sides are equally long: which is halved first is no matter of taste.
TriangleSoup hollowBall() {
  TriangleSoup cavity = icosphere(Vec3(0.4, -0.3, 0.2), 2.6, 1.3);
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  return zoo::perturbed(zoo::both(icosphere(Vec3(0, 0, 0), 5, 1.6), cavity), 0.15, 3);
}

//! A ring through the shell of hollowBall() that lies across all axes.
TriangleSoup ringSoup() {
  TriangleSoup ring = zoo::perturbed(zoo::torus(18, 8, 4.2, 1.4), 0.1, 4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (Vec3& p : ring.points) p = turn * p + Vec3(2.3, 0.4, -0.9);
  return ring;
}

//! A hollow ball on the oblique grid.
Mask hollowMask() {
  return draw(obliqueGrid(),
              [](const Vec3& p) { return std::max(p.norm() - 7, 3 - (p - Vec3(1, 0, 0)).norm()); });
}

//! Points here and there, from -7 to 7 mm.
TriangleSoup scattered(unsigned seed) {
  return zoo::moved(zoo::latticeSoup(150, 50, 15, seed), Vec3(-7.03, -6.96, -7.01));
}

//! Returns how many of the points lie inside.
int requireSignedByForce(const TriangleSoup& from, const TriangleSoup& to) {
  const std::vector<double> found = vertexDistances(from, to, true, 2);
  REQUIRE(found.size() == from.points.size());
  int inside = 0;
  for (std::size_t v = 0; v < found.size(); ++v) {
    const bool isInside = timesAround(to, from.points[v]) > 0;
    const double distance = distanceTo(to, from.points[v]);
    CHECK(found[v] == Approx(isInside ? -distance : distance).epsilon(1e-9));
    inside += isInside ? 1 : 0;
  }
  return inside;
}

}  // namespace

TEST_CASE("figures of label maps on one grid are those of brute force", "[solid][compare]") {
  const Grid grid = gridAround(20, 1);
  requireByForce(checkedSolid(draw(grid, ball(Vec3(0.3, 0, 0), 6.2))),
                 checkedSolid(draw(grid, ball(Vec3(2, -1, 1), 5))), 1.3);
}

TEST_CASE("figures of label maps on different grids and directions are those of brute force",
          "[solid][compare]") {
  const Solid a = checkedSolid(hollowMask()),
              b = checkedSolid(draw(gridAround(22, 1.05), ball(Vec3(2, 1, -1), 6)));
  requireByForce(a, b, 1.3);
}

TEST_CASE("figures of two meshes are those of brute force", "[solid][compare]") {
  const Solid a = solidOf(hollowBall()), b = solidOf(ringSoup());
  CHECK(topologyOf(a) == VoxelTopology{1, 1, 0});
  CHECK(topologyOf(b) == VoxelTopology{1, 0, 1});
  requireByForce(a, b, 0.7);
}

TEST_CASE("figures of a mesh and a label map on a rotated grid are those of brute force",
          "[solid][compare]") {
  requireByForce(solidOf(ringSoup()), checkedSolid(hollowMask()), 1.3);
}

TEST_CASE("signed distances of vertices are those of brute force, positive in a cavity as well",
          "[solid][compare]") {
  const TriangleSoup hollow = hollowBall(), from = scattered(1);
  const int inside = requireSignedByForce(from, hollow);
  CHECK((inside > 10 && inside < 100));  // else little would be proved
  CHECK(std::any_of(from.points.begin(), from.points.end(), [&](const Vec3& p) {
    return p.norm() < 3.5 && timesAround(hollow, p) == 0;  // in the cavity
  }));
  CHECK(requireSignedByForce(scattered(2), ringSoup()) > 3);
  CHECK(requireSignedByForce(hollow, ringSoup()) > 3);
  CHECK(requireSignedByForce(scattered(3), maskSurface(hollowMask())) > 10);
}

TEST_CASE("a vertex where a surface winds around it twice lies inside", "[solid][compare]") {
  const TriangleSoup overlapping = zoo::scaled(zoo::overlappingSpheres(3), 5), from = scattered(4);
  CHECK(requireSignedByForce(from, overlapping) > 10);
  const Vec3 middle = 5 * Vec3(0.85, 0.055, 0.035);  // between the centres
  REQUIRE(timesAround(overlapping, middle) == 2);
  TriangleSoup one = from;
  one.points[0] = middle;
  CHECK(requireSignedByForce(one, overlapping) > 10);
}

TEST_CASE("vertices right beside a face have the sign of their side", "[solid][compare]") {
  constexpr double kBeside = 1e-6;  // mm
  for (const TriangleSoup& to : {hollowBall(), ringSoup(), maskSurface(hollowMask())}) {
    TriangleSoup out, in;
    for (const Triangle& t : to.triangles) {
      const Corners c = cornersOf(to, t);
      const Vec3 step = kBeside * (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      out.points.push_back((c[0] + c[1] + c[2]) / 3 + step);
      in.points.push_back((c[0] + c[1] + c[2]) / 3 - step);
    }
    const auto isNear = [](double expected) {
      return [=](double d) { return std::abs(d - expected) < 1e-3 * kBeside; };
    };
    const auto outside = vertexDistances(out, to, true, 2), inside = vertexDistances(in, to, true, 2);
    CHECK(std::all_of(outside.begin(), outside.end(), isNear(kBeside)));
    CHECK(std::all_of(inside.begin(), inside.end(), isNear(-kBeside)));
  }
}

TEST_CASE("a label map and the mesh of its surface have the tunnels and cavities of its voxels",
          "[solid][compare]") {
  int tunnels = 0, cavities = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO(seed);
    Mask mask = randomMask({9, 10, 11}, 0.45 + 0.1 * (seed % 6), seed);
    if (seed % 2 == 1) makeOblique(mask.grid);
    const VoxelTopology counted = voxelTopology(mask);
    CHECK(topologyOf(solidOf(mask)) == counted);
    CHECK(topologyOf(solidOf(maskSurface(mask))) == counted);
    tunnels += counted.tunnels;
    cavities += counted.cavities;
  }
  CHECK((tunnels > 100 && cavities > 20));  // else little would be proved
}
