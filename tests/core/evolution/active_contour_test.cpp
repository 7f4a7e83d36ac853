// The evolution on small volumes: shapes, topology, what every step leaves behind.
#include "core/evolution/active_contour.h"

#include <limits>
#include <random>

#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/mesh/topology.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

TEST_CASE("a ball becomes a sphere of its volume") {
  for (Direction direction : {Direction::outward, Direction::both}) {
    Parameters p;
    p.direction = direction;
    ActiveContour contour(ballVolume(), {Seed{kMiddle, 4.0}}, p);
    runCertified(contour);
    CHECK(contour.stopReason() == StopReason::converged);
    const Certificate c = certify(contour.mesh().compact());
    CHECK(c.passes());
    CHECK(c.genus == std::vector<int>{0});
    CHECK(c.volume == Approx(kBallVolume).epsilon(0.02));
    CHECK(furthestFrom(contour.mesh(), ballDistance) < 0.5);
  }
}

TEST_CASE("a bright object becomes a surface like a dark one") {
  Volume dark = ballVolume();
  const float* values = dark.data<float>();
  const Volume bright =
      volumeByIndex(dark.grid, [&](int i, int j, int k) { return 220 - values[(k * 41 + j) * 41 + i]; });
  ActiveContour contour(bright, {Seed{kMiddle, 4.0}}, {});
  runCertified(contour);
  CHECK(contour.parameters().object == ObjectKind::bright);
  CHECK(volumeOf(contour.mesh()) == Approx(kBallVolume).epsilon(0.02));
}

TEST_CASE("a ball in a background of one value becomes a sphere of its volume") {
  const Volume volume = volumeByDistance(cubicGrid(41), 20, 200, ballDistance);
  ActiveContour contour(volume, {Seed{kMiddle, 4.0}}, {});
  runCertified(contour);
  CHECK(volumeOf(contour.mesh()) == Approx(kBallVolume).epsilon(0.02));
}

