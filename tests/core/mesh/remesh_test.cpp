#include "core/mesh/remesh.h"

#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;

namespace {

using Flags = std::vector<unsigned char>;

Flags all(const Mesh& mesh) { return Flags(static_cast<std::size_t>(mesh.vertexSlots()), 1); }

double longestBesideActive(const Mesh& mesh, const Flags& active) {
  double longest = 0;
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h) {
    if (!mesh.isFace(h / 3)) continue;
    const int a = mesh.origin(h), b = mesh.target(h);
    if (!active[a] && !active[b]) continue;
    longest = std::max(longest, (mesh.position(a) - mesh.position(b)).norm());
  }
  return longest;
}

int countShorter(const Mesh& mesh, double limit) {
  int n = 0;
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (mesh.isFace(h / 3) && h < mesh.opposite(h))
      n += (mesh.position(mesh.origin(h)) - mesh.position(mesh.target(h))).norm() < limit;
  return n;
}

//! Furthest distance of corners, edge middles and face middles from the sphere of radius r round the origin.
double distanceFromSphere(const Mesh& mesh, double r) {
  double furthest = 0;
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Vec3 &a = mesh.position(mesh.face(f)[0]), &b = mesh.position(mesh.face(f)[1]),
               &c = mesh.position(mesh.face(f)[2]);
    for (const Vec3& p : {a, Vec3((a + b) / 2), Vec3((a + b + c) / 3)})
      furthest = std::max(furthest, std::abs(p.norm() - r));
  }
  return furthest;
}

}  // namespace

TEST_CASE("regulating splits every edge that is too long and keeps the topology") {
  for (const TriangleSoup& s : {zoo::sphere(2), zoo::torus(8, 5, 2, 0.7), zoo::cube(1)}) {
    Mesh mesh(s);
    const int genus = s.points.size() == 40 ? 1 : 0;
    Flags active = all(mesh);
    const double limit = longestBesideActive(mesh, active) / 4;
    regulate(mesh, {limit, 0.4 * limit}, active);
    CHECK(longestBesideActive(mesh, active) <= limit);
    CHECK(active.size() >= static_cast<std::size_t>(mesh.vertexSlots()));
    expectValid(mesh);
    expectTopology(mesh, 1, genus);
  }
}

TEST_CASE("splitting alone does not move the surface") {
  const TriangleSoup cube = zoo::cube(1);
  Mesh mesh(cube);
  Flags active = all(mesh);
  regulate(mesh, {0.3, 0}, active);
  const Certificate c = examine(mesh.compact());
  CHECK(c.volume == Approx(1).epsilon(1e-12));
  CHECK(c.area == Approx(6).epsilon(1e-12));
  CHECK(mesh.vertexCount() > 100);
}

TEST_CASE("regulating collapses nearly all short edges") {
  Mesh mesh(icosphere(Vec3(0, 0, 0), 10, 0.8));
  const int before = mesh.vertexCount();
  REQUIRE(countShorter(mesh, 1.1) > 1000);  // all of them
  Flags active = all(mesh);
  for (int round = 0; round < 4; ++round) regulate(mesh, {2.8, 1.1}, active);
  CHECK(mesh.vertexCount() < before / 2);
  CHECK(countShorter(mesh, 1.1) < 50);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("a sphere that is regulated again and again stays a sphere within the height of its faces") {
  const double r = 10;
  // Corners move towards the middle by at most the sagitta of a collapsed edge, faces lie below their corners
  // by at most e²/(6r): with edges of up to s both together stay within s²/(4r).
  for (const auto& [longest, least] : {std::pair(2.8, 1.1), std::pair(1.4, 0.55), std::pair(0.9, 0.36)}) {
    Mesh mesh(icosphere(Vec3(0, 0, 0), r, 1.2));
    Flags active = all(mesh);
    for (int round = 0; round < 10; ++round) regulate(mesh, {longest, least}, active);
    const double s = std::max(longest, 1.2);
    CHECK(distanceFromSphere(mesh, r) <= s * s / (4 * r));
    CHECK(examine(mesh.compact()).volume == Approx(4.0 / 3 * M_PI * 1000).epsilon(0.02));
    expectValid(mesh);
    expectTopology(mesh, 1, 0);
  }
}

TEST_CASE("inactive vertices are neither moved nor removed") {
  for (const RemeshLimits& limits : {RemeshLimits{0.9, 0.3}, RemeshLimits{4.0, 1.5}}) {
    Mesh mesh(icosphere(Vec3(0, 0, 0), 10, 1.2));
    const Mesh before = mesh;
    Flags active = all(mesh);
    for (int v = 0; v < mesh.vertexSlots(); ++v) active[v] = mesh.position(v).x() > 2;
    const Flags asked = active;
    regulate(mesh, limits, active);
    CHECK(mesh.vertexCount() != before.vertexCount());
    for (int v = 0; v < before.vertexSlots(); ++v) {
      if (asked[v]) continue;
      REQUIRE(mesh.isVertex(v));
      REQUIRE(mesh.position(v) == before.position(v));
      REQUIRE(active[v] != kActive);
    }
    CHECK(longestBesideActive(mesh, active) <= limits.longest);
    expectValid(mesh);
    expectTopology(mesh, 1, 0);
  }
}

TEST_CASE("long edges between inactive vertices do not make the faces beside them thin") {
  // A roof of two long faces on a box, as surgery may leave one; only its middle is active.
  const double length = 10;
  TriangleSoup roof;
  roof.points = {
      {0, 0, 0}, {length, 0, 0}, {length / 2, 0.5, 0.1}, {length / 2, -0.5, 0.1}, {length / 2, 0, -1}};
  roof.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}};
  Mesh mesh(roof);
  Flags active{0, 0, 1, 0, 0};
  regulate(mesh, {1.0, 0.1}, active);
  expectValid(mesh);
  expectTopology(mesh, 1, 0);
  CHECK(testing::leastAltitude(mesh) > 0.01);
}

