// Discs as walls.
#include "core/evolution/wall_disc.h"

#include <random>

#include "core/errors.h"
#include "core/evolution/walls.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

Constraints behind(std::vector<WallDisc> discs) { return {{{}, {}, {}, std::move(discs)}, {}, {}}; }

//! True if a face has a point in common with the disc: the segment that it leaves in the disc's plane comes
//! nearer to the middle than the radius. A formula of its own.
bool crosses(const Mesh& mesh, const WallDisc& disc) {
  const Vec3 n = disc.normal.normalized();
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    std::vector<Vec3> cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.position(t[k]), &b = mesh.position(t[(k + 1) % 3]);
      const double x = (a - disc.centre).dot(n), y = (b - disc.centre).dot(n);
      if (x == 0) cut.push_back(a);
      if (x * y < 0) cut.push_back(a + x / (x - y) * (b - a));
    }
    if (cut.size() < 2) continue;
    const Vec3 along = cut[1] - cut[0];
    const double l = along.squaredNorm();
    const double s = l > 0 ? std::clamp((disc.centre - cut[0]).dot(along) / l, 0.0, 1.0) : 0;
    if ((cut[0] + s * along - disc.centre).norm() <= disc.radius) return true;
  }
  return false;
}

void expectKeepsOut(ActiveContour& contour) {
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    INFO("iteration " << contour.iteration());
    REQUIRE(contour.iteration() < 2000);
    REQUIRE(certify(contour.mesh().compact()).passes());
    for (const WallDisc& disc : contour.constraints().walls.discs)
      REQUIRE_FALSE(crosses(contour.mesh(), disc));
  }
}

}  // namespace

TEST_CASE("how far points and triangles are from a disc is what a fine sampling of it says", "[walls]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-3, 3);
  const auto place = [&] {
    const double x = u(random), y = u(random);
    return Vec3(x, y, u(random));
  };
  for (int i = 0; i < 40; ++i) {
    const WallDisc disc{place(), place(), 0.2 + std::abs(u(random))};
    const DiscShape shape(disc);
    const Vec3 n = disc.normal.normalized(), e = n.unitOrthogonal(), f = n.cross(e), p = place();
    const std::array<Vec3, 3> t{place(), place(), place()};
    double toPoint = 1e300, toTriangle = 1e300;
    for (int r = 0; r <= 40; ++r)
      for (int a = 0; a < 120; ++a) {
        const double angle = a * 2 * 3.14159265358979 / 120, radius = disc.radius * r / 40;
        const Vec3 q = disc.centre + radius * (std::cos(angle) * e + std::sin(angle) * f);
        toPoint = std::min(toPoint, (p - q).norm());
        toTriangle = std::min(toTriangle, bruteDistance(q, t[0], t[1], t[2]));
      }
    const double coarse = 0.06 * disc.radius + 1e-9;
    CHECK(shape.distance(p) <= toPoint + 1e-9);
    CHECK(shape.distance(p) >= toPoint - coarse);
    CHECK_FALSE(shape.clears(t, toTriangle + coarse));
    if (toTriangle > 2 * coarse) CHECK(shape.clears(t, toTriangle - 2 * coarse));
    if (toTriangle > 2 * coarse) CHECK_FALSE(shape.meets(t));
    CHECK((shape.meets(t) || shape.clears(t, 0)));
  }
}

TEST_CASE("a surface never passes discs, whatever their place: in it, across it, oblique, tiny", "[walls]") {
  for (const Direction direction : {Direction::outward, Direction::both}) {
    Parameters p;
    p.direction = direction;
    ActiveContour contour(ballVolume(), {Seed{kMiddle - Vec3(4, 4, 0), 3.0}}, p,
                          behind({{kMiddle + Vec3(3, 0, 0), {1, 0, 0}, 20.0},
                                  {kMiddle - Vec3(6, 0, 5), {0.3, -1, 2}, 2.0},
                                  {kMiddle - Vec3(2, -6, 0), {1, 1, 1}, 0.05}}));
    expectKeepsOut(contour);
    // Fronts that meet again behind a disc may come to rest for good.
    CHECK((contour.stopReason() == StopReason::converged || contour.stopReason() == StopReason::frozen));
    double furthest = 0;
    for (const Vec3& q : contour.mesh().compact().points) furthest = std::max(furthest, q.x());
    CHECK(furthest < kMiddle.x() + 3);
    CHECK(furthest > kMiddle.x() + 2);
  }
}

TEST_CASE("a disc that makes no sense is refused with one sentence", "[walls]") {
  const auto refused = [](const WallDisc& disc, const std::string& words) {
    const std::string message = messageOf([&] {
      ActiveContour(ballVolume(), {Seed{kMiddle, 4.0}}, {}, behind({disc}));
    });
    INFO(message);
    CHECK(message.find(words) != std::string::npos);
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
  };
  refused({kMiddle, {1, 0, 0}, 2.0}, "lies over the seed");
  refused({kMiddle + Vec3(0.2, 0, 0), {1, 0, 0}, 2.0}, "no room");
  refused({Vec3(60, 20, 20), {1, 0, 0}, 2.0}, "outside of the volume");
  refused({kMiddle + Vec3(6, 0, 0), {0, 0, 0}, 2.0}, "normal of no length");
  refused({kMiddle + Vec3(6, 0, 0), {1, 0, 0}, 0.0}, "no radius");
  refused({kMiddle + Vec3(6, 0, 0), {1, 0, 0}, std::numeric_limits<double>::infinity()}, "no radius");
}

TEST_CASE("a disc across the surface is refused, whatever the direction, and nothing has changed then",
          "[walls]") {
  for (const Direction direction : {Direction::outward, Direction::both}) {
    Parameters p;
    p.direction = direction;
    const Seed seed{kMiddle, 4.0};
    ActiveContour contour(ballVolume(), {seed}, p);
    while (contour.stopReason() == StopReason::running) contour.step();
    const Mesh before = contour.mesh();
    for (const double x : {0.0, 9.0}) {
      const std::string message = messageOf([&] {
        contour.change({{seed}, p, behind({{kMiddle + Vec3(x, 0, 0), {1, 0, 0}, x > 0 ? 30.0 : 2.0}})});
      });
      INFO(message);
      CHECK(message.find("surface") != std::string::npos);
      CHECK(isSame(contour.mesh(), before));
      CHECK(contour.constraints().empty());
    }
  }
}

TEST_CASE("a disc that goes sets the surface free, and another run is the same bit for bit", "[walls]") {
  const Constraints walled = behind({{kMiddle + Vec3(3, 0, 0), {1, 0, 0}, 20.0}});
  const Seed seed{kMiddle - Vec3(4, 0, 0), 3.0};
  const auto run = [&](int threads) {
    Parameters p;
    p.threads = threads;
    ActiveContour contour(ballVolume(), {seed}, p, walled);
    while (contour.stopReason() == StopReason::running) contour.step();
    return contour;
  };
  ActiveContour contour = run(1);
  CHECK(contour.stopReason() == StopReason::converged);
  CHECK(isSame(contour.mesh(), run(2).mesh()));
  const double held = volumeOf(contour.mesh());
  contour.change({{seed}, {}, {}});
  while (contour.stopReason() == StopReason::running) contour.step();
  CHECK(volumeOf(contour.mesh()) > 1.2 * held);
}
