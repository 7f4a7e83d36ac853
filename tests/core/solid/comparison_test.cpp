#include "core/solid/comparison.h"

#include <atomic>
#include <cmath>
#include <numbers>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/solid/overlap.h"
#include "core/solid/surface_distance.h"
#include "tests/core/solid/comparison_oracle.h"
#include "tests/core/solid/drawn_masks.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr ComparisonOptions kCoarse{0.4, 2};  // mm; the default would take longer
using std::numbers::pi;

//! Share of each of two balls that lies in the other.
double lensShare(double radius, double apart) {
  const double lens = pi * (4 * radius + apart) * std::pow(2 * radius - apart, 2) / 12;
  return lens / (4 * pi / 3 * std::pow(radius, 3));
}

//! Of a sphere from an equal one: at the cosine t, which is uniform over its area.
double sphereDistance(double radius, double apart, double t) {
  return std::abs(std::sqrt(radius * radius + apart * apart - 2 * radius * apart * t) - radius);
}

}  // namespace

TEST_CASE("a label map drawn on two grids is nearly the same object", "[solid][compare]") {
  const auto body = ball(Vec3(0.2, 0.1, -0.3), 6);
  const Comparison c =
      compare(solidOf(draw(obliqueGrid(), body)), solidOf(draw(gridAround(60, 0.4), body)), kCoarse);
  // Both surfaces lie within half a cell's diagonal of the sphere.
  const double bound = 0.5 * (obliqueGrid().spacing.norm() + Vec3::Constant(0.4).norm());
  CHECK(c.distances->hausdorff() < bound);
  CHECK(*c.dice > 1 - 3 * bound / 6);
}

TEST_CASE("an object is the same as itself", "[solid][compare]") {
  for (const Solid& s :
       {solidOf(zoo::torus(40, 20, 10, 3)), solidOf(draw(obliqueGrid(), ball({0, 0, 0}, 5)))}) {
    const Comparison c = compare(s, s, kCoarse);
    CHECK(*c.dice == 1);
    CHECK(*c.iou == 1);
    CHECK(c.distances->hausdorff() < 1e-6);
    CHECK(c.warnings.empty());
  }
}

TEST_CASE("two balls that are apart have the Dice coefficient and distances of the formulas",
          "[solid][compare]") {
  constexpr double kRadius = 10, kApart = 6, kEdge = 0.5;
  const Solid a = solidOf(icosphere(Vec3(0, 0, 0), kRadius, kEdge));
  const Solid b = solidOf(icosphere(Vec3(kApart * 0.6, 0, kApart * 0.8), kRadius, kEdge));
  const Comparison c = compare(a, b, {0.3, 2});
  const double facets = kEdge * kEdge / (6 * kRadius);  // how deep a facet lies under its sphere, at most
  CHECK(*c.dice == Approx(lensShare(kRadius, kApart)).margin(0.003));
  CHECK(*c.iou == Approx(*c.dice / (2 - *c.dice)));
  double mean = 0;
  std::vector<Piece> pieces;
  for (int i = 0; i < 20000; ++i) {
    const double d = sphereDistance(kRadius, kApart, -1 + (i + 0.5) / 10000);
    mean += d / 20000;
    pieces.push_back({d, 1});
  }
  CHECK(c.distances->mean() == Approx(mean).margin(2 * facets));
  CHECK(c.distances->ofA.mean == Approx(c.distances->ofB.mean).margin(2 * facets));
  CHECK(c.distances->percentile95() == Approx(percentileOf(pieces, 0.95)).margin(2 * facets + 0.2));
  CHECK(c.distances->hausdorff() == Approx(kApart).margin(2 * facets));
}

TEST_CASE("concentric balls are as far apart as their radii everywhere", "[solid][compare]") {
  const Solid a = solidOf(icosphere(Vec3(5, 5, 5), 10, 0.5)), b = solidOf(icosphere(Vec3(5, 5, 5), 8, 0.5));
  const Comparison c = compare(a, b, kCoarse);
  CHECK(c.distances->mean() == Approx(2).margin(0.02));
  CHECK(c.distances->percentile95() == Approx(2).margin(0.02));
  CHECK(c.distances->hausdorff() == Approx(2).margin(0.02));
  CHECK(c.distances->smallest() == Approx(2).margin(0.02));
  CHECK(*c.dice == Approx(2.0 * 512 / (1000 + 512)).margin(0.003));
  const auto outside = vertexDistances(a.surface, b.surface, true, 1);
  const auto inside = vertexDistances(b.surface, a.surface, true, 2);
  CHECK(std::all_of(outside.begin(), outside.end(), [](double d) { return std::abs(d - 2) < 0.02; }));
  CHECK(std::all_of(inside.begin(), inside.end(), [](double d) { return std::abs(d + 2) < 0.02; }));
}