TEST_CASE("where nothing is active nothing is done") {
  Mesh mesh(zoo::sphere(3));
  const Mesh before = mesh;
  Flags active(static_cast<std::size_t>(mesh.vertexSlots()), 0);
  regulate(mesh, {0.05, 0.02}, active);
  CHECK(mesh.compact().points == before.compact().points);
  CHECK(mesh.compact().triangles == before.compact().triangles);
}

TEST_CASE("new vertices are active, in fresh slots and in slots used again") {
  Mesh mesh(icosphere(Vec3(0, 0, 0), 10, 1.2));
  Flags active = all(mesh);
  regulate(mesh, {4, 1.5}, active);  // leaves free slots
  REQUIRE(mesh.vertexCount() < mesh.vertexSlots());
  std::vector<unsigned char> existed(mesh.vertexSlots());
  for (int v = 0; v < mesh.vertexSlots(); ++v) existed[v] = mesh.isVertex(v);
  active.assign(mesh.vertexSlots(), 0);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && mesh.position(v).z() > 0) active[v] = 1;
  regulate(mesh, {0.9, 0}, active);
  int fresh = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v) || (static_cast<std::size_t>(v) < existed.size() && existed[v])) continue;
    ++fresh;
    REQUIRE(active[v] == 1);
  }
  CHECK(fresh > 100);
  expectValid(mesh);
}

TEST_CASE("edges many times too long are split as well") {
  for (double times : {8, 12, 20}) {
    Mesh mesh(zoo::torus(8, 5, 2, 0.7));
    Flags active = all(mesh);
    const double limit = longestBesideActive(mesh, active) / times;
    regulate(mesh, {limit, 0.4 * limit}, active);
    CAPTURE(times);
    CHECK(longestBesideActive(mesh, active) <= limit);
  }
}

TEST_CASE("regulating random meshes keeps them valid, of their topology and without long edges") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const bool isTorus = seed % 2 == 0;
    Mesh mesh(zoo::perturbed(isTorus ? zoo::torus(16, 9, 2, 0.7) : zoo::sphere(4), 0.15, seed));
    Flags active = all(mesh);
    const double longest =
        longestBesideActive(mesh, active) * (0.25 + 0.1 * static_cast<double>(random() % 12));
    regulate(mesh, {longest, 0.4 * longest}, active);
    for (int round = 0; round < 4; ++round) {
      // Like a step of the evolution: some vertices move by part of an edge, the rest is inactive.
      active.assign(mesh.vertexSlots(), 0);
      for (int v = 0; v < mesh.vertexSlots(); ++v) {
        if (!mesh.isVertex(v) || random() % 3 == 0) continue;
        active[v] = 1;
        mesh.setPosition(
            v, mesh.position(v) +
                   0.3 * longest *
                       zoo::perturbed({{Vec3(0, 0, 0)}, {}}, 1, static_cast<unsigned>(random())).points[0]);
      }
      regulate(mesh, {longest, 0.4 * longest}, active);
      CHECK(longestBesideActive(mesh, active) <= longest);
    }
    expectValid(mesh);
    expectTopology(mesh, 1, isTorus ? 1 : 0);
  }
}
