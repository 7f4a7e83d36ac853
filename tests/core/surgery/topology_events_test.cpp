// What the events of a change of topology say, and that it is true of the mesh.
#include <random>
#include <set>

#include "core/indices.h"
#include "core/mesh/topology.h"
#include "tests/core/surgery/adaptation_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

Mesh touchingSpheres() {
  return Mesh(zoo::both(zoo::sphere(8), zoo::moved(zoo::sphere(8), Vec3(1.95, 0.02, 0.01))));
}

AdaptationResult adaptSpheres(Mesh& mesh, const AdaptationSettings& settings) {
  std::vector<unsigned char> touched;
  return testing::adaptOnce(mesh, intersections(mesh), settings, touched);
}

bool isEmpty(const EventTrace& t) {
  return t.collidingFaces.empty() && t.lambda.empty() && t.refinedFaces.empty() && t.openedFaces.empty() &&
         t.boundaryLoops.empty() && t.handleFaces.empty() && t.closedFaces.empty();
}

//! Edges of the triangles that have only one of them, each as its two ends in order.
std::size_t borderEdges(const std::vector<std::array<Vec3, 3>>& faces) {
  const auto key = [](const Vec3& a, const Vec3& b) {
    std::array<double, 6> k{a[0], a[1], a[2], b[0], b[1], b[2]};
    const std::array<double, 6> r{b[0], b[1], b[2], a[0], a[1], a[2]};
    return std::min(k, r);
  };
  std::vector<std::array<double, 6>> edges;
  for (const auto& f : faces)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(key(f[i], f[(i + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  std::size_t single = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool before = i > 0 && edges[i - 1] == edges[i];
    const bool after = i + 1 < edges.size() && edges[i + 1] == edges[i];
    single += !before && !after;
  }
  return single;
}

using Point = std::array<double, 3>;
Point pointOf(const Vec3& p) { return {p[0], p[1], p[2]}; }

std::set<Point> pointsOf(const std::vector<std::array<Vec3, 3>>& faces) {
  std::set<Point> out;
  for (const auto& face : faces)
    for (const Vec3& p : face) out.insert(pointOf(p));
  return out;
}

std::vector<std::array<Vec3, 3>> facesOf(const Mesh& mesh) {
  std::vector<std::array<Vec3, 3>> out;
  for (const Triangle& t : mesh.compact().triangles)
    out.push_back({mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
  return out;
}

//! Faces of one part of a mesh, as if each collided with another: sets of all shapes.
std::vector<FacePair> madeUpCollisions(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const std::vector<int> distances = graphDistances(mesh, {static_cast<int>(seed)});
  std::vector<int> near;
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (distances[mesh.face(f)[0]] <= 6) near.push_back(f);
  std::vector<FacePair> pairs;
  for (unsigned i = 0; i < 2 + seed % 12; ++i) {
    const int f = near[random() % near.size()], g = near[random() % near.size()];
    if (f != g) pairs.push_back({std::min(f, g), std::max(f, g)});
  }
  return pairs;
}

}  // namespace

TEST_CASE("topology numbers agree with Euler's formula and the genus of known shapes") {
  const auto numbers = [](const TriangleSoup& s) { return text(topologyNumbers(Mesh(s))); };
  CHECK(numbers(zoo::sphere(4)) == "1 components, Euler 2, genus 0");
  CHECK(numbers(zoo::torus(9, 7, 2, 1)) == "1 components, Euler 0, genus 1");
  CHECK(numbers(zoo::both(zoo::sphere(4), zoo::moved(zoo::torus(9, 7, 2, 1), Vec3(9, 0, 0)))) ==
        "2 components, Euler 2, genus 1");
  CHECK(numbers({}) == "0 components, Euler 0, genus 0");
}

TEST_CASE("events carry the iteration that was set") {
  Mesh mesh = touchingSpheres();
  AdaptationSettings settings;
  settings.iteration = 17;
  const AdaptationResult result = adaptSpheres(mesh, settings);
  REQUIRE_FALSE(result.events.empty());
  for (const Event& e : result.events) CHECK(e.iteration == 17);
}

TEST_CASE("no trace is recorded unless it is asked for") {
  Mesh mesh = touchingSpheres();
  const AdaptationResult result = adaptSpheres(mesh, {});
  REQUIRE_FALSE(result.events.empty());
  for (const Event& e : result.events) CHECK(isEmpty(e.trace));
}

TEST_CASE("the trace of a handle holds its sets, its polygons and its faces, and they fit") {
  Mesh mesh = touchingSpheres();
  const auto pairs = intersections(mesh);
  AdaptationSettings settings;
  settings.recordTraces = true;
  const AdaptationResult result = adaptSpheres(mesh, settings);
  REQUIRE(result.events.size() == 1);
  const Event& e = result.events[0];
  REQUIRE(e.kind == EventKind::handleInserted);
  CHECK(e.trace.lambda.size() == 2);
  REQUIRE(e.trace.boundaryLoops.size() == 2);
  std::size_t corners = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(static_cast<int>(e.trace.boundaryLoops[i].size()) == e.loopSizes[i]);
    corners += e.trace.boundaryLoops[i].size();
  }
  std::vector<int> colliding;
  for (const auto& [f, g] : pairs) colliding.insert(colliding.end(), {f, g});
  sortUnique(colliding);
  CHECK(e.trace.collidingFaces.size() == colliding.size());
  CHECK(e.trace.handleFaces.size() == corners);        // a handle of two fronts has no Type 2 face
  CHECK(borderEdges(e.trace.handleFaces) == corners);  // and ends on the two polygons
  CHECK(e.faces.size() == corners);
  for (const Triangle& t : e.faces) {
    const std::array<Vec3, 3> face{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
    CHECK(std::count(e.trace.handleFaces.begin(), e.trace.handleFaces.end(), face) == 1);
  }
  CHECK_FALSE(e.trace.openedFaces.empty());
  CHECK(e.trace.refinedFaces.empty());  // the polygons are simple
}

TEST_CASE("where an opening is refined the trace shows it, and the colliding faces as they met") {
  const Mesh before(zoo::sphere(8));
  const auto wholes = facesOf(before);
  const std::set<Point> old = pointsOf(wholes);
  int refined = 0;
  for (unsigned seed = 1; refined < 2 && seed < 280; ++seed) {
    CAPTURE(seed);
    Mesh mesh = before;
    const std::vector<FacePair> pairs = madeUpCollisions(mesh, seed);
    AdaptationSettings settings;
    settings.outwardOnly = false;
    settings.recordTraces = true;
    settings.cameBack = [](const Vec3&) { return true; };  // it is cut and not smoothed
    std::vector<unsigned char> touched;
    const AdaptationResult result = adaptOnce(mesh, pairs, settings, touched);
    if (result.events.empty() || result.events[0].trace.refinedFaces.empty()) continue;
    ++refined;
    const EventTrace& t = result.events[0].trace;
    for (const auto& face : t.collidingFaces)
      REQUIRE(std::find(wholes.begin(), wholes.end(), face) != wholes.end());
    CHECK(t.refinedFaces.size() > t.openedFaces.size());
    for (const auto& face : t.openedFaces)
      REQUIRE(std::find(t.refinedFaces.begin(), t.refinedFaces.end(), face) != t.refinedFaces.end());
    const std::set<Point> shown = pointsOf(t.refinedFaces);
    int fresh = 0;
    for (const auto& loop : t.boundaryLoops)
      for (const Vec3& p : loop) {
        REQUIRE(shown.count(pointOf(p)) == 1);
        fresh += static_cast<int>(old.count(pointOf(p)) == 0);
      }
    CHECK(fresh >= 3);  // at least one polygon is new
  }
  CHECK(refined == 2);
}

TEST_CASE("the trace of a handle shows the closed mesh near the place") {
  Mesh mesh = touchingSpheres();
  AdaptationSettings settings;
  settings.recordTraces = true;
  const AdaptationResult result = adaptSpheres(mesh, settings);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].trace.closedFaces.size() ==
        result.events[0].trace.openedFaces.size() + result.events[0].trace.handleFaces.size());
}

TEST_CASE("a small component that collides as a whole is deleted, and an event says so") {
  // An icosahedron half in the large sphere: every vertex collides or is next to one that does.
  TriangleSoup small = zoo::scaled(zoo::sphere(1), 0.12);
  Mesh mesh(zoo::both(zoo::sphere(8), zoo::moved(small, Vec3(0.61, 0.48, 0.63) * 1.0)));
  REQUIRE_FALSE(intersections(mesh).empty());
  const AdaptationResult result = adaptFully(mesh);
  expectAdapted(mesh, 1, 0);
  CHECK(findComponents(mesh).extent[0] > 1.5);
  const auto removes = [](const Event& e) { return e.after.components < e.before.components; };
  CHECK(std::any_of(result.events.begin(), result.events.end(), removes));
}

TEST_CASE("a component that collides with itself everywhere and cannot be smoothed is deleted") {
  // A surface that winds twice round its axis: smoothing does not unwind it.
  Mesh mesh(zoo::both(zoo::sphere(5), zoo::moved(zoo::rose(9, 2), Vec3(5, 0, 0))));
  const AdaptationResult result = adaptFully(mesh);
  expectAdapted(mesh, 1, 0);
  const Event* deleted = findEvent(result, EventKind::componentDeleted);
  REQUIRE(deleted);
  CHECK((deleted->location - Vec3(5, 0, 0)).norm() < 0.5);
  CHECK(deleted->before.components == 2);
  CHECK(deleted->after.components == 1);
}

TEST_CASE("a small component that may be smoothed or deleted is smoothed, unless folds came back there") {
  // An icosahedron whose tip has come out at the far side: all of it collides or is next to what does.
  TriangleSoup small = zoo::scaled(zoo::sphere(1), 0.3);
  const TriangleSoup whole = zoo::both(zoo::sphere(5), zoo::moved(small, Vec3(3, 0, 0)));
  for (const bool cameBack : {false, true}) {
    Mesh mesh(whole);
    mesh.setPosition(vertexNear(mesh, Vec3(3, 0, 0.3)), Vec3(3, 0, -0.3));
    const auto pairs = intersections(mesh);
    REQUIRE_FALSE(pairs.empty());
    AdaptationSettings settings;
    if (cameBack) settings.cameBack = [](const Vec3&) { return true; };
    std::vector<unsigned char> touched;
    const AdaptationResult result = adaptOnce(mesh, pairs, settings, touched);
    CAPTURE(cameBack);
    REQUIRE(result.events.size() == 1);
    CHECK(result.events[0].kind == (cameBack ? EventKind::componentDeleted : EventKind::smoothed));
    expectAdapted(mesh, cameBack ? 1 : 2, 0);
  }
}

TEST_CASE("a component with a handle that is deleted counts in the event") {
  const TriangleSoup torus = zoo::perturbed(zoo::torus(7, 5, 1, 0.5), 1.5, 8);
  Mesh mesh(zoo::both(zoo::sphere(5), zoo::moved(torus, Vec3(9, 0, 0))));
  const AdaptationResult result = adaptFully(mesh);
  expectAdapted(mesh, 1, 0);
  CHECK(findEvent(result, EventKind::componentDeleted));
}

TEST_CASE("a handle that is taken out with a single cap counts in the event") {
  // A torus that is crumpled all over but for a disc: the opening is a torus less a disc, with one polygon,
  // and its cap leaves a sphere.
  TriangleSoup s = zoo::torus(24, 12, 2, 0.7);
  const TriangleSoup crumpled = zoo::perturbed(s, 0.9, 25);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if ((s.points[v] - Vec3(2.7, 0, 0)).norm() > 1.0) s.points[v] = crumpled.points[v];
  Mesh mesh(s);
  AdaptationSettings settings;
  settings.outwardOnly = false;
  const AdaptationResult result = adaptFully(mesh, settings);
  expectAdapted(mesh, 1, 0);
  const auto takesHandle = [](const Event& e) {
    return e.loopSizes.size() == 1 && e.before.genus == 1 && e.after.genus == 0;
  };
  CHECK(std::any_of(result.events.begin(), result.events.end(), takesHandle));
}

TEST_CASE("every kind of event has a name of its own") {
  std::set<std::string> names;
  for (EventKind kind :
       {EventKind::handleInserted, EventKind::split, EventKind::enclosedPartCutOff, EventKind::tunnelClosed,
        EventKind::componentDeleted, EventKind::smoothed, EventKind::rolledBack})
    names.insert(eventKindName(kind));
  CHECK(names.size() == 7);
}
