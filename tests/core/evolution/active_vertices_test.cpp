#include "core/evolution/active_vertices.h"

#include <algorithm>
#include <numeric>

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

Mesh sphereMesh() { return Mesh(zoo::sphere(4)); }

std::vector<int> allVertices(const Mesh& mesh) {
  std::vector<int> all(mesh.vertexSlots());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

//! A step in which all were asked to move, and the first moved by `first` (mm), the others not at all.
void stepWith(ActiveVertices& active, const Mesh& mesh, double first) {
  const std::vector<int> moving = allVertices(mesh);
  std::vector<double> distances(moving.size(), 0);
  distances[0] = first;
  const std::vector<unsigned char> touched(moving.size(), 1);
  active.count(mesh, {moving, distances, touched}, 1);
}

ActiveVertices convergedIn(const Mesh& mesh) {
  ActiveVertices active;
  active.activateAll(mesh.vertexSlots());
  for (int i = 0; i < kStepsToConverge; ++i) stepWith(active, mesh, 0);
  return active;
}

}  // namespace

TEST_CASE("vertices have converged after so many steps without motion, and are not active any more") {
  const Mesh mesh = sphereMesh();
  ActiveVertices active;
  active.activateAll(mesh.vertexSlots());
  for (int i = 0; i < kStepsToConverge; ++i) {
    CHECK(active.list(mesh, {}, 1) == allVertices(mesh));
    stepWith(active, mesh, 0);
  }
  CHECK(active.list(mesh, {}, 1).empty());
  CHECK(active.isConverged(0));
  active.activate(3);
  CHECK(active.list(mesh, {}, 1) == std::vector<int>{3});
  active.activateAll(mesh.vertexSlots());
  CHECK(active.list(mesh, {}, 1) == allVertices(mesh));
}

TEST_CASE("a vertex that moves far keeps itself and its one-ring active, and nothing else") {
  const Mesh mesh = sphereMesh();
  ActiveVertices active = convergedIn(mesh);
  stepWith(active, mesh, 1);
  std::vector<int> expected{0};
  mesh.forEachOutgoing(0, [&](int h) { expected.push_back(mesh.target(h)); });
  std::sort(expected.begin(), expected.end());
  CHECK(active.list(mesh, {}, 1) == expected);
}

TEST_CASE("vertices in new slots are active, and what has converged stays so when the mesh is put in order") {
  const Mesh mesh = sphereMesh();
  const int n = mesh.vertexSlots();
  ActiveVertices active = convergedIn(mesh);
  active.activate(2);
  active.resize(n + 1);
  CHECK(active.memory() == idx(n + 1));
  CHECK_FALSE(active.isConverged(n));
  std::vector<int> order = allVertices(mesh);
  std::reverse(order.begin(), order.end());
  active.reorder(order);
  CHECK(active.list(mesh, {}, 1) == std::vector<int>{n - 1 - 2});
}

TEST_CASE("what an edit moved has converged, and what it only gave other faces has not") {
  const Mesh before = sphereMesh();
  Mesh mesh = before;
  mesh.setPosition(5, 1.1 * mesh.position(5));
  ActiveVertices active;
  active.activateAll(mesh.vertexSlots());
  std::vector<unsigned char> touched(mesh.vertexSlots(), 0);
  touched[5] = touched[6] = 1;
  active.convergeChanged(before, mesh, touched);
  CHECK(active.isConverged(5));
  CHECK_FALSE(active.isConverged(6));
  CHECK_FALSE(active.isConverged(7));
}

TEST_CASE("a vertex in a locked region is not active, as long as it is locked") {
  const Mesh mesh = sphereMesh();
  ActiveVertices active;
  active.activateAll(mesh.vertexSlots());
  Restraints locked;
  locked.regions.add(mesh.position(0), 1e-3, 1);
  std::vector<int> others = allVertices(mesh);
  others.erase(others.begin());
  CHECK(active.list(mesh, locked, 1) == others);
  locked.forgetRollbacks();
  CHECK(active.list(mesh, locked, 1) == allVertices(mesh));
  locked.pins.choose({{mesh.position(0), 1e-3, 0}}, 0);
  locked.pins.take(mesh, 0);
  CHECK(active.list(mesh, locked, 1) == others);
}
