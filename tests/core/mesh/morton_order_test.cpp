#include "core/mesh/morton_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/mesh/shapes.h"
#include "tests/support/expect_valid.h"

using namespace handlebody;

namespace {

//! A sphere whose vertices lie anywhere in memory, with free slots.
Mesh scattered() {
  Mesh mesh(icosphere(Vec3(1, 2, 3), 10, 0.7));
  std::mt19937 random(11);
  std::vector<int> order(mesh.vertexSlots());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  mesh.reorder(order);
  for (int h = 0; h < 3 * mesh.faceSlots(); h += 97)
    if (mesh.isFace(h / 3) && mesh.canCollapse(h)) mesh.collapseEdge(h, mesh.position(mesh.origin(h)));
  return mesh;
}

using Corners = std::array<std::array<double, 3>, 3>;

//! All faces as points, whatever their numbers.
std::vector<Corners> sortedFaces(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    Corners c;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t a = 0; a < 3; ++a) c[i][a] = mesh.position(t[i])[static_cast<int>(a)];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    faces.push_back(c);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

//! Mean distance in memory of the two ends of an edge, in vertices.
double meanEdgeInMemory(const Mesh& mesh) {
  double sum = 0;
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (mesh.isFace(h / 3)) sum += std::abs(mesh.origin(h) - mesh.target(h));
  return sum / (3.0 * mesh.faceCount());
}

}  // namespace

TEST_CASE("a mesh in Morton order is the same mesh without free slots") {
  const Mesh before = scattered();
  REQUIRE(before.vertexCount() < before.vertexSlots());
  Mesh after = before;
  after.reorder(mortonOrder(before, 0.7));
  expectValid(after);
  expectTopology(after, 1, 0);
  CHECK(after.vertexSlots() == before.vertexCount());
  CHECK(after.faceSlots() == before.faceCount());
  CHECK(sortedFaces(after) == sortedFaces(before));
}

TEST_CASE("a mesh in Morton order can be changed like any other") {
  Mesh mesh = scattered();
  mesh.reorder(mortonOrder(mesh, 0.7));
  for (int h = 0; h < 300; h += 7)
    mesh.splitEdge(h, (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))) / 2);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("in Morton order neighbours in space are neighbours in memory") {
  Mesh mesh = scattered();
  const double before = meanEdgeInMemory(mesh);
  CHECK(before > mesh.vertexCount() / 4.0);  // a third of all, anywhere
  mesh.reorder(mortonOrder(mesh, 0.7));
  CHECK(meanEdgeInMemory(mesh) < before / 4);
}

TEST_CASE("the Morton order does not depend on where the mesh lies") {
  const Mesh mesh = scattered();
  Mesh moved = mesh;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) moved.setPosition(v, mesh.position(v) + Vec3(-1024, 512, 4096));
  // A vertex on the edge of a cube may change sides by rounding.
  const std::vector<int> a = mortonOrder(mesh, 0.75), b = mortonOrder(moved, 0.75);
  CHECK(std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>{},
                           [](int i, int j) { return i == j ? 1 : 0; }) > 0.95 * mesh.vertexCount());
}
