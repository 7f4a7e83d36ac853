// Walls: where the surface may not go.
#include "core/evolution/walls.h"

#include <random>

#include "core/errors.h"
#include "core/evolution/history.h"
#include "core/indices.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const Seed kTorusSeed{kMiddle + Vec3(kTorusR, 0, 0), 3.0};

Constraints behind(std::vector<WallBall> balls, std::optional<WallMap> map = {}) {
  return {{std::move(balls), std::move(map)}, {}, {}};
}

//! Steps to the end; no mesh on the way may have a point in a wall.
void expectKeepsOut(ActiveContour& contour) {
  const WallList walls = contour.constraints().walls;
  const double start = volumeOf(contour.mesh());
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    INFO("iteration " << contour.iteration());
    REQUIRE(contour.iteration() < 2000);
    REQUIRE(certify(contour.mesh().compact()).passes());
    if (!walls.balls.empty()) REQUIRE(clearance(contour.mesh(), walls.balls) > 0);
    if (walls.map) REQUIRE_FALSE(entersMap(contour.mesh(), *walls.map, contour.grid()));
  }
  CHECK(volumeOf(contour.mesh()) > start);
}

}  // namespace

TEST_CASE("which walls a triangle touches is what every wall by itself says", "[walls]") {
  Grid grid = cubicGrid(30);
  grid.spacing = Vec3(0.8, 1, 1.7);
  grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  std::mt19937 random(5);
  const auto place = [&] {
    std::uniform_real_distribution<double> u(-1, 30);
    const double x = u(random), y = u(random);
    return grid.toWorld(Vec3(x, y, u(random)));
  };
  WallList list;
  for (int i = 0; i < 200; ++i)
    list.balls.push_back({place(), std::uniform_real_distribution<double>(0.1, 4)(random)});
  const Walls walls(list, grid, 1.5, 0.4);
  int touched = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = place(), b = a + 0.1 * (place() - a), c = a + 0.1 * (place() - a);
    std::vector<int> expected;
    for (std::size_t w = 0; w < list.balls.size(); ++w)
      if (bruteDistance(list.balls[w].centre, a, b, c) <= list.balls[w].radius)
        expected.push_back(static_cast<int>(w));
    Walls::Touched which;
    CHECK(walls.touches(a, b, c, &which) == !expected.empty());
    sortUnique(which.balls);
    CHECK(which.balls == expected);
    if (!expected.empty()) CHECK((walls.isNear(a) && !walls.clears(a, b, c)));
    touched += !expected.empty();
  }
  CHECK((touched > 50 && touched < 950));
}

TEST_CASE("long faces that come from far away meet the few walls that they touch", "[walls]") {
  Grid grid = cubicGrid(60);
  grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-2, 61), part(-1, 1);
  const auto place = [&] { return grid.toWorld(Vec3(u(random), u(random), u(random))); };
  const auto away = [&](double mm) { return Vec3(mm * Vec3(part(random), part(random), part(random))); };
  WallList list;
  for (int i = 0; i < 8; ++i) list.balls.push_back({place(), 1.0 + 0.3 * i});
  const Walls walls(list, grid, 4, 0.4);
  int touched = 0, far = 0;
  for (int i = 0; i < 4000; ++i) {
    const WallBall& w = list.balls[static_cast<std::size_t>(i) % list.balls.size()];
    const Vec3 a = w.centre + away(14), b = w.centre + away(w.radius + 2), c = a + away(4);
    const bool expected = std::any_of(list.balls.begin(), list.balls.end(), [&](const WallBall& ball) {
      return bruteDistance(ball.centre, a, b, c) <= ball.radius;
    });
    CHECK(walls.touches(a, b, c) == expected);
    touched += expected;
    far += expected && (a - w.centre).norm() > w.radius + 8;
  }
  CHECK((touched > 500 && far > 100));
}

