// Shapes that are hard on the topology: linked, knotted, branched, porous, thin. From the phantom's own seed
// with automatic parameters to the right topology.

#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! Euler number of the union of the labelled voxels as closed cubes: vertices - edges + faces - cubes. The
//! surface of a solid has twice the Euler number of the solid.
int eulerOfLabel(const Volume& label) {
  const auto& n = label.grid.size;
  const auto* data = label.data<std::uint8_t>();
  const auto at = [&](int i, int j, int k) {
    return i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2] &&
           data[(static_cast<std::ptrdiff_t>(k) * n[1] + j) * n[0] + i] != 0;
  };
  int euler = 0;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        // The cell of every dimension at the low corner of voxel (i, j, k) exists if a voxel beside it does.
        for (int cell = 0; cell < 8; ++cell) {
          const int di = cell & 1, dj = cell >> 1 & 1, dk = cell >> 2;  // 1: the cell extends along the axis
          bool exists = false;
          for (int beside = 0; beside < 8 && !exists; ++beside)
            if ((beside & cell) == 0) exists = at(i - (beside & 1), j - (beside >> 1 & 1), k - (beside >> 2));
          if (exists) euler += (di + dj + dk) % 2 == 0 ? 1 : -1;
        }
  return euler;
}

//! A quarter more than the worst that is measured, outwards and in both directions. Of the tubes of the tree,
//! which are 3 voxels wide, more is lost where the surface lies as far inside as elsewhere.
Limits limitsFor(const std::string& name) {
  if (name == "tree") return {0.976, 0.081, 0.208, 0.021, 0.73};
  return {0.992, 0.061, 0.18, 0.0085, 0.985};
}

const std::vector<std::string> kHardShapes{"rings", "trefoil", "tree",     "balls",
                                           "plate", "neck",    "dumbbell", "gyroid"};

void expectShape(const std::string& name, const PhantomOptions& options, Direction direction,
                 const char* what) {
  INFO(name << ' ' << what);
  const Phantom phantom = makePhantom(name, options);
  const Outcome o = grow(phantom, 1, direction);
  CHECK(o.certificate.euler == 2 * eulerOfLabel(phantom.truth));
  expectTrue(phantom, options, o, limitsFor(name), what);
}

}  // namespace

TEST_CASE("hard shapes end with the right topology, certified and accurate", "[shapes]") {
  const std::string name = GENERATE(from_range(kHardShapes));
  expectShape(name, {}, Direction::outward, "outward");
}

TEST_CASE("hard shapes come out of other noise, and where the surface may shrink", "[shapes]") {
  const std::string name = GENERATE(from_range(kHardShapes));
  PhantomOptions options;
  options.randomSeed = 7;
  expectShape(name, options, Direction::both, "both directions");
}

TEST_CASE("the gyroid is of high genus", "[shapes]") {
  const int euler = 2 * eulerOfLabel(makePhantom("gyroid").truth);
  CHECK(1 - euler / 2 > 20);
}

TEST_CASE("an over-grown start contracts onto linked rings, through both of their holes", "[shapes]") {
  const Phantom phantom = makePhantom("rings");
  Parameters parameters;
  parameters.direction = Direction::both;
  ActiveContour contour(phantom.volume, {{phantom.seed, 90.0}}, parameters);
  CHECK(*contour.parameters().seeds[0].radius == 90.0);
  while (contour.stopReason() == StopReason::running) contour.step();
  Outcome o{contour.mesh().compact(), {}, contour.iteration(), contour.stopReason()};
  o.certificate = certify(o.mesh);
  expectTrue(phantom, {}, o, limitsFor("rings"), "from a ball around it");
}
