#include "core/collision/self_intersection.h"

#include <algorithm>
#include <chrono>

#include "core/collision/certify.h"
#include "core/collision/face_pair.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

std::vector<FacePair> find(const TriangleSoup& s) { return findSelfIntersections(s.points, s.triangles); }

//! All pairs of faces by the exact test alone.
std::vector<FacePair> bruteForce(const TriangleSoup& s) {
  std::vector<FacePair> pairs;
  const int n = static_cast<int>(s.triangles.size());
  for (int f = 0; f < n; ++f) {
    for (int g = f + 1; g < n; ++g) {
      const Triangle& a = s.triangles[f];
      const Triangle& b = s.triangles[g];
      if (a[0] >= 0 && b[0] >= 0 && facesIntersect(s.points, a, b)) pairs.emplace_back(f, g);
    }
  }
  return pairs;
}

TriangleSoup cornersExchanged(TriangleSoup s) {  // a rotation about (1,1,1) and a half turn: exact
  for (Vec3& p : s.points) p = Vec3(-p.y(), -p.z(), p.x());
  return s;
}

}  // namespace

TEST_CASE("detection equals the exact test of all pairs") {
  for (const TriangleSoup& s : zoo::intersecting()) {
    const auto expected = bruteForce(s);
    CAPTURE(s.points.size());
    CHECK(expected.size() > 0);
    CHECK(find(s) == expected);
  }
}

TEST_CASE("detection on open, broken and thinned meshes equals the exact test of all pairs") {
  for (TriangleSoup s : zoo::intersecting()) {
    for (std::size_t f = 0; f < s.triangles.size(); f += 5) s.triangles[f] = {-1, -1, -1};
    for (std::size_t f = 2; f < s.triangles.size(); f += 7) std::swap(s.triangles[f][0], s.triangles[f][1]);
    CHECK(find(s) == bruteForce(s));
  }
}

TEST_CASE("any number of threads finds the same pairs, in the same order") {
  TriangleSoup two = icosphere(Vec3(0, 0, 0), 1, 0.03);
  const TriangleSoup other = icosphere(Vec3(1.5, 0.1, 0.2), 1, 0.02);
  const int first = static_cast<int>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  REQUIRE(two.points.size() > 24000);  // for eight threads, in each phase more than one
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const std::vector<FacePair> expected = find(two);
  REQUIRE(expected.size() > 100);
  std::vector<unsigned char> moved(two.points.size(), 0);
  std::fill(moved.begin(), moved.begin() + first, static_cast<unsigned char>(1));
  const Mesh mesh(two);
  for (const BroadPhase phase : {BroadPhase::sorted, BroadPhase::hashing})
    for (const int threads : {1, 2, 3, 8}) {
      CollisionDetector detector;
      detector.use(phase);
      detector.useThreads(threads);
      CHECK(detector.detectAll(two.points, two.triangles) == expected);
      CHECK(detector.detectMoved(two.points, two.triangles, moved) == expected);
      CHECK(detector.detectMoved(mesh, moved) == expected);
      CHECK(detector.detectMoved(mesh, moved) == expected);  // all stars are still there
    }
}

TEST_CASE("scale by a power of two, an exact rotation and permutation do not change the pairs") {
  for (const TriangleSoup& s : zoo::intersecting()) {
    const auto expected = find(s);
    CHECK(find(zoo::scaled(s, 0x1p-10)) == expected);
    CHECK(find(zoo::scaled(s, 0x1p10)) == expected);
    CHECK(find(zoo::scaled(s, 0x1p-90)) == expected);
    CHECK(find(zoo::scaled(s, 0x1p90)) == expected);
    CHECK(find(cornersExchanged(s)) == expected);
    std::vector<int> face;
    const auto found = find(zoo::shuffled(s, 17, &face));
    std::vector<FacePair> renamed;
    for (const auto& [f, g] : expected) {
      const int i = face[f];
      const int j = face[g];
      renamed.emplace_back(std::min(i, j), std::max(i, j));
    }
    std::sort(renamed.begin(), renamed.end());
    CHECK(found == renamed);
  }
}

TEST_CASE("a detector gives the same answer again, also after other meshes") {
  CollisionDetector detector;
  for (int round = 0; round < 2; ++round) {
    for (const TriangleSoup& s : zoo::intersecting())
      CHECK(detector.detectAll(s.points, s.triangles) == find(s));
  }
}