TEST_CASE("a surface grows around walls, small and large, and never has a point in one", "[walls]") {
  for (const Direction direction : {Direction::outward, Direction::both}) {
    Parameters p;
    p.direction = direction;
    // Far smaller than a step, an edge, several edges; across the whole tube; over the boundary.
    ActiveContour contour(torusVolume(), {kTorusSeed}, p,
                          behind({{kMiddle + Vec3(0, kTorusR, 0), 0.02},
                                  {kMiddle + Vec3(7, 9, 0), 1.0},
                                  {kMiddle + Vec3(-kTorusR, 0, 0), 3.0},
                                  {kMiddle + Vec3(0, -kTorusR, 0), 7.5},
                                  {kMiddle + Vec3(-9, 9, 5), 2.5}}));
    expectKeepsOut(contour);
    CHECK(contour.stopReason() == StopReason::converged);
    const Certificate c = certify(contour.mesh().compact());
    // The wall across the tube opens the torus; each wall in the tube leaves a cavity.
    CHECK(std::count(c.genus.begin(), c.genus.end(), 0) == c.components);
    CHECK(c.components >= 2);
  }
}

TEST_CASE("a wall of one voxel holds, straight or oblique, and is nearly reached", "[walls]") {
  const Volume volume = ballVolume();
  const auto straight = [](int i, int, int) { return i == 23; };
  const auto oblique = [](int i, int j, int k) { return i + j + k == 66; };  // voxels that touch at corners
  for (const bool isStraight : {true, false}) {
    const WallMap map = wallMap(
        volume.grid, [&](int i, int j, int k) { return isStraight ? straight(i, j, k) : oblique(i, j, k); });
    ActiveContour contour(volume, {Seed{kMiddle - Vec3(4, 4, 0), 3.0}}, {}, behind({}, map));
    expectKeepsOut(contour);
    double furthest = 0;
    for (const Vec3& p : contour.mesh().compact().points)
      furthest = std::max(furthest, isStraight ? p.x() : p.sum());
    CHECK(furthest < (isStraight ? 22.5 : 66.0));
    CHECK(furthest > (isStraight ? 22.2 : 63.0));
  }
}

TEST_CASE("walls far away change nothing, and the mesh does not depend on the threads", "[walls]") {
  const Volume volume = darkObject(cubicGrid(61), torusDistance);
  const auto run = [&](const Constraints& constraints, int threads) {
    Parameters p;
    p.threads = threads;
    ActiveContour contour(volume, {kTorusSeed}, p, constraints);
    while (contour.stopReason() == StopReason::running) contour.step();
    return contour.mesh();
  };
  const Mesh free = run({}, 1), far = run(behind({{Vec3(58, 58, 58), 1.0}}), 1);
  CHECK(isSame(free, far));
  const Constraints near = behind({{kMiddle + Vec3(0, kTorusR, 0), 2.0}});
  CHECK(isSame(run(near, 1), run(near, 2)));
  CHECK_FALSE(isSame(run(near, 1), free));
}

TEST_CASE("a wall that makes no sense is refused with one sentence", "[walls]") {
  const auto refused = [](const Constraints& constraints, const std::string& words) {
    const std::string message = messageOf([&] {
      ActiveContour(ballVolume(), {Seed{kMiddle, 4.0}}, {}, constraints);
    });
    INFO(message);
    CHECK(message.find(words) != std::string::npos);
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
  };
  refused(behind({{kMiddle + Vec3(1, 0, 0), 2.0}}), "lies over the seed");
  refused(behind({{Vec3(60, 20, 20), 2.0}}), "outside of the volume");
  refused(behind({{kMiddle, -1.0}}), "no radius");
  refused(behind({{kMiddle, std::numeric_limits<double>::quiet_NaN()}}), "no radius");
  refused(behind({}, wallMap(cubicGrid(7), [](int, int, int) { return true; })), "not the volume's size");
  refused(behind({}, WallMap{"x.mha", {}, nullptr}), "not been read");
  refused(
      behind({}, wallMap(cubicGrid(41), [](int i, int j, int k) { return i == 20 && j == 20 && k == 20; })),
      "lies over the seed");
}

TEST_CASE("a seed is made smaller where a wall is near", "[walls]") {
  for (const Direction direction : {Direction::outward, Direction::both}) {
    Parameters p;
    p.direction = direction;
    ActiveContour contour(ballVolume(), {Seed{kMiddle, 6.0}}, p, behind({{kMiddle + Vec3(5, 0, 0), 1.5}}));
    CHECK(contour.parameters().seeds[0].radius < 3.5);
    expectKeepsOut(contour);
  }
}

