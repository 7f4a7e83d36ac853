// The locally adaptive mesh: how long edges may be, and what comes of it.
#include <algorithm>
#include <random>

#include "core/evolution/size_field.h"
#include "core/evolution/wall_guard.h"
#include "core/mesh/quality.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const Vec3 kCentre(30, 30, 30);
constexpr double kRadius = 25;

double wideBall(const Vec3& p) { return (p - kCentre).norm() - kRadius; }
//! The same with a bright needle of radius 2 through it.
double piercedBall(const Vec3& p) {
  const Vec3 q = p - kCentre;
  return std::max(wideBall(p), 2 - std::hypot(q.x() - 12, q.y()));
}

Volume wideVolume(double (*distance)(const Vec3&)) { return darkObject(cubicGrid(61), distance); }

Parameters with(Resolution resolution) {
  Parameters p;
  p.resolution = resolution;
  return p;
}

ActiveContour grown(const Volume& volume, const Parameters& p) {
  ActiveContour contour(volume, {{kCentre - Vec3(5, 0, 0), 4.0}}, p);
  while (contour.stopReason() == StopReason::running) contour.step();
  return contour;
}

double longestEdge(const Mesh& mesh) { return meshQuality(mesh.compact()).edges.largest; }

}  // namespace

TEST_CASE("edges may be longer only where no boundary is near, and change slowly from place to place") {
  const Volume volume = wideVolume(piercedBall);
  const ObjectImage image(std::make_shared<SmoothedVolume>(volume, 0), {-1e300, 110}, 90);
  constexpr double kEdge = 2;
  const Vec3 start = kCentre - Vec3(0, 18, 0);
  const SizeField sizes(image, {start}, kEdge);
  CHECK(sizes.at(kCentre - Vec3(6, 0, 0)) == Approx(SizeField::kLongest));
  for (const double away : {0., 1., 4., 8.})  // trilinear between cells of an edge length: a diagonal away
    CHECK(sizes.at(start + Vec3(0, away, 0)) <= std::max(1.0, SizeField::kRound * (away / kEdge + 1.73)));
  CHECK(sizes.at(kCentre - Vec3(kRadius - 1, 0, 0)) == 1);
  CHECK(sizes.at(kCentre + Vec3(8.5, 0, 0)) == 1);  // beside the needle
  CHECK(sizes.at(kCentre + Vec3(100, 0, 0)) == 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 60);
  int longer = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    const Vec3 p(x, y, z), q = p + Vec3(z - 30, x - 30, y - 30).normalized() * (0.2 + 0.05 * x);
    const double size = sizes.at(p);
    if (size > 1) REQUIRE(piercedBall(p) < -0.3 * size * kEdge);  // more than a step
    longer += size > 1;
    REQUIRE(std::abs(size - sizes.at(q)) <= 1.2 * SizeField::kRound * (p - q).norm() / kEdge + 1e-6);
  }
  CHECK(longer > 1000);
}

TEST_CASE("an adaptive surface ends where a uniform one does, as fine and as even, in fewer iterations") {
  for (auto* distance : {wideBall, piercedBall}) {
    const Volume volume = wideVolume(distance);
    const ActiveContour uniform = grown(volume, with(Resolution::uniform));
    ActiveContour adaptive(volume, {{kCentre - Vec3(5, 0, 0), 4.0}}, with(Resolution::adaptive));
    runCertified(adaptive);
    CHECK(adaptive.stopReason() == StopReason::converged);
    CHECK(topologyNumbers(adaptive.mesh()) == topologyNumbers(uniform.mesh()));
    CHECK(adaptive.iteration() < uniform.iteration());
    CHECK(meanDistance(adaptive.mesh(), distance) < 1.1 * meanDistance(uniform.mesh(), distance));
    const MeshQuality a = meshQuality(adaptive.mesh().compact()), u = meshQuality(uniform.mesh().compact());
    CHECK(a.edges.largest <= 1.02 * u.edges.largest);
    CHECK(a.edges.median == Approx(u.edges.median).epsilon(0.06));
    CHECK(a.angles.percent5 > u.angles.percent5 - 2);
    CHECK(std::abs(adaptive.mesh().vertexCount() - uniform.mesh().vertexCount()) <
          0.1 * uniform.mesh().vertexCount());
  }
}

