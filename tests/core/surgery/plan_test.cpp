// What a plan leaves behind where there is none.
#include "core/surgery/plan.h"

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;
using testing::graphDistances;
using testing::pinchingPair;
using testing::vertexNear;

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

TEST_CASE("small openings are joined by a handle from the database, larger ones by one that was searched") {
  const Mesh before(zoo::both(zoo::sphere(8), zoo::moved(zoo::sphere(8), Vec3(2.1, 0.03, 0.01))));
  std::vector<int> left{vertexNear(before, Vec3(1, 0, 0))}, right{vertexNear(before, Vec3(1.1, 0.03, 0.01))};
  for (const HandleSource expected : {HandleSource::database, HandleSource::search}) {
    Mesh mesh = before;
    FaceBlocks blocks(mesh);
    FindingKind reason = FindingKind::none;
    const std::vector<unsigned char> none;
    const auto plan = planFor(mesh, blocks, {left, right}, {true, none}, reason);
    REQUIRE(plan);
    CHECK(plan->kind == EventKind::handleInserted);
    CHECK(plan->handleFrom == expected);
    left = enlarge(mesh, left);
    right = enlarge(mesh, right);
  }
}

TEST_CASE("where no plan is found the mesh is as it was") {
  const PlanTrial trial(true);  // these fronts face each other through the inside
  REQUIRE_FALSE(trial.plan);
  CHECK(trial.reason == FindingKind::meetInside);
  CHECK(trial.mesh.vertexSlots() == trial.before.vertexSlots());
  CHECK(std::equal(trial.mesh.faces().begin(), trial.mesh.faces().end(), trial.before.faces().begin(),
                   trial.before.faces().end()));
}
