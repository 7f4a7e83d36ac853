// Evolution inwards: starts that reach beyond the object, necks that split, changes that could go on for
// ever.

#include "core/mesh/topology.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

Parameters bothWays() {
  Parameters p;
  p.direction = Direction::both;
  return p;
}

Grid longGrid(int length) {
  Grid grid = cubicGrid(41);
  grid.size[0] = length;
  return grid;
}

Certificate contract(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters) {
  ActiveContour contour(volume, seeds, parameters);
  runCertified(contour);
  CHECK(contour.stopReason() == StopReason::converged);
  return certify(contour.mesh().compact());
}

//! [-a, e]³ and [-e, a]³ (the paper, section 4) about the middle of a grid of 41³.
double overlappingCubes(const Vec3& p, double a, double e) {
  const auto box = [&](double low, double high) {
    return ((p - kMiddle - Vec3::Constant((low + high) / 2)).cwiseAbs()).maxCoeff() - (high - low) / 2;
  };
  return std::min(box(-a, e), box(-e, a));
}

}  // namespace

TEST_CASE("a start larger than the object contracts onto it") {
  for (double radius : {13.0, 18.0, 40.0}) {  // the last reaches far beyond the volume
    ActiveContour contour(ballVolume(), {Seed{kMiddle + Vec3(2, 1, 0), radius}}, bothWays());
    CHECK(*contour.parameters().seeds[0].radius == radius);
    runCertified(contour);
    CHECK(contour.stopReason() == StopReason::converged);
    const Certificate c = certify(contour.mesh().compact());
    CHECK(c.genus == std::vector<int>{0});
    CHECK(c.volume == Approx(kBallVolume).epsilon(0.02));
    CHECK(furthestFrom(contour.mesh(), ballDistance) < 0.5);
  }
}

TEST_CASE("a start that lies partly beyond the object grows and contracts") {
  const Certificate c = contract(ballVolume(), {Seed{kMiddle + Vec3(7, 0, 0), 8.0}}, bothWays());
  CHECK(c.genus == std::vector<int>{0});
  CHECK(c.volume == Approx(kBallVolume).epsilon(0.02));
}

TEST_CASE("where only outward motion is allowed, a seed is cut to what fits in the object") {
  const ActiveContour contour(ballVolume(), {Seed{kMiddle, 18.0}}, {});
  CHECK(*contour.parameters().seeds[0].radius < 10.5);
}

TEST_CASE("a start around a torus contracts onto it, and its hole opens") {
  const Certificate c = contract(torusVolume(), {Seed{kMiddle + Vec3(kTorusR, 0, 0), 32.0}}, bothWays());
  CHECK(c.components == 1);
  CHECK(c.euler == 0);
  CHECK(c.volume == Approx(kTorusVolume).epsilon(0.02));
}

TEST_CASE("a start around two balls splits between them, whatever their distance") {
  for (double gap : {2.5, 8.0, 16.0}) {
    CAPTURE(gap);
    const Vec3 first(14, 20, 20), second(14 + 20 + gap, 20, 20);
    const auto balls = [&](const Vec3& p) { return std::min((p - first).norm(), (p - second).norm()) - 10; };
    const Certificate c = contract(darkObject(longGrid(62), balls), {Seed{first, 34 + gap}}, bothWays());
    CHECK(c.components == 2);
    CHECK(c.euler == 4);
    CHECK(c.volume == Approx(2 * kBallVolume).epsilon(0.02));
  }
}

TEST_CASE("a neck that collapses along all of its length splits once and leaves no pieces") {
  // The curvature (weight 3.5, edges of 2 mm) is stronger than the balloon in the bar, and weaker on the
  // balls.
  const Vec3 first(18, 20, 20), second(64, 20, 20);
  for (double bar : {1.5, 2.0}) {
    CAPTURE(bar);
    const auto dumbbell = [&](const Vec3& p) {
      const Vec3 onAxis(std::clamp(p.x(), first.x(), second.x()), 20, 20);
      return std::min({(p - first).norm() - 14, (p - second).norm() - 14, (p - onAxis).norm() - bar});
    };
    Parameters p = bothWays();
    p.curvature = 3.5;
    p.edgeLength = 2;
    p.maxIterations = 130;
    ActiveContour contour(darkObject(longGrid(82), dumbbell), {Seed{first, 64.0}}, p);
    runCertified(contour);
    const Certificate c = certify(contour.mesh().compact());
    CHECK(c.components == 2);
    CHECK(c.euler == 4);
    const Components parts = findComponents(contour.mesh());
    CHECK(std::min(parts.volume[0], parts.volume[1]) > 0.9 * 4.0 / 3 * M_PI * 14 * 14 * 14);
  }
}