TEST_CASE("an adaptive surface is coarse while it crosses a wide inside") {
  const Volume volume = wideVolume(wideBall);
  ActiveContour contour(volume, {{kCentre, 4.0}}, with(Resolution::adaptive));
  const double fine = 1.4 * contour.parameters().edgeLength;
  double longest = 0;
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    longest = std::max(longest, longestEdge(contour.mesh()));
  }
  CHECK(longest > 1.8 * fine);
  CHECK(longestEdge(contour.mesh()) <= 1.001 * fine);
}

TEST_CASE("an adaptive surface is the same bit for bit on two threads, and when it is made again") {
  const Volume volume = wideVolume(piercedBall);
  Parameters p = with(Resolution::adaptive);
  const ActiveContour one = grown(volume, p), again = grown(volume, p);
  p.threads = 2;
  const ActiveContour two = grown(volume, p);
  CHECK(isSame(one.mesh(), again.mesh()));
  CHECK(isSame(one.mesh(), two.mesh()));
}

TEST_CASE("a small seed in a wide inside grows") {
  const Volume volume = wideVolume(wideBall);
  ActiveContour contour(volume, {{kCentre, 0.5}}, with(Resolution::adaptive));
  while (contour.stopReason() == StopReason::running) contour.step();
  CHECK(meanDistance(contour.mesh(), wideBall) < 0.2);
}

TEST_CASE(
    "a seed in a wide inside keeps its volume, and grows as a uniform one does also where curvature counts") {
  const Volume volume = wideVolume(wideBall);
  for (const double curvature : {0.2, 1.0, 2.0}) {
    Parameters p = with(Resolution::adaptive);
    p.curvature = curvature;
    ActiveContour contour(volume, {{kCentre, std::nullopt}}, p);
    double last =
        0.99 * signedVolume(contour.mesh());  // the faces of a sphere lie within it, longer ones more
    while (contour.stopReason() == StopReason::running) {
      const double now = contour.step().volume;
      REQUIRE(now > 0.99 * last);
      last = now;
    }
    CHECK(last == Approx(4. / 3 * 3.14159265 * kRadius * kRadius * kRadius).epsilon(0.03));
  }
}

TEST_CASE("walls and pins that come on the way make the surface fine again, and hold") {
  const Volume volume = wideVolume(wideBall);
  ActiveContour contour(volume, {{kCentre, 4.0}}, with(Resolution::adaptive));
  for (int i = 0; i < 7; ++i) contour.step();
  const double fine = 1.4 * contour.parameters().edgeLength;
  CHECK(longestEdge(contour.mesh()) > 1.5 * fine);
  Request request = contour.request();
  request.constraints.walls.balls.push_back({kCentre + Vec3(17, 0, 0), 3.0});
  contour.change(request);
  CHECK(longestEdge(contour.mesh()) <= fine);
  runCertified(contour);
  CHECK(contour.stopReason() == StopReason::converged);
  CHECK(isFree(contour.mesh(), request.constraints.walls, volume.grid));
}

TEST_CASE("left to itself the resolution is adaptive where the object is wide for its edges") {
  CHECK(Parameters().resolution == Resolution::automatic);
  const Volume volume = wideVolume(wideBall);
  Parameters p;
  const auto used = [&] { return ActiveContour(volume, {{kCentre, 4.0}}, p).parameters().resolution; };
  p.edgeLength = kRadius / 10;
  CHECK(used() == Resolution::adaptive);
  p.edgeLength = kRadius / 5;
  CHECK(used() == Resolution::uniform);
  p.edgeLength = kRadius / 10;
  Parameters asked = p;
  asked.resolution = Resolution::adaptive;
  CHECK(isSame(grown(volume, p).mesh(), grown(volume, asked).mesh()));
}

TEST_CASE("what is automatic is uniform with walls, and adaptive again when they are taken down") {
  const Volume volume = wideVolume(wideBall);
  Parameters p;
  p.edgeLength = kRadius / 10;
  ActiveContour contour(volume, {{kCentre, 4.0}}, p);
  CHECK(contour.parameters().resolution == Resolution::adaptive);
  Request request = contour.request();
  request.constraints.walls.balls.push_back({kCentre + Vec3(17, 0, 0), 3.0});
  contour.change(request);
  CHECK(contour.parameters().resolution == Resolution::uniform);
  request.constraints.walls.balls.clear();
  contour.change(request);
  CHECK(contour.parameters().resolution == Resolution::adaptive);
}
