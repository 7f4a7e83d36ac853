// What recording a growth costs: memory for a thousand iterations, time to go back, time of a frame.

#include <cstdio>
#include <ctime>
#include <random>

#include "tests/core/evolution/contour_support.h"
#include "ui/model/snapshot.h"

using namespace handlebody;
using namespace handlebody::testing;
using namespace handlebody::ui;

namespace {

//! A dark tube: the front runs along it for many iterations, and leaves a long wall behind.
ActiveContour longTube() {
  Grid grid;
  grid.size = {45, 45, 1300};
  const Volume volume =
      darkObject(grid, [](const Vec3& p) { return std::hypot(p.x() - 22, p.y() - 22) - 15; });
  Parameters parameters;
  parameters.edgeLength = 2;
  return ActiveContour(volume, {{Vec3(22, 22, 20), 8.0}}, parameters);
}

//! Computing time, not wall-clock time: other programs may use the machine.
template <typename Work>
double seconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("a thousand iterations above 15,000 vertices fit in 500 MB and any is back within 200 ms",
          "[cost]") {
  ActiveContour contour = longTube();
  while (contour.mesh().vertexCount() < 15'000) {
    REQUIRE(contour.stopReason() == StopReason::running);
    contour.step();
  }
  History history(contour);
  const double growing = seconds([&] {
    for (int i = 0; i < 1000; ++i) {
      REQUIRE(history.stopReason() == StopReason::running);
      history.advance();
    }
  });
  std::printf("%d to %d vertices, %.1f ms a step, %zu keyframes, %.0f MB\n", contour.mesh().vertexCount(),
              history.shown().mesh().vertexCount(), growing, history.keyframes(),
              static_cast<double>(history.memory()) / 1048576);
  CHECK(history.memory() < std::size_t{500} << 20);

  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(history.firstIteration(), history.lastIteration());
  double longest = 0, all = 0;
  for (int jump = 0; jump < 50; ++jump) {
    const double t = seconds([&] { history.goTo(any(random)); });
    longest = std::max(longest, t);
    all += t;
  }
  std::printf("going back: %.0f ms on the average, %.0f ms at most\n", 1000 * all / 50, 1000 * longest);
  CHECK(longest < 0.2);

  const double onTheWay = seconds([&] { (void)makeSnapshot(history, Checking::structure); });
  const double atRest = seconds([&] { (void)makeSnapshot(history, Checking::everything); });
  std::printf("a frame of %d vertices: %.1f ms on the way, %.1f ms at rest\n",
              history.shown().mesh().vertexCount(), 1000 * onTheWay, 1000 * atRest);
}
