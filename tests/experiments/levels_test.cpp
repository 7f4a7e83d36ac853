// What makes the object's boundary hard to place: a gain that changes over the volume, strong speckle, and
// holes in a wall.

#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! Converged, certified, of the right topology, and a Dice coefficient of at least `dice`.
void expectOverlap(const std::string& name, const PhantomOptions& options, double dice, const char* what) {
  const Phantom phantom = makePhantom(name, options);
  const Outcome o = grow(phantom);
  CHECK(o.stop == StopReason::converged);
  CHECK(o.certificate.passes());
  CHECK(sorted(o.certificate.genus) == sorted(phantom.genus));
  const double found = overlap(phantom, o.mesh).dice;
  CHECK(found >= dice);
  std::cout << name << ' ' << what << ": Dice " << found << '\n';
}

void expectWithBias(const std::string& name, double bias, double dice) {
  INFO(name << ", bias " << bias);
  PhantomOptions options;
  options.bias = bias;
  expectOverlap(name, options, dice, "with a gain that changes");
}

//! Volume of the surface in that of the seeded chamber: 1 = held at the gap, about 2 = leaked through it.
double chambersFilled(double gapVoxels, Parameters parameters) {
  PhantomOptions options;
  options.gapVoxels = gapVoxels;
  const Phantom phantom = makePhantom("wall", options);
  const Outcome o = growWith(phantom, parameters);
  CHECK(o.certificate.passes());
  CHECK(sorted(o.certificate.genus) == sorted(phantom.genus));
  const double filled = o.certificate.volume / overlap(phantom, o.mesh).truthVolume;
  std::cout << "wall, gap " << gapVoxels << ", curvature " << parameters.curvature << ": " << filled
            << " chambers\n";
  return filled;
}

}  // namespace

TEST_CASE("a gain that changes by 2.6 over the volume leaves topology and accuracy as they are",
          "[experiments][bias]") {
  for (const char* name : {"genus3", "torus", "cyst"}) expectWithBias(name, 2.6, 0.985);
  expectWithBias("cube", 2.6, 0.975);  // its edges are rounded
}

TEST_CASE("a gain that changes by 5.5 over the volume leaves topology and accuracy as they are",
          "[experiments][bias]") {
  for (const char* name : {"genus3", "torus"}) expectWithBias(name, 5.5, 0.985);
}

TEST_CASE("the cyst is found in speckle of half its contrast", "[experiments][bias]") {
  PhantomOptions options;
  options.noise = 0.5;
  expectOverlap("cyst", options, 0.98, "with noise 0.5");
}

TEST_CASE("with nothing told the surface is held at a hole of one to six voxels", "[experiments][gap]") {
  for (double gap : {1.0, 2.0, 3.0, 4.0, 6.0}) {
    INFO("gap " << gap);
    CHECK(chambersFilled(gap, {}) == Approx(1).margin(0.02));
  }
}

TEST_CASE(
    "where the range is given more curvature holds the surface at wider holes, and less lets it through",
    "[experiments][gap]") {
  struct Case {
    double gapVoxels, leaks, holds;  // curvature
  };
  for (const Case& c : {Case{2, 0.4, 0.8}, Case{3, 0.8, 1.0}, Case{4, 1.0, 1.3}}) {
    INFO("gap " << c.gapVoxels);
    Parameters parameters;
    parameters.range = IntensityRange{-1e9, 120};
    parameters.curvature = c.leaks;
    CHECK(chambersFilled(c.gapVoxels, parameters) > 1.5);
    parameters.curvature = c.holds;
    CHECK(chambersFilled(c.gapVoxels, parameters) == Approx(1).margin(0.02));
  }
}
