#include "core/evolution/pinned_check.h"

#include "core/mesh/topology.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

//! A body with a cavity, which is `height` times as high as it is wide. The cavity's vertices come last.
Mesh withCavity(double height) {
  TriangleSoup cavity = zoo::sphere(3);
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  for (Vec3& p : cavity.points) p.z() *= height;
  return Mesh(zoo::both(zoo::scaled(zoo::sphere(4), 3), cavity));
}

PinnedParts pinnedAt(const Mesh& mesh, int vertex) {
  PinnedParts pins;
  pins.choose({{mesh.position(vertex), 1e-6, 0}}, 0);
  pins.take(mesh, 0);
  return pins;
}

}  // namespace

TEST_CASE("a flat cavity over a pinned vertex stops; one with room in it, or without a pin, does not") {
  constexpr double kEdge = 0.5;
  const Mesh flat = withCavity(1e-4), round = withCavity(1);
  const std::vector<unsigned char> touched(flat.vertexSlots(), 1);
  const int last = flat.vertexSlots() - 1;
  const std::vector<Conflict> told = pressedFlat(flat, pinnedAt(flat, last), touched, kEdge);
  REQUIRE(told.size() == 1);
  CHECK(told[0].atPin);
  CHECK(told[0].centre.norm() < 1.1);  // on the cavity
  CHECK(told[0].radius > 1);
  CHECK(pressedFlat(round, pinnedAt(round, last), touched, kEdge).empty());
  CHECK(pressedFlat(flat, pinnedAt(flat, 0), touched, kEdge).empty());
  CHECK(pressedFlat(flat, {}, touched, kEdge).empty());
  CHECK(
      pressedFlat(flat, pinnedAt(flat, last), std::vector<unsigned char>(touched.size(), 0), kEdge).empty());
}

TEST_CASE("a change of what is pinned is told with the places of all events") {
  const Mesh before = withCavity(1);
  const PinnedParts pins = pinnedAt(before, 0);
  Event event;
  event.location = Vec3(1, 2, 3);
  Mesh mesh = before;
  CHECK(changesOfPinned(before, mesh, pins, std::vector{event}, 0.5).empty());
  mesh.setPosition(1, 1.1 * mesh.position(1));
  CHECK(changesOfPinned(before, mesh, pins, std::vector{event}, 0.5).empty());
  mesh.setPosition(0, 1.1 * mesh.position(0));
  const std::vector<Conflict> told = changesOfPinned(before, mesh, pins, std::vector{event}, 0.5);
  REQUIRE(told.size() == 2);
  CHECK(told[0].centre == before.position(0));
  CHECK(told[1].centre == event.location);
  CHECK_FALSE(told[0].atPin);
}