TEST_CASE("a torus becomes a torus") {
  ActiveContour contour(torusVolume(), {Seed{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}, {});
  runCertified(contour);
  CHECK(contour.stopReason() == StopReason::converged);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  CHECK(c.genus == std::vector<int>{1});
  CHECK(c.volume == Approx(kTorusVolume).epsilon(0.02));
  CHECK(furthestFrom(contour.mesh(), torusDistance) < 0.6);
}

TEST_CASE("an enclosed ball of background becomes a component of its own") {
  const auto shell = [](const Vec3& p) {
    const double r = (p - kMiddle).norm();
    return std::max(r - 13, 4 - r);
  };
  const Volume volume = darkObject(cubicGrid(41), shell);
  ActiveContour contour(volume, {Seed{kMiddle + Vec3(8.5, 0, 0), 2.5}}, {});
  runCertified(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  CHECK(c.components == 2);
  CHECK(c.genus == std::vector<int>{0, 0});
  CHECK(c.volume == Approx(4.0 / 3 * M_PI * (13.0 * 13 * 13 - 64)).epsilon(0.02));
  const Components parts = findComponents(contour.mesh());
  CHECK(std::min(parts.volume[0], parts.volume[1]) == Approx(-4.0 / 3 * M_PI * 64).epsilon(0.1));
}

TEST_CASE("two seeds in one object merge into one component") {
  ActiveContour contour(ballVolume(),
                        {Seed{kMiddle + Vec3(-5, 0, 0), 3.0}, Seed{kMiddle + Vec3(5, 1, 0), 3.0}}, {});
  CHECK(findComponents(contour.mesh()).count() == 2);
  const auto reports = runCertified(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.components == 1);
  CHECK(c.genus == std::vector<int>{0});
  CHECK(c.volume == Approx(kBallVolume).epsilon(0.02));
  CHECK(countEvents(reports, EventKind::handleInserted) >= 1);
}

TEST_CASE("a ring of seeds in a ball grows together to a torus, whose hole closes") {
  std::vector<Seed> seeds;
  for (int i = 0; i < 6; ++i)
    seeds.push_back({kMiddle + 5.5 * Vec3(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0), 1.6});
  Parameters p;
  p.edgeLength = 1.4;
  ActiveContour contour(ballVolume(), seeds, p);
  REQUIRE(findComponents(contour.mesh()).count() == 6);
  const auto reports = runCertified(contour);
  int highestGenus = 0;
  for (const StepReport& r : reports)
    for (const Event& e : r.events) highestGenus = std::max(highestGenus, e.after.genus);
  CHECK(highestGenus >= 1);
  CHECK(contour.stopReason() == StopReason::converged);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.components == 1);
  CHECK(c.genus == std::vector<int>{0});
  CHECK(c.volume == Approx(kBallVolume).epsilon(0.02));
}

TEST_CASE("seeds in two objects stay two components") {
  const auto twoBalls = [](const Vec3& p) {
    return std::min((p - Vec3(11, 18, 18)).norm(), (p - Vec3(25, 18, 18)).norm()) - 5.5;
  };
  const Volume volume = darkObject(cubicGrid(37), twoBalls);
  ActiveContour contour(volume, {Seed{Vec3(11, 18, 18), {}}, Seed{Vec3(25, 18, 18), {}}}, {});
  runCertified(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  CHECK(c.components == 2);
  CHECK(meanDistance(contour.mesh(), twoBalls) < 0.5);
}

TEST_CASE("one and two threads give the same mesh, bit for bit, and so do two runs") {
  const auto result = [](int threads) {
    Parameters p;
    p.threads = threads;
    p.edgeLength = 1.0;  // enough vertices for two threads to have work
    ActiveContour contour(torusVolume(), {Seed{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}, p);
    while (contour.stopReason() == StopReason::running) contour.step();
    return contour.mesh().compact();
  };
  const TriangleSoup one = result(1), again = result(1), two = result(2);
  REQUIRE(one.points.size() > 1500);
  CHECK((one.points == again.points && one.triangles == again.triangles));
  CHECK((one.points == two.points && one.triangles == two.triangles));
}

TEST_CASE("outward motion never loses volume but for what remeshing takes") {
  struct Case {
    Volume volume;
    Vec3 seed;
    double full;      // mm³
    double bentMost;  // least radius of curvature, mm
  };
  const std::vector<Case> cases{{ballVolume(), kMiddle, kBallVolume, 10},
                                {torusVolume(), kMiddle + Vec3(kTorusR, 0, 0), kTorusVolume, kTorusr}};
  for (const auto& [volume, seed, full, bentMost] : cases) {
    ActiveContour contour(volume, {Seed{seed, 3.0}}, {});
    // A vertex that is taken out of six equilateral faces costs the cone on them, whose height is the sagitta
    // of two edges.
    const double edge = contour.parameters().edgeLength;
    const double oneVertex = 1.5 * std::sqrt(3) * edge * edge * (edge * edge / (2 * bentMost)) / 3;
    double last = countPlainly(contour.mesh().compact()).volume, lost = 0;
    while (contour.stopReason() == StopReason::running) {
      const StepReport report = contour.step();
      CAPTURE(report.iteration, report.volume, last);
      const double now = countPlainly(contour.mesh().compact()).volume;
      CHECK(report.volume == Approx(now).epsilon(1e-11));
      // What grows outweighs that by far; it shows only where the surface has arrived.
      if (last < 0.98 * full) CHECK(now > last);
      CHECK(last - now <= oneVertex);
      lost += std::max(0.0, last - now);
      last = now;
    }
    CHECK(lost <= 2 * oneVertex);  // in the whole run, of which the end has only a few steps that lose
    CHECK(last == Approx(full).epsilon(0.02));
  }
}

TEST_CASE("a surface that starts beyond the boundary goes back to it") {
  Parameters p;
  p.direction = Direction::both;
  p.range = IntensityRange{-1000, 110};
  p.smoothing = 0.5;
  ActiveContour contour(ballVolume(), {Seed{kMiddle + Vec3(7, 0, 0), {}}}, p);
  runCertified(contour);
  CHECK(volumeOf(contour.mesh()) == Approx(kBallVolume).epsilon(0.02));
}

TEST_CASE("anisotropic spacing and an oblique direction give the same shape in mm") {
  Grid grid;
  grid.size = {52, 34, 18};
  grid.spacing = Vec3(0.7, 1, 2);
  grid.direction = Eigen::AngleAxisd(0.5, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  grid.origin = kMiddle - grid.direction * Vec3(26 * 0.7, 17, 18);
  const Volume volume = darkObject(grid, ballDistance);
  ActiveContour contour(volume, {Seed{kMiddle, 4.0}}, {});
  runCertified(contour);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  CHECK(c.genus == std::vector<int>{0});
  CHECK(meanDistance(contour.mesh(), ballDistance) < 0.5 * 0.7);  // half of the finest voxel
}

TEST_CASE("the curvature weight keeps the surface out of a narrow gap") {
  // Two chambers of 14 × 16 × 16 mm, joined by a channel of a radius of one voxel.
  const auto chambers = [](const Vec3& p) {
    const double box =
        std::max(std::abs(p.x() - 11) - 7, std::max(std::abs(p.y() - 16), std::abs(p.z() - 16)) - 8);
    const double other =
        std::max(std::abs(p.x() - 29) - 7, std::max(std::abs(p.y() - 16), std::abs(p.z() - 16)) - 8);
    const double channel = std::hypot(p.y() - 16, p.z() - 16) - 1;
    return std::min({box, other, std::max(channel, std::abs(p.x() - 20) - 8)});
  };
  Grid grid = cubicGrid(33);
  grid.size[0] = 41;
  Parameters p;
  p.range = IntensityRange{-1000, 110};
  p.smoothing = 0;
  p.edgeLength = 1.5;
  const Volume volume = darkObject(grid, chambers);
  const auto grown = [&](double curvature) {
    p.curvature = curvature;
    ActiveContour contour(volume, {Seed{Vec3(11, 16, 16), 4.0}}, p);
    runCertified(contour);
    CHECK(contour.stopReason() == StopReason::converged);
    return contour.mesh().compact();
  };
  const auto furthest = [](const TriangleSoup& mesh) {
    double x = 0;
    for (const Vec3& q : mesh.points) x = std::max(x, q.x());
    return x;
  };
  constexpr double kFront = 3;  // mm, the radius that the weight of 2 holds (MotionSettings::curvature)
  // A chamber is filled but for its edges, rounded to that radius at the most.
  const double chamber = 14 * 16 * 16, edges = 4 * (14 + 16 + 16);
  const double rounded = (1 - M_PI / 4) * kFront * kFront * edges;
  const TriangleSoup held = grown(2), free = grown(0.2);
  CHECK(furthest(held) < 22);
  CHECK(countPlainly(held).volume > chamber - rounded);
  CHECK(countPlainly(held).volume < 1.02 * chamber);
  // It is the weight that keeps it out: with the usual one it fills both.
  CHECK(furthest(free) > 35.5);
  CHECK(countPlainly(free).volume > 2 * (chamber - rounded));
}

TEST_CASE("random seeds, weights and edge lengths never break the mesh") {
  for (unsigned n = 1; n <= 6; ++n) {
    CAPTURE(n);
    std::mt19937 random(n);
    const auto part = [&] { return static_cast<double>(random() % 1000) / 1000; };
    Parameters p;
    p.edgeLength = 1.2 + 1.5 * part();
    p.curvature = part();
    p.balloon = 0.3 + 2 * part();
    p.direction = n % 2 == 0 ? Direction::both : Direction::outward;
    p.maxIterations = 60;
    std::vector<Seed> seeds;
    for (int s = 0; s < 3; ++s) {
      const double u = 6.28 * part();
      seeds.push_back({kMiddle + kTorusR * Vec3(std::cos(u), std::sin(u), 0), {}});
    }
    ActiveContour contour(torusVolume(), seeds, p);
    runCertified(contour);
    CHECK(certify(contour.mesh().compact()).passes());
  }
}

namespace {

//! White noise with a hollow of 7 voxels in the middle.
Volume noiseAroundHollow(int side, unsigned seed) {
  std::mt19937 random(seed);
  return volumeByIndex(cubicGrid(side), [&](int i, int j, int k) {
    const int away = std::max({std::abs(i - side / 2), std::abs(j - side / 2), std::abs(k - side / 2)});
    const double noise = static_cast<double>(random() % 1000) / 1000;
    return away <= 3 ? 0 : noise;
  });
}

}  // namespace

TEST_CASE("a run that leaks through noise leaves no needles") {
  for (const unsigned seed : {1u, 3u, 8u}) {
    CAPTURE(seed);
    Parameters p;
    p.range = IntensityRange{-10, 0.5};
    p.smoothing = 1.2;
    p.maxIterations = 400;
    ActiveContour contour(noiseAroundHollow(28, seed), {Seed{Vec3::Constant(14), 2.0}}, p);
    int events = 0;
    while (contour.stopReason() == StopReason::running) {
      events += static_cast<int>(contour.step().events.size());
      REQUIRE(leastAltitude(contour.mesh()) > 0.002 * contour.parameters().edgeLength);
    }
    CHECK(events > 100);
    CHECK(certify(contour.mesh().compact()).passes());
  }
}