TEST_CASE("two spheres that merge are one of Euler number 2, also where the surface may shrink") {
  ActiveContour contour(
      ballVolume(), {Seed{kMiddle + Vec3(-5, 0, 0), 3.0}, Seed{kMiddle + Vec3(5, 1, 0), 3.0}}, bothWays());
  CHECK(topologyNumbers(contour.mesh()).euler == 4);
  runCertified(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.components == 1);
  CHECK(c.euler == 2);
}

TEST_CASE("the hole of a torus closes, from Euler number 0 to 2, also where the surface may shrink") {
  std::vector<Seed> seeds;
  for (int i = 0; i < 6; ++i)
    seeds.push_back({kMiddle + 5.5 * Vec3(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0), 1.6});
  Parameters p = bothWays();
  p.edgeLength = 1.4;
  ActiveContour contour(ballVolume(), seeds, p);
  int lowest = 12;
  for (const StepReport& r : runCertified(contour))
    for (const Event& e : r.events) lowest = std::min(lowest, e.after.euler);
  CHECK(lowest <= 0);
  CHECK(certify(contour.mesh().compact()).euler == 2);
  CHECK(contour.stopReason() == StopReason::converged);
}

namespace {

//! From a start of this radius in the lower of the two cubes.
Certificate contractToCubes(double e, double radius, const Parameters& parameters) {
  const Volume volume = darkObject(cubicGrid(41), [e](const Vec3& p) { return overlappingCubes(p, 12, e); });
  return contract(volume, {Seed{kMiddle - Vec3::Constant(6), radius}}, parameters);
}

}  // namespace

TEST_CASE("two cubes with a small overlap end instead of looping") {
  Parameters p = bothWays();
  p.range = IntensityRange{-1000, 110};  // both cubes are the object
  for (double e : {0.0, 0.25, 0.5, 1.0})
    for (double radius : {3.0, 40.0}) {
      CAPTURE(e, radius);
      const Certificate c = contractToCubes(e, radius, p);
      CHECK(c.passes());
      // From around both come as they are: where they only touch, two. From within one the front passes a
      // throat as wide as an edge is long, 2 mm, and none that is narrower.
      const bool hasBoth = radius > 12 || 2 * e >= 2;
      CHECK(c.components == (hasBoth && e == 0 ? 2 : 1));
      CHECK(c.euler == 2 * c.components);
      // Edges rounded to a radius of 1.3 mm, two thirds of an edge of the mesh, cost 3 %; 2.4 are measured.
      const double cube = std::pow(12 + e, 3), overlap = 8 * e * e * e;
      CHECK(c.volume == Approx(hasBoth ? 2 * cube - overlap : cube).epsilon(0.03));
    }
}

TEST_CASE("of two cubes with a small overlap the one that is clicked at is left, whatever the start") {
  for (double e : {0.25, 0.75, 1.0})
    for (double radius : {3.0, 40.0}) {
      CAPTURE(e, radius);
      const Certificate c = contractToCubes(e, radius, bothWays());
      CHECK(c.passes());
      CHECK(c.components == 1);
      CHECK(c.euler == 2);
      // The image cuts it off somewhere in the throat: from -4.4 to 6.7 % are measured.
      CHECK(c.volume == Approx(std::pow(12 + e, 3)).epsilon(0.08));
    }
}

// A fault that is known: of the other cube a scrap of six vertices stays in its far corner. It is split off
// on the way and settles there, although nothing of that cube is the object.
TEST_CASE("a start around two cubes leaves no scrap of the one that is not meant", "[!shouldfail]") {
  CHECK(contractToCubes(0.5, 40, bothWays()).components == 1);
}
