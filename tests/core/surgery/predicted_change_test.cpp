#include "core/surgery/predicted_change.h"

#include "tests/core/surgery/adaptation_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! Takes k discs out of the mesh, far from each other, and plans a handle for them.
Plan handleFor(const Mesh& mesh, const std::vector<int>& middles) {
  Plan plan;
  plan.kind = EventKind::handleInserted;
  for (const int v : middles) {
    plan.openings.push_back(*planOpening(mesh, {v}));
    plan.joined.push_back(plan.openings.back().loops[0][0]);
  }
  return plan;
}

Mesh opened(Mesh mesh, const Plan& plan) {
  for (const Opening& o : plan.openings) {
    mesh.removeFaces(o.faces);
    for (const int v : o.lambda) mesh.removeVertex(v);
  }
  return mesh;
}

}  // namespace

TEST_CASE("a handle with k openings makes the genus of a connected surface k - 1 larger: Theorem 6") {
  const std::vector<int> places{0, 100, 200, 300};
  for (const TriangleSoup& s : {zoo::torus(30, 14, 3, 1), zoo::sphere(7)}) {
    const Mesh mesh(s);
    const TopologyNumbers before = topologyNumbers(mesh);
    for (int k = 2; k <= 4; ++k) {
      const Plan plan = handleFor(mesh, {places.begin(), places.begin() + k});
      CHECK(eulerChange(plan) == -2 * (k - 1));
      const TopologyNumbers after = predictChange(before, opened(mesh, plan), plan);
      CHECK(after == TopologyNumbers{1, before.euler - 2 * (k - 1), before.genus + k - 1});
    }
  }
}

TEST_CASE("a handle between components joins them, and the genus stays") {
  const Mesh mesh(zoo::both(zoo::sphere(4), zoo::moved(zoo::torus(30, 14, 3, 1), Vec3(9, 0, 0))));
  const Plan plan = handleFor(mesh, {0, mesh.vertexSlots() - 1});
  CHECK(predictChange({2, 2, 1}, opened(mesh, plan), plan) == TopologyNumbers{1, 0, 1});
}

TEST_CASE("caps on an annulus split a sphere, and take the tunnel of a torus; a band changes nothing") {
  // A ring of the torus across its tube, and one about a sphere of revolution.
  const Mesh torus(zoo::torus(30, 14, 3, 1));
  const Mesh peanutMesh(peanut(0.2));
  const auto ring = [](int first, int size) {
    std::vector<int> v;
    for (int i = 0; i < size; ++i) v.push_back(first + i);
    return v;
  };
  Plan caps;
  caps.kind = EventKind::split;
  caps.openings = {*planOpening(torus, ring(14, 14))};
  REQUIRE(caps.openings[0].loops.size() == 2);
  CHECK(eulerNumberOf(caps.openings[0]) == 0);
  CHECK(predictChange({1, 0, 1}, opened(torus, caps), caps) == TopologyNumbers{1, 2, 0});
  Plan band = caps;
  band.joined = {band.openings[0].loops[0][0], band.openings[0].loops[1][0]};
  CHECK(predictChange({1, 0, 1}, opened(torus, band), band) == TopologyNumbers{1, 0, 1});

  caps.openings = {*planOpening(peanutMesh, ring(1 + 11 * 12, 12))};
  REQUIRE(caps.openings[0].loops.size() == 2);
  CHECK(predictChange({1, 2, 0}, opened(peanutMesh, caps), caps) == TopologyNumbers{2, 4, 0});
}

TEST_CASE("a component that is taken out whole, or deleted, takes its genus with it") {
  const Mesh mesh(zoo::both(zoo::sphere(4), zoo::moved(zoo::torus(8, 6, 3, 1), Vec3(9, 0, 0))));
  const Components parts = findComponents(mesh);
  const TopologyNumbers before{2, 2, 1};
  CHECK(predictDeletion(before, parts, 1) == TopologyNumbers{1, 2, 0});
  CHECK(predictDeletion(before, parts, 0) == TopologyNumbers{1, 0, 1});
  Plan plan;
  plan.kind = EventKind::componentDeleted;
  std::vector<int> all;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (parts.ofVertex[v] == 1) all.push_back(v);
  plan.openings = {*planOpening(mesh, all)};
  CHECK(plan.openings[0].loops.empty());
  CHECK(predictChange(before, opened(mesh, plan), plan) == TopologyNumbers{1, 2, 0});
}
