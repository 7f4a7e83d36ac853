#include "core/mesh/mesh_copy.h"

#include <cmath>
#include <cstring>
#include <random>

#include "core/mesh/shapes.h"
#include "tests/support/expect_valid.h"

using namespace handlebody;

namespace {

template <typename T>
bool sameBits(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

//! With its slots, and the free ones in the order in which they are filled again.
void requireSame(Mesh a, Mesh b) {
  REQUIRE(sameBits(a.positions(), b.positions()));
  REQUIRE(sameBits(a.faces(), b.faces()));
  REQUIRE(sameBits(a.opposites(), b.opposites()));
  REQUIRE(sameBits(a.outgoing(), b.outgoing()));
  REQUIRE(a.vertexCount() == b.vertexCount());
  REQUIRE(a.faceCount() == b.faceCount());
  for (int i = 0; i < 5; ++i)
    REQUIRE(a.splitEdge(a.outgoing(0), Vec3(i, 0, 0)) == b.splitEdge(b.outgoing(0), Vec3(i, 0, 0)));
  REQUIRE(sameBits(a.faces(), b.faces()));
}

}  // namespace

TEST_CASE("copies of a mesh that changes come back bit for bit, whatever they share", "[mesh]") {
  Mesh mesh(icosphere(Vec3(1, 2, 3), 10, 1));
  std::mt19937 random(11);
  std::vector<Mesh> expected;
  std::vector<MeshCopy> copies;
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 15; ++i) {
      int h = 0;
      do h = static_cast<int>(random() % static_cast<unsigned>(3 * mesh.faceSlots()));
      while (!mesh.isFace(h / 3));
      if (random() % 2)
        mesh.splitEdge(h, (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))) / 2);
      else if (mesh.canCollapse(h))
        mesh.collapseEdge(h, mesh.position(mesh.origin(h)));
    }
    expected.push_back(mesh);
    copies.emplace_back(mesh, copies.empty() ? nullptr : &copies.back());
  }
  copies.erase(copies.begin() + 3, copies.begin() + 9);  // what was shared with them stays
  expected.erase(expected.begin() + 3, expected.begin() + 9);
  for (std::size_t i = 0; i < copies.size(); ++i) requireSame(copies[i].mesh(), expected[i]);
}

TEST_CASE("a copy costs what has changed since the one before", "[mesh]") {
  Mesh mesh(icosphere(Vec3(1, 2, 3), 10, 0.3));
  const MeshCopy first(mesh, nullptr);
  const auto whole = static_cast<double>(first.memoryBeside(nullptr));
  CHECK(whole >= static_cast<double>(mesh.memory()));
  CHECK(whole < 1.1 * static_cast<double>(mesh.memory()));
  const MeshCopy same(mesh, &first);
  CHECK(static_cast<double>(same.memoryBeside(&first)) < 0.03 * whole);
  mesh.setPosition(7, Vec3::Zero());
  const MeshCopy moved(mesh, &same);
  CHECK(moved.memoryBeside(&same) - same.memoryBeside(&first) == 256 * sizeof(Vec3));
  CHECK(static_cast<double>(moved.memoryBeside(nullptr)) == whole);
}

TEST_CASE("zero and minus zero are two positions for a copy", "[mesh]") {
  Mesh mesh(icosphere(Vec3(1, 2, 3), 10, 2));
  mesh.setPosition(0, Vec3(0, 1, 2));
  const MeshCopy first(mesh, nullptr);
  mesh.setPosition(0, Vec3(-0.0, 1, 2));
  CHECK(std::signbit(MeshCopy(mesh, &first).mesh().position(0).x()));
}
