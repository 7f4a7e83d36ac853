#include "core/evolution/step_transaction.h"

#include <algorithm>

#include "core/errors.h"
#include "core/mesh/topology.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! A sphere in a volume that is object everywhere.
struct Growing {
  Mesh mesh{zoo::moved(zoo::scaled(zoo::sphere(6), 6), kMiddle)};
  ObjectImage image{
      std::make_shared<SmoothedVolume>(volumeByIndex(cubicGrid(41), [](int, int, int) { return 0; }), 0),
      {-1, 1},
      1};
  MotionSettings motion;
  RemeshLimits limits{1.8, 0.6};
  WallGuard walls;
  ActiveVertices active;
  Restraints locked;
  StepTransaction transaction;

  Growing() {
    motion.edgeLength = 1.2;
    active.activateAll(mesh.vertexSlots());
  }
  StepScene scene() {
    return {image, motion, limits, walls, active, locked, BroadPhase::sorted, topologyNumbers(mesh), 1};
  }
  StepOutcome step() {
    StepOutcome out = transaction.move(mesh, scene());
    active.activateAll(mesh.vertexSlots());
    return out;
  }
};

double longestEdge(const Mesh& mesh) {
  double longest = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    mesh.forEachOutgoing(v, [&](int h) {
      longest = std::max(longest, (mesh.position(mesh.target(h)) - mesh.position(v)).norm());
    });
  return longest;
}

}  // namespace

TEST_CASE("a step of the transaction grows the surface and leaves it valid") {
  Growing g;
  const Mesh before = g.mesh;
  const StepOutcome out = g.step();
  CHECK(out.last.isKept());
  CHECK(out.events.empty());
  CHECK(static_cast<int>(out.last.moving.size()) == before.vertexCount());
  CHECK(isSame(g.transaction.before(), before));
  CHECK(g.transaction.volume() > volumeOf(before));
  CHECK(g.transaction.volume() == Approx(volumeOf(g.mesh)));
  expectValid(g.mesh);
  expectTopology(g.mesh, 1, 0);
}

TEST_CASE("a copy of the transaction goes on with the same bits, though it has no memory of earlier steps") {
  Growing g;
  for (int i = 0; i < 5; ++i) g.step();
  Growing copy = g;
  for (int i = 0; i < 5; ++i) {
    g.step();
    copy.step();
  }
  CHECK(isSame(g.mesh, copy.mesh));
}

TEST_CASE("where all is locked nothing moves, and nothing is wrong with that") {
  Growing g;
  g.locked.regions.add(kMiddle, 100, 1);
  const Mesh before = g.mesh;
  const StepOutcome out = g.step();
  CHECK(out.last.isKept());
  CHECK(out.last.moving.empty());
  CHECK(isSame(g.mesh, before));
}

TEST_CASE("in a place that is stuck edges that reach across it are split, and the surface goes nowhere") {
  Growing g;
  g.mesh = Mesh(zoo::moved(zoo::scaled(zoo::sphere(1), 12), kMiddle));
  g.active.activateAll(g.mesh.vertexSlots());
  const Mesh before = g.mesh;
  const double most = 1.05 * g.limits.longest;
  REQUIRE(longestEdge(before) > 2 * most);
  for (const int iteration : {-100, -50, 0}) g.locked.regions.add(kMiddle, 100, iteration);
  g.step();
  CHECK(isSame(g.mesh, before));  // it may yet come right by itself
  g.locked.regions = {};
  for (const int iteration : {-150, -100, -50, 0}) g.locked.regions.add(kMiddle, 100, iteration);
  for (int i = 0; i < 4; ++i) {
    const StepOutcome out = g.step();
    CHECK(out.last.isKept());
    CHECK(out.events.empty());
    CHECK(out.last.moving.empty());
    expectValid(g.mesh);
  }
  CHECK(longestEdge(g.mesh) <= most);
  CHECK(volumeOf(g.mesh) == Approx(volumeOf(before)).epsilon(0.002));  // edges are turned and merged, too
}

TEST_CASE("fronts that meet join, and what a limit holds is rolled back and locked") {
  Growing g;
  const TriangleSoup ball = zoo::scaled(zoo::sphere(6), 6);
  g.mesh = Mesh(zoo::both(zoo::moved(ball, kMiddle), zoo::moved(ball, kMiddle + Vec3(12.05, 0.1, 0.1))));
  g.active.activateAll(g.mesh.vertexSlots());
  Growing held = g;
  const auto stepUntilTold = [](Growing& grown) {
    StepOutcome out;
    for (int i = 0; i < 10 && out.events.empty(); ++i) out = grown.step();
    CHECK(out.last.isKept());
    REQUIRE_FALSE(out.events.empty());
    expectValid(grown.mesh);
    return out;
  };
  CHECK(stepUntilTold(g).events.back().after.components == 1);
  expectTopology(g.mesh, 1, 0);

  held.locked.held.holdTopology(true);
  const StepOutcome out = stepUntilTold(held);
  int times = 0;
  for (const Event& e : out.events) {
    CHECK(e.before == e.after);
    if (!e.held) continue;
    ++times;
    CHECK(e.kind == EventKind::rolledBack);
    CHECK(held.locked.held.isLocked(e.location));
  }
  CHECK(times > 0);
  expectTopology(held.mesh, 2, 0);
}

TEST_CASE("an edit that a limit forbids, or that finds nothing, leaves the mesh as it was") {
  Growing g;
  const Mesh before = g.mesh;
  MeshEdit edit{1, MeshEditKind::cut, kMiddle, TunnelCut::shorter, Vec3(1, 0, 0)};
  TopologyLimits limits;
  limits.components = 1;
  CHECK_THROWS_AS(g.transaction.edit(g.mesh, edit, g.scene(), limits), UsageError);
  CHECK(isSame(g.mesh, before));
  edit.kind = MeshEditKind::fillCavity;
  CHECK_THROWS_AS(g.transaction.edit(g.mesh, edit, g.scene(), {}), UsageError);
  CHECK(isSame(g.mesh, before));
  edit.kind = MeshEditKind::cut;
  const Attempt made = g.transaction.edit(g.mesh, edit, g.scene(), {});
  CHECK(made.isKept());
  CHECK(made.events.back().after.components == 2);
  expectValid(g.mesh);
  expectTopology(g.mesh, 2, 0);
}
