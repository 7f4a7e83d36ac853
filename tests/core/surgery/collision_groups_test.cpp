#include "core/surgery/collision_groups.h"

#include <set>

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

using namespace handlebody;
using testing::graphDistances;

namespace {

std::vector<int> cornersOf(const Mesh& mesh, int f) { return {mesh.face(f).begin(), mesh.face(f).end()}; }

//! A face whose corners are all at least `distance` from those of f, and one of them no further.
int faceAtDistance(const Mesh& mesh, int f, int distance) {
  const std::vector<int> d = graphDistances(mesh, cornersOf(mesh, f));
  for (int g = 0; g < mesh.faceSlots(); ++g) {
    int nearest = 1000;
    for (int v : mesh.face(g)) nearest = std::min(nearest, d[v]);
    if (nearest == distance) return g;
  }
  return -1;
}

std::size_t countSets(const std::vector<CollisionGroup>& groups) {
  std::size_t n = 0;
  for (const CollisionGroup& g : groups) n += g.lambda.size();
  return n;
}

std::vector<FacePair> randomPairs(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<FacePair> pairs;
  const auto face = [&] { return static_cast<int>(random() % static_cast<unsigned>(mesh.faceSlots())); };
  while (static_cast<int>(pairs.size()) < count) {
    const int f = face(), g = face();
    if (f != g) pairs.emplace_back(std::min(f, g), std::max(f, g));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool isConnected(const Mesh& mesh, const std::vector<int>& set) {
  std::vector<int> reached{set[0]};
  for (std::size_t i = 0; i < reached.size(); ++i)
    mesh.forEachNeighbour(reached[i], [&](int w) {
      if (std::binary_search(set.begin(), set.end(), w) &&
          std::find(reached.begin(), reached.end(), w) == reached.end())
        reached.push_back(w);
    });
  return reached.size() == set.size();
}

//! Two sets with a vertex of one next to, or at distance 2 from, a vertex of the other.
bool shareNeighbour(const Mesh& mesh, const std::vector<int>& a, const std::vector<int>& b) {
  const std::vector<int> ringA = enlarge(mesh, a), ringB = enlarge(mesh, b);
  std::vector<int> common;
  std::set_intersection(ringA.begin(), ringA.end(), ringB.begin(), ringB.end(), std::back_inserter(common));
  return !common.empty();
}

}  // namespace

TEST_CASE("no pairs make no groups") { CHECK(groupCollisions(Mesh(zoo::sphere(3)), {}).empty()); }

TEST_CASE("colliding faces at graph distance two belong to one set, at distance three to two") {
  const Mesh mesh(zoo::sphere(12));
  for (int distance : {0, 1, 2, 3, 4}) {
    CAPTURE(distance);
    const std::vector<FacePair> pair{{0, faceAtDistance(mesh, 0, distance)}};
    const auto groups = groupCollisions(mesh, pair);
    REQUIRE(groups.size() == 1);
    CHECK(groups[0].lambda.size() == (distance <= 2 ? 1 : 2));
  }
}

TEST_CASE("a set at graph distance two gets the vertices between, so that it is connected") {
  const Mesh mesh(zoo::sphere(12));
  const int other = faceAtDistance(mesh, 0, 2);
  const auto groups = groupCollisions(mesh, std::vector<FacePair>{{0, other}});
  REQUIRE(groups[0].lambda.size() == 1);
  CHECK(groups[0].lambda[0].size() == 7);  // six corners and one vertex between
  CHECK(isConnected(mesh, groups[0].lambda[0]));
}

TEST_CASE("pairs far from each other make groups of their own, in the order of their lowest vertex") {
  const Mesh mesh(zoo::both(zoo::sphere(10), zoo::moved(zoo::sphere(10), Vec3(1.9, 0, 0))));
  const int n = mesh.faceSlots() / 2;
  const int far = faceAtDistance(mesh, 0, 8);
  const auto groups = groupCollisions(mesh, std::vector<FacePair>{{far, n + far}, {0, n}});
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].lambda.size() == 2);
  CHECK(groups[1].lambda.size() == 2);
  CHECK(groups[0].lambda[0][0] < groups[1].lambda[0][0]);
  CHECK(groups[0].pairs.size() == 1);
  CHECK(groups[1].pairs.size() == 1);
}

TEST_CASE("sets that collide with a common set form one group") {
  const Mesh mesh(zoo::sphere(14));
  const int a = 0, b = faceAtDistance(mesh, 0, 6), c = faceAtDistance(mesh, 0, 13);
  REQUIRE(c >= 0);
  const auto groups = groupCollisions(mesh, std::vector<FacePair>{{a, b}, {b, c}});
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].lambda.size() == 3);
  CHECK(groups[0].pairs.size() == 2);
}

TEST_CASE("of random pairs every colliding vertex is in one set and every pair in one group") {
  const Mesh mesh(zoo::sphere(16));
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const auto pairs = randomPairs(mesh, 1 + static_cast<int>(seed), seed);
    const auto groups = groupCollisions(mesh, pairs);
    std::multiset<int> grouped;
    std::vector<FacePair> found;
    for (const CollisionGroup& g : groups) {
      found.insert(found.end(), g.pairs.begin(), g.pairs.end());
      for (const auto& lambda : g.lambda) {
        CHECK(std::is_sorted(lambda.begin(), lambda.end()));
        grouped.insert(lambda.begin(), lambda.end());
      }
    }
    std::sort(found.begin(), found.end());
    CHECK(found == pairs);
    CHECK(std::set<int>(grouped.begin(), grouped.end()).size() == grouped.size());
    for (const auto& [f, g] : pairs)
      for (int face : {f, g})
        for (int v : mesh.face(face)) REQUIRE(grouped.count(v) == 1);
  }
}

TEST_CASE(
    "of random pairs every set is connected, and corners of faces in different sets are further apart") {
  const Mesh mesh(zoo::sphere(16));
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const auto pairs = randomPairs(mesh, 1 + static_cast<int>(seed), seed);
    for (const CollisionGroup& g : groupCollisions(mesh, pairs))
      for (const auto& lambda : g.lambda) REQUIRE(isConnected(mesh, lambda));
  }
}

TEST_CASE("vertices of two sets never have a common neighbour, whatever the pairs") {
  const Mesh mesh(zoo::sphere(16));
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const auto groups = groupCollisions(mesh, randomPairs(mesh, 1 + static_cast<int>(seed), seed));
    std::vector<std::vector<int>> sets;
    for (const CollisionGroup& g : groups) sets.insert(sets.end(), g.lambda.begin(), g.lambda.end());
    CHECK(sets.size() == countSets(groups));
    int tooClose = 0;
    for (std::size_t i = 0; i < sets.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) tooClose += shareNeighbour(mesh, sets[i], sets[j]);
    CHECK(tooClose == 0);
  }
}