TEST_CASE("detection of what moved finds all when the rest is clean") {
  const TriangleSoup sphere = zoo::both(zoo::sphere(10), zoo::moved(zoo::sphere(10), Vec3(2.1, 0, 0)));
  REQUIRE(find(sphere).empty());
  CollisionDetector detector;
  std::size_t all = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const auto jump = [&] { return 0.02 * static_cast<double>(random() % 7); };
    TriangleSoup s = sphere;
    std::vector<unsigned char> moved(s.points.size(), 0);
    const Vec3 centre = s.points[random() % s.points.size()];
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      if ((s.points[v] - centre).norm() > 0.5) continue;
      moved[v] = 1;
      s.points[v] += Vec3(jump(), jump(), jump()) + Vec3(seed % 2 == 0 ? 0.2 : 0, 0, 0);
    }
    const auto expected = find(s);
    all += expected.size();
    CHECK(detector.detectMoved(s.points, s.triangles, moved) == expected);
    CHECK(detector.detectMoved(Mesh(s), moved) == expected);
  }
  CHECK(all > 100);
}

TEST_CASE("a detector follows a mesh whose faces change from call to call") {
  Mesh mesh(zoo::sphere(8));
  CollisionDetector detector;
  std::mt19937 random(3);
  std::size_t all = 0;
  for (int round = 0; round < 50; ++round) {
    for (int change = 0; change < 6; ++change) {
      const int h = static_cast<int>(random() % static_cast<unsigned>(3 * mesh.faceSlots()));
      if (!mesh.isFace(Mesh::faceOf(h))) continue;
      const Vec3 middle = (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h))) / 2;
      if (change % 3 == 0)
        mesh.splitEdge(h, middle);
      else if (change % 3 == 1 && mesh.canCollapse(h))
        mesh.collapseEdge(h, middle);
      else if (mesh.canFlip(h))
        mesh.flipEdge(h);
    }
    const int pushed = static_cast<int>(random() % static_cast<unsigned>(mesh.vertexSlots()));
    mesh.setPosition(pushed, (round % 2 == 0 ? 0.7 : 1.1) * mesh.position(pushed));
    const std::vector<unsigned char> moved(mesh.vertexSlots(), 1);
    const auto expected = findSelfIntersections(mesh.positions(), mesh.faces());
    all += expected.size();
    REQUIRE(detector.detectMoved(mesh, moved) == expected);
  }
  CHECK(all > 100);
}

TEST_CASE("detection of what moved leaves out pairs of resting faces only") {
  const TriangleSoup s = zoo::overlappingSpheres(8);
  std::vector<unsigned char> moved(s.points.size(), 0);
  for (std::size_t v = 0; v < moved.size(); v += 11) moved[v] = 1;
  const auto isMoved = [&](int f) {
    const Triangle& t = s.triangles[f];
    return std::any_of(t.begin(), t.end(), [&](int v) { return moved[v] != 0; });
  };
  std::vector<FacePair> expected;
  for (const FacePair& p : find(s)) {
    if (isMoved(p.first) || isMoved(p.second)) expected.push_back(p);
  }
  CollisionDetector detector;
  CHECK(expected.size() < find(s).size());
  CHECK(detector.detectMoved(s.points, s.triangles, moved) == expected);
  CHECK(detector.detectMoved(Mesh(s), moved) == expected);
  CHECK(detector.detectMoved(s.points, s.triangles, std::vector<unsigned char>(moved.size(), 0)).empty());
}

TEST_CASE("nothing to look at is no intersection") {
  CHECK(find({}).empty());
  TriangleSoup s = zoo::sphere(1);
  for (Triangle& t : s.triangles) t = {-1, -1, -1};
  CHECK(find(s).empty());
  s.triangles.clear();
  CHECK(find(s).empty());
}

TEST_CASE("a mesh of one point intersects itself wherever it shares no vertex") {
  TriangleSoup s;
  s.points.assign(6, Vec3(1, 2, 3));
  s.triangles = {{0, 1, 2}, {3, 4, 5}, {0, 3, 4}};
  CHECK(find(s) == std::vector<FacePair>{{0, 1}});
}

TEST_CASE("one very long edge makes a large mesh neither slow nor wrong") {
  TriangleSoup s = zoo::sphere(70);
  s.points[1234] *= 1000;
  const auto start = std::chrono::steady_clock::now();
  CHECK(find(s).empty());
  // The quadratic way would look at 50,000² pairs and take minutes.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("the certificate counts the pairs and fails for them") {
  const Certificate good = certify(zoo::sphere(6));
  CHECK(good.selfIntersections == 0);
  CHECK(good.passes());
  const Certificate bad = certify(zoo::overlappingSpheres(6));
  CHECK(bad.selfIntersections == static_cast<int>(bruteForce(zoo::overlappingSpheres(6)).size()));
  CHECK(bad.closed);
  CHECK_FALSE(bad.passes());
}
