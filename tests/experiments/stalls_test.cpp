// Noise in the range of the object, fronts that meet everywhere and flat: no step may stall.

#include <ctime>

#include "core/cancellation.h"
#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

struct Stall {
  const char* name;
  const char* phantom;
  double spacing, noise, high, curvature, edgeLength;
};

const std::vector<Stall> kStalls{
    {"a plate that leaks into noise", "plate", 2, 0.2, 183, 0.49, 4},
    {"balls in noise, a fine mesh", "balls", 2, 0.2, 150, 1.0, 1.9},
    {"a noisy gyroid, little curvature", "gyroid", 2, 0.3, 130, 0.1, 2.3},
};

double secondsOfThread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

ActiveContour contourOf(const Stall& stall) {
  PhantomOptions options;
  options.spacing = Vec3::Constant(stall.spacing);
  options.noise = stall.noise;
  const Phantom phantom = makePhantom(stall.phantom, options);
  Parameters parameters;
  parameters.range = IntensityRange{-std::numeric_limits<double>::infinity(), stall.high};
  parameters.curvature = stall.curvature;
  parameters.edgeLength = stall.edgeLength;
  parameters.maxIterations = 80;
  return ActiveContour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, parameters);
}

}  // namespace

TEST_CASE("no step stalls where fronts meet everywhere, and the mesh is certified", "[stalls]") {
  const Stall stall = GENERATE(from_range(kStalls));
  INFO(stall.name);
  ActiveContour contour = contourOf(stall);
  double worst = 0;
  const double start = secondsOfThread();
  while (contour.stopReason() == StopReason::running) {
    const double before = secondsOfThread();
    contour.step();
    worst = std::max(worst, secondsOfThread() - before);
  }
  const double whole = secondsOfThread() - start;
  std::cout << stall.name << ": iterations " << contour.iteration() << ", vertices "
            << contour.mesh().vertexCount() << ", " << whole << " s, worst step " << worst << " s\n";
  CHECK(certify(contour.mesh().compact()).passes());
  CHECK(contour.mesh().vertexCount() > 1000);
  CHECK(worst < 2);  // on a busy machine; the bound is one of work, not of time
}