TEST_CASE("a mesh against its own label map has the voxels of that map", "[solid][compare]") {
  const Mask mask = draw(gridAround(40, 0.7), ball(Vec3(0.1, 0.2, 0.3), 9));
  const Comparison c = compare(solidOf(icosphere(Vec3(0.1, 0.2, 0.3), 9, 0.2)), solidOf(mask), kCoarse);
  CHECK(c.overlap->onVoxels);
  CHECK(*c.dice == Approx(1).margin(2e-3));  // facets lie a little under the sphere
  CHECK(c.distances->hausdorff() < 0.5 * Vec3::Constant(0.7).norm());
}

TEST_CASE("the figures do not depend on the number of threads", "[solid][compare]") {
  const Solid a = solidOf(zoo::bumpySphere(12, 0)), b = solidOf(zoo::bumpySphere(11, 1));
  const Comparison one = compare(a, b, {0.02, 1}), three = compare(a, b, {0.02, 3});
  CHECK(one.distances->mean() == three.distances->mean());
  CHECK(one.distances->percentile95() == three.distances->percentile95());
  CHECK(one.dice == three.dice);
}

TEST_CASE("objects that do not meet are told with their distance", "[solid][compare]") {
  const Solid a = solidOf(icosphere(Vec3(0, 0, 0), 3, 0.4)), b = solidOf(icosphere(Vec3(10, 0, 0), 3, 0.4));
  const Comparison c = compare(a, b, kCoarse);
  CHECK(*c.dice == 0);
  CHECK(c.distances->smallest() == Approx(4).margin(0.05));
  REQUIRE(c.warnings.size() == 1);
  CHECK(c.warnings[0].kind == FindingKind::objectsApart);
  CHECK_THAT(sentence(c.warnings[0]),
             Contains("A and B do not overlap: their surfaces are ") && Contains("10 mm"));
}

TEST_CASE("objects that would meet in the other space are told so", "[solid][compare]") {
  const Solid a = solidOf(icosphere(Vec3(20, 30, 5), 3, 0.4)),
              b = solidOf(icosphere(Vec3(-20, -30, 5), 3, 0.4));
  REQUIRE(compare(a, b, kCoarse).warnings.size() == 1);
  const Finding turned = compare(a, b, kCoarse).warnings[0];
  CHECK(turned.kind == FindingKind::objectsTurned);
  CHECK_THAT(sentence(turned),
             Contains("With the signs of x and y turned in one of them they would meet: is one in "
                      "RAS and does not say so?"));
}

TEST_CASE("an empty object has no distances, and no overlap with what is not empty", "[solid][compare]") {
  Mask none;
  none.grid.size = {0, 0, 0};
  const Solid empty = solidOf(none), full = solidOf(icosphere(Vec3(0, 0, 0), 3, 0.4));
  const Comparison c = compare(empty, full, kCoarse);
  CHECK(c.dice == 0.0);
  CHECK_FALSE(c.distances);
  CHECK(c.warnings.size() == 1);
  CHECK(empty.volume() == 0);
  const Comparison nothing = compare(empty, empty, kCoarse);
  CHECK_FALSE(nothing.dice);
  CHECK_FALSE(nothing.distances);
}

TEST_CASE("an open mesh has distances and no volume", "[solid][compare]") {
  TriangleSoup open = icosphere(Vec3(0, 0, 0), 3, 0.4);
  open.triangles.resize(open.triangles.size() / 2);
  const Solid a = solidOf(open), b = solidOf(icosphere(Vec3(0, 0, 0), 2, 0.4));
  CHECK_FALSE(a.isClosed());
  const Comparison c = compare(a, b, kCoarse);
  CHECK_FALSE(c.dice);
  CHECK(c.distances->ofA.mean == Approx(1).margin(0.05));
  REQUIRE(c.warnings.size() == 1);
  CHECK(c.warnings[0].kind == FindingKind::objectOpen);
  CHECK(sentence(c.warnings[0]) ==
        "A is not closed: it has no volume, and there is no Dice coefficient. Distances are measured from "
        "and to "
        "what there is of its surface.");
}

