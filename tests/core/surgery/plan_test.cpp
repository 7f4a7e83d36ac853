// What a plan leaves behind where there is none.
#include "core/surgery/plan.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;
using testing::graphDistances;
using testing::pinchingPair;

namespace {

struct PlanTrial {
  Mesh before{zoo::sphere(8)}, mesh = before;
  std::optional<Plan> plan;
  FindingKind reason = FindingKind::none;

  //! For a front whose polygon is not simple, and one on the far side of the same sphere.
  explicit PlanTrial(bool outwardOnly) {
    const std::vector<int> distances = graphDistances(mesh, {0});
    const auto farthest = std::max_element(distances.begin(), distances.end());
    const std::vector<unsigned char> none;
    FaceBlocks blocks(mesh);
    plan = planFor(mesh, blocks, {pinchingPair(mesh), {static_cast<int>(farthest - distances.begin())}},
                   {outwardOnly, none}, reason);
  }
};

}  // namespace

TEST_CASE("a plan refines the mesh where an opening needs it") {
  const PlanTrial trial(false);
  REQUIRE(trial.plan);
  CHECK(trial.mesh.vertexCount() > trial.before.vertexCount());
}

TEST_CASE("where no plan is found the mesh is as it was") {
  const PlanTrial trial(true);  // these fronts face each other through the inside
  REQUIRE_FALSE(trial.plan);
  CHECK(trial.reason == FindingKind::meetInside);
  CHECK(trial.mesh.vertexSlots() == trial.before.vertexSlots());
  CHECK(std::equal(trial.mesh.faces().begin(), trial.mesh.faces().end(), trial.before.faces().begin(),
                   trial.before.faces().end()));
}
