// Three and more fronts that meet at one place in one step.
#include "core/surgery/front_gathering.h"
#include "tests/core/surgery/adaptation_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! A gap at which neighbouring tips of `meridians` overlap a little: their round ends of radius 0.25 touch
//! where the tips are 0.25 · (1 / sin(π / count) - 1) from the axis.
double meetingGap(int count) { return 0.25 * (1 / std::sin(std::numbers::pi / count) - 1) - 0.04; }

std::vector<const Event*> handlesOf(const AdaptationResult& result) {
  std::vector<const Event*> out;
  for (const Event& e : result.events)
    if (e.kind == EventKind::handleInserted) out.push_back(&e);
  return out;
}

void expectJoinedAtOnce(int fronts, int finer) {
  CAPTURE(fronts, finer);
  Mesh mesh(meridians(fronts, meetingGap(fronts) + (finer > 1 ? 0.02 : 0), finer));
  REQUIRE_FALSE(intersections(mesh).empty());
  REQUIRE(topologyNumbers(mesh).components == fronts);
  const AdaptationResult result = adaptFully(mesh);
  CHECK(result.conflicts.empty());
  expectAdapted(mesh, 1, fronts - 1);
  const auto handles = handlesOf(result);
  REQUIRE(handles.size() == 2);
  for (const Event* e : handles) {
    CHECK(e->fronts == fronts);
    CHECK(e->loopSizes.size() == static_cast<std::size_t>(fronts));
    CHECK(std::abs(std::abs(e->location.z()) - 1) < 0.1);
    CHECK(std::hypot(e->location.x(), e->location.y()) < 0.1);
  }
  // One handle makes one component of all; the other adds fronts - 1 tunnels (Theorem 6).
  CHECK(handles[0]->after.components == 1);
  CHECK(handles[0]->after.genus == 0);
  CHECK(handles[1]->after.genus == fronts - 1);
}

}  // namespace

TEST_CASE("three fronts that meet in one step are joined by one handle, and the genus rises by two") {
  expectJoinedAtOnce(3, 1);
  expectJoinedAtOnce(3, 2);
}

TEST_CASE("four fronts that meet in one step are joined by one handle, and the genus rises by three") {
  expectJoinedAtOnce(4, 1);
  expectJoinedAtOnce(4, 2);
}

TEST_CASE("of five fronts four are joined at once, and an event says that one waits") {
  Mesh mesh(meridians(5, meetingGap(5)));
  const AdaptationResult result = adaptFully(mesh);
  CHECK(result.conflicts.empty());
  const auto handles = handlesOf(result);
  REQUIRE(handles.size() == 2);  // one for each pole
  for (const Event* e : handles) {
    CHECK(e->fronts == 4);
    REQUIRE_FALSE(e->reasons.empty());
    CHECK(e->reasons[0].kind == FindingKind::frontsWait);
    CHECK(e->reasons[0].number("left") == 1);
    CHECK(sentence(e->reasons).find("of 5 fronts 1 left") != std::string::npos);
  }
  // The fifth touches nothing any more, and stays a body of its own; the four have three tunnels (Theorem 6).
  expectAdapted(mesh, 2, 3);
}

TEST_CASE("the trace of a handle of four fronts shows four polygons and the faces between them") {
  Mesh mesh(meridians(4, meetingGap(4)));
  AdaptationSettings settings;
  settings.recordTraces = true;
  const AdaptationResult result = adaptFully(mesh, settings);
  const auto handles = handlesOf(result);
  REQUIRE(handles.size() == 2);
  for (const Event* e : handles) {
    REQUIRE(e->trace.boundaryLoops.size() == 4);
    std::size_t corners = 0;
    for (const auto& loop : e->trace.boundaryLoops) corners += loop.size();
    CHECK(e->trace.handleFaces.size() == corners + 4);  // 2k - 4 of Type 2
  }
}

TEST_CASE("places far from each other are not gathered, and two fronts stay two") {
  const Mesh three(meridians(3, meetingGap(3)));
  const auto pairs = intersections(three);
  const auto groups = groupCollisions(three, pairs);
  const auto gathered = gatherFronts(three, groups, 10);
  REQUIRE(gathered.size() == 2);  // one for each pole
  std::size_t collisions = 0;
  for (const Gathering& g : gathered) {
    CHECK(g.whole.lambda.size() == 3);
    collisions += g.whole.pairs.size();
  }
  CHECK(collisions == pairs.size());

  const Mesh two(meridians(2, -0.02));
  const auto twoGroups = groupCollisions(two, intersections(two));
  const auto asFound = gatherFronts(two, twoGroups, 10);
  REQUIRE(asFound.size() == twoGroups.size());
  for (std::size_t i = 0; i < asFound.size(); ++i) {
    CHECK(asFound[i].parts.empty());
    CHECK(asFound[i].whole.lambda == twoGroups[i].lambda);
  }
}

TEST_CASE("fronts are gathered only within reach, and their sets are connected") {
  // Three spheres, each of which collides with each other one, at places five edges from each other.
  const Mesh sphere(zoo::sphere(12));
  const std::vector<int> d = graphDistances(sphere, {sphere.face(0).begin(), sphere.face(0).end()});
  int far = 0;
  const auto nearest = [&](int f) {
    int least = 1000;
    for (int v : sphere.face(f)) least = std::min(least, d[v]);
    return least;
  };
  while (nearest(far) != 5) ++far;
  const TriangleSoup one = zoo::sphere(12);
  const Mesh mesh(zoo::both(zoo::both(one, zoo::moved(one, Vec3(3, 0, 0))), zoo::moved(one, Vec3(6, 0, 0))));
  const int n = sphere.faceSlots();
  const auto groups =
      groupCollisions(mesh, std::vector<FacePair>{{0, n + far}, {n, 2 * n + far}, {far, 2 * n}});
  REQUIRE(groups.size() == 3);
  CHECK(gatherFronts(mesh, groups, 4).size() == 3);
  const auto gathered = gatherFronts(mesh, groups, 5);
  REQUIRE(gathered.size() == 1);
  CHECK(gathered[0].parts.size() == 3);
  CHECK(gathered[0].whole.pairs.size() == 3);
  REQUIRE(gathered[0].whole.lambda.size() == 3);
  for (const auto& lambda : gathered[0].whole.lambda) {
    CHECK(std::is_sorted(lambda.begin(), lambda.end()));
    CHECK(lambda.size() == 3 + 3 + 4);  // the corners of both faces, and what lies between them
    std::vector<int> reached{lambda[0]};
    for (std::size_t i = 0; i < reached.size(); ++i)
      mesh.forEachNeighbour(reached[i], [&](int w) {
        if (std::binary_search(lambda.begin(), lambda.end(), w) &&
            std::find(reached.begin(), reached.end(), w) == reached.end())
          reached.push_back(w);
      });
    CHECK(reached.size() == lambda.size());
  }
}