TEST_CASE("a wall that comes on the way holds from there on, and one that goes sets the surface free",
          "[walls]") {
  const WallBall wall{kMiddle + Vec3(-kTorusR, 0, 0), 7.5};
  ActiveContour contour(torusVolume(), {kTorusSeed}, {});
  for (int i = 0; i < 10; ++i) contour.step();
  const Mesh before = contour.mesh();
  contour.change({{kTorusSeed}, {}, behind({wall})});
  CHECK(isSame(contour.mesh(), before));
  contour.changeParameters({});
  CHECK(contour.constraints().walls.balls.size() == 1);
  expectKeepsOut(contour);
  CHECK(certify(contour.mesh().compact()).genus == std::vector<int>{0});
  const double held = volumeOf(contour.mesh());
  contour.change({{kTorusSeed}, {}, {}});
  while (contour.stopReason() == StopReason::running) contour.step();
  CHECK(certify(contour.mesh().compact()).genus == std::vector<int>{1});
  CHECK(volumeOf(contour.mesh()) > 1.1 * held);
}

TEST_CASE("a wall over the surface is refused, and nothing has changed then", "[walls]") {
  ActiveContour contour(torusVolume(), {kTorusSeed}, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  const Mesh before = contour.mesh();
  const auto refused = [&](const WallBall& wall, const std::string& words) {
    const std::string message = messageOf([&] { contour.change({{kTorusSeed}, {}, behind({wall})}); });
    INFO(message);
    CHECK(message.find(words) != std::string::npos);
    CHECK(isSame(contour.mesh(), before));
    CHECK(contour.constraints().empty());
  };
  refused({kMiddle + Vec3(-kTorusR, 0, 6), 2.0}, "over surface that is already there");
  refused({kMiddle + Vec3(-kTorusR, 0, 0), 2.0}, "within the surface");
}

TEST_CASE("where the surface may shrink it is pushed out of a wall that is put over it", "[walls]") {
  Parameters p;
  p.direction = Direction::both;
  const WallBall over{kMiddle + Vec3(9, 0, 0), 3.0}, free{kMiddle + Vec3(-13, 0, 0), 2.0};
  ActiveContour contour(ballVolume(), {Seed{kMiddle, 4.0}}, p);
  while (contour.stopReason() == StopReason::running) contour.step();
  contour.change({{Seed{kMiddle, 4.0}}, p, behind({over, free})});
  CHECK(clearance(contour.mesh(), {over}) < 0);
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    REQUIRE(certify(contour.mesh().compact()).passes());
    REQUIRE(clearance(contour.mesh(), {free}) > 0);
  }
  CHECK(clearance(contour.mesh(), {over}) > 0);
  CHECK(contour.warnings(contour.support()).empty());
}

TEST_CASE("the history finds where a wall was free, and goes on from there", "[walls][history]") {
  const Seed seed = kTorusSeed;
  const WallBall wall{kMiddle + Vec3(-kTorusR, 0, 0), 2.0}, seeded{seed.centre, 1.0};
  History history(ActiveContour(torusVolume(), {seed}, {}));
  while (history.stopReason() == StopReason::running) history.advance();
  const int last = history.lastIteration();
  const std::optional<int> free = history.lastFree({{wall}, {}});
  REQUIRE(free.has_value());
  CHECK((*free > 5 && *free < last));
  CHECK(history.iteration() == last);
  CHECK_FALSE(history.lastFree({{seeded}, {}}).has_value());

  ActiveContour straight(torusVolume(), {seed}, {});
  while (straight.iteration() < *free) straight.step();
  CHECK(clearance(straight.mesh(), {wall}) > 0);
  ActiveContour next = straight;
  next.step();
  CHECK(clearance(next.mesh(), {wall}) <= 0);

  history.goTo(*free);
  history.change({{seed}, {}, behind({wall})});
  straight.change({{seed}, {}, behind({wall})});
  while (history.stopReason() == StopReason::running) history.advance();
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(history.shown().mesh(), straight.mesh()));
  CHECK(clearance(straight.mesh(), {wall}) > 0);
  REQUIRE(history.changes().size() == 1);
  CHECK(history.changes()[0].constraints == behind({wall}));
  CHECK_FALSE(history.changes()[0].seeds.has_value());
}