TEST_CASE("a mesh that is inside out is turned", "[solid][compare]") {
  TriangleSoup turned = icosphere(Vec3(0, 0, 0), 3, 0.4);
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  const Solid a = solidOf(turned), b = solidOf(icosphere(Vec3(0, 0, 0), 3, 0.4));
  CHECK(a.volume() == Approx(b.volume()));
  CHECK(*compare(a, b, kCoarse).dice == 1);
  CHECK(compare(a, b, kCoarse).warnings.size() == 1);
}

TEST_CASE("a part that is inside out where it bounds nothing leaves no volume, and is told",
          "[solid][compare]") {
  const auto beside = [](const Vec3& centre, double radius, bool isTurned) {
    TriangleSoup two = icosphere(Vec3(0, 0, 0), 3, 0.4);
    TriangleSoup other = icosphere(centre, radius, 0.4);
    const int first = static_cast<int>(two.points.size());
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (Triangle t : other.triangles) {
      if (isTurned) std::swap(t[1], t[2]);
      two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return solidOf(two);
  };
  const Vec3 apart(8, 0, 0);
  const Solid whole = beside(apart, 2, false);
  CHECK(compare(whole, whole, kCoarse).dice == 1.0);
  CHECK(compare(beside({0, 0, 0}, 1, true), whole, kCoarse).dice);  // a cavity
  for (const Solid& wrong : {beside(apart, 2, true), beside({0, 0, 0}, 1, false)}) {
    CHECK_FALSE(wrong.isClosed());
    const Comparison c = compare(wrong, whole, kCoarse);
    CHECK_FALSE(c.dice);
    CHECK_FALSE(c.overlap);
    CHECK(c.distances);
    REQUIRE(c.warnings.size() == 1);
    CHECK(c.warnings[0].kind == FindingKind::objectMisplaced);
  }
}

TEST_CASE("needles and large triangles take few samples, and a sampling that is too fine is refused",
          "[solid][compare]") {
  TriangleSoup needle;
  needle.points = {Vec3(0, 0, 0), Vec3(1000, 0, 0), Vec3(1000, 0.01, 0)};
  needle.triangles = {{0, 1, 2}};
  CHECK(countSamples(needle, 1, 1'000'000) < 100'000);
  const Solid a = solidOf(zoo::scaled(zoo::cube(1), 100));
  CHECK_THROWS_AS(compare(a, a, {0.001, 1}), TooManySamples);
}

TEST_CASE("a surface that reaches farther than numbers are fine is counted to an end", "[solid][compare]") {
  TriangleSoup far = icosphere(Vec3(0, 0, 0), 3, 1);
  far.points[0] = Vec3(1e24, -1e24, 0);
  CHECK(countSamples(far, 1, 50'000'000) > 50'000'000);
  TriangleSoup needle;
  needle.points = {Vec3(0, 0, 0), Vec3(1e24, 0, 0), Vec3(1e24, 1e-30, 0)};
  needle.triangles = {{0, 1, 2}};
  CHECK(countSamples(needle, 1, 10'000) > 10'000);
}

TEST_CASE("a lattice that would be too large is made coarser", "[solid][compare]") {
  Mask small = draw(gridAround(5, 0.01), ball(Vec3(0, 0, 0), 0.018));
  const Solid large = solidOf(zoo::scaled(zoo::cube(2), 50));
  const Comparison c = compare(solidOf(small), large, {5, 1});
  REQUIRE(c.overlap);
  CHECK_FALSE(c.overlap->onVoxels);
  CHECK(c.overlap->b == Approx(125000).epsilon(0.02));
}

TEST_CASE("a comparison that nobody wants any more ends", "[solid][compare]") {
  const Solid a = solidOf(zoo::sphere(40)), b = solidOf(zoo::scaled(zoo::sphere(40), 1.1));
  const std::atomic<bool> cancelled = true;
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(compare(a, b, {}), Cancelled);
  CHECK_THROWS_AS(overlapOf(a, b, 0.05), Cancelled);
  CHECK_THROWS_AS(vertexDistances(a.surface, b.surface, true, 2), Cancelled);
}
