// The paper's four experiments: topology, accuracy, validity, independence of voxel type, spacing and
// orientation.

#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

// A quarter more than the worst that is measured with any type of voxel and either grid.
constexpr Limits kLimits{0.9877, 0.085, 0.292, 0.007, 1.13};
constexpr Limits kSpeckleLimits{0.992, 0.233, 0.612, 0.0029, 1.95};  // no edge is sharp everywhere

void expectExperiment(const std::string& name, const PhantomOptions& options, const char* what) {
  const Limits& limits = name == "cyst" ? kSpeckleLimits : kLimits;
  const Phantom phantom = makePhantom(name, options);
  expectTrue(phantom, options, grow(phantom), limits, what);
}

const std::vector<std::string> kExperiments{"cyst", "cube", "genus3", "torus"};

}  // namespace

TEST_CASE("the four experiments end with the right topology, certified and accurate", "[experiments]") {
  for (const std::string& name : kExperiments) {
    INFO(name);
    expectExperiment(name, {}, "uint8");
  }
}

TEST_CASE("the experiments come out the same with int16 and float voxels", "[experiments]") {
  for (const std::string& name : kExperiments)
    for (VoxelType type : {VoxelType::int16, VoxelType::float32}) {
      INFO(name << ' ' << voxelTypeName(type));
      PhantomOptions options;
      options.type = type;
      expectExperiment(name, options, voxelTypeName(type));
    }
}

TEST_CASE("anisotropic spacing and a rotated grid give the same shape in mm", "[experiments]") {
  for (const std::string& name : kExperiments) {
    INFO(name);
    PhantomOptions options;
    options.spacing = Vec3(0.5, 1, 2);
    options.rotationDegrees = Vec3(20, 30, 40);
    expectExperiment(name, options, "0.5 x 1 x 2 mm, rotated");
  }
}

TEST_CASE("one thread, two threads and a second run give the same mesh bit for bit", "[experiments]") {
  const Phantom phantom = makePhantom("torus");
  const Outcome first = grow(phantom, 1), second = grow(phantom, 1), threaded = grow(phantom, 2);
  CHECK(first.mesh.points == second.mesh.points);
  CHECK(first.mesh.triangles == second.mesh.triangles);
  CHECK(first.mesh.points == threaded.mesh.points);
  CHECK(first.mesh.triangles == threaded.mesh.triangles);
}

TEST_CASE("both broad phases give the same mesh, bit for bit, in the four experiments", "[experiments]") {
  for (const std::string& name : kExperiments) {
    INFO(name);
    const Phantom phantom = makePhantom(name);
    Parameters hashing;
    hashing.broadPhase = BroadPhase::hashing;
    const Outcome a = grow(phantom), b = growWith(phantom, hashing);
    CHECK(a.mesh.points == b.mesh.points);
    CHECK(a.mesh.triangles == b.mesh.triangles);
    CHECK(a.iterations == b.iterations);
  }
}
