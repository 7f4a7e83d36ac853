// The surgery is broken on purpose, one way after another, between an attempt at a step and the check: each
// is caught, the step is taken back bit for bit, and what is left is valid.
#include <cmath>
#include <limits>

#include "core/collision/certify.h"
#include "core/evolution/adaptation_rounds.h"
#include "core/evolution/transaction.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/core/surgery/adaptation_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

using Tamper = std::function<void(Mesh&, Attempt&)>;

//! A valid mesh, and where a step moves its vertices.
struct Scene {
  Mesh start;
  std::vector<Vec3> goal;
};
Scene scene(const TriangleSoup& start, const TriangleSoup& goal) { return {Mesh(start), goal.points}; }

TriangleSoup spheres(double apart) {
  return zoo::both(zoo::sphere(6), zoo::moved(zoo::sphere(6), Vec3(apart, 0.02, 0.01)));
}
TriangleSoup turned(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}
Scene joining() { return scene(spheres(2.1), spheres(1.95)); }
Scene splitting() { return scene(cavityWithNeck(0.06), cavityWithNeck(-0.02)); }

//! What a step does: motion, detection and surgery until nothing intersects.
Attempt moveAndAdapt(Mesh& mesh, const std::vector<Vec3>& goal) {
  Attempt a;
  const TopologyNumbers before = topologyNumbers(mesh);
  for (std::size_t v = 0; v < goal.size(); ++v) mesh.setPosition(static_cast<int>(v), goal[v]);
  AdaptationResult result = adaptFully(mesh);
  a.events = std::move(result.events);
  a.conflicts = std::move(result.conflicts);
  a.touched.assign(mesh.vertexSlots(), 1);
  REQUIRE(a.conflicts.empty());
  REQUIRE_FALSE(a.events.empty());
  REQUIRE(a.events[0].before == before);
  return a;
}

struct Outcome {
  Mesh mesh;
  bool isKept = false;
  std::vector<Conflict> taken;  // back, in order
};

//! Only the first `times` attempts are tampered with.
Outcome step(const Scene& scene, const Tamper& tamper, int times) {
  Outcome out{scene.start, false, {}};
  int tries = 0;
  const auto attempt = [&] {
    Attempt a = moveAndAdapt(out.mesh, scene.goal);
    if (tries++ < times) tamper(out.mesh, a);
    return a;
  };
  Transaction transaction;
  const auto allowAll = [](const Attempt&) { return std::vector<HeldChange>(); };
  const Attempt last = transaction.run({out.mesh, topologyNumbers(scene.start), 0.3, 0.3, attempt, allowAll,
                                        [&](const Conflict& t) { out.taken.push_back(t); }});
  out.isKept = last.isKept();
  CHECK(transaction.volume() == Approx(signedVolume(out.mesh)));
  return out;
}

//! Never kept, whatever the mesh; and kept as soon as the surgery is whole again.
void expectCaught(const Scene& scene, FindingKind reason, const Tamper& tamper) {
  const Outcome never = step(scene, tamper, Transaction::kAttempts);
  CHECK_FALSE(never.isKept);
  REQUIRE(never.taken.size() >= static_cast<std::size_t>(Transaction::kAttempts));
  for (const Conflict& t : never.taken) {
    INFO(sentence(t.reason));
    CHECK(t.reason.kind == reason);
    CHECK(t.centre.allFinite());
    CHECK(t.radius > 0);
  }
  CHECK(isSame(never.mesh, scene.start));
  const Outcome once = step(scene, tamper, 1);
  CHECK(once.isKept);
  CHECK_FALSE(once.taken.empty());
  for (const Mesh* mesh : {&never.mesh, &once.mesh}) {
    expectValid(*mesh);
    CHECK(certify(mesh->compact()).boundsBody());
  }
}

int anyFace(const Mesh& mesh) {
  int f = mesh.faceSlots() / 2;
  while (!mesh.isFace(f)) ++f;
  return f;
}

std::vector<int> star(const Mesh& mesh, int v) {
  std::vector<int> faces;
  mesh.forEachOutgoing(v, [&](int h) { faces.push_back(Mesh::faceOf(h)); });
  return faces;
}

//! The middle of a cap: the vertex made last.
int capMiddle(const Mesh& mesh) {
  for (int v = mesh.vertexSlots() - 1;; --v)
    if (mesh.isVertex(v)) return v;
}

void add(Mesh& mesh, const TriangleSoup& more, Attempt& a) {
  std::vector<Triangle> faces = more.triangles;
  std::vector<int> slots;
  for (const Vec3& p : more.points) slots.push_back(mesh.addVertex(p));
  for (Triangle& t : faces)
    for (int& v : t) v = slots[v];
  mesh.addFaces(faces);
  a.touched.assign(mesh.vertexSlots(), 1);
}

//! An event that claims to have made a component of this Euler number.
void claim(Attempt& a, int components, int euler) {
  Event e = a.events.back();
  e.before = e.after;
  e.after.components += components;
  e.after.euler += euler;
  e.after.genus = e.after.components - e.after.euler / 2;
  a.events.push_back(e);
}

}  // namespace

TEST_CASE("a step whose surgery is whole is kept at the first attempt") {
  for (const Scene& s : {joining(), splitting()}) {
    REQUIRE(certify(s.start.compact()).boundsBody());
    const Outcome o = step(s, {}, 0);
    CHECK(o.isKept);
    CHECK(o.taken.empty());
    CHECK(certify(o.mesh.compact()).boundsBody());
  }
}

TEST_CASE("surgery that breaks the structure is caught: faces") {
  expectCaught(joining(), FindingKind::edgeWithOneFace, [](Mesh& mesh, Attempt&) {  // a flipped face
    const Triangle t = mesh.face(anyFace(mesh));
    mesh.removeFaces(std::vector{anyFace(mesh)});
    mesh.addFaces(std::vector<Triangle>{{t[0], t[2], t[1]}});
  });
  expectCaught(joining(), FindingKind::edgeWithOneFace, [](Mesh& mesh, Attempt&) {  // a doubled face
    mesh.addFaces(std::vector<Triangle>{mesh.face(anyFace(mesh))});
  });
  expectCaught(splitting(), FindingKind::edgeWithOneFace, [](Mesh& mesh, Attempt&) {  // a dropped cap
    const int v = capMiddle(mesh);
    mesh.removeFaces(star(mesh, v));
    mesh.removeVertex(v);
  });
  expectCaught(splitting(), FindingKind::edgeWithOneFace, [](Mesh& mesh, Attempt&) {  // a cap inside out
    const std::vector<int> faces = star(mesh, capMiddle(mesh));
    std::vector<Triangle> cap;
    for (const int f : faces) cap.push_back({mesh.face(f)[0], mesh.face(f)[2], mesh.face(f)[1]});
    mesh.removeFaces(faces);
    mesh.addFaces(cap);
  });
  expectCaught(joining(), FindingKind::facesTwice, [](Mesh& mesh, Attempt& a) {
    add(mesh, {{{9, 0, 0}, {10, 0, 0}, {9, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, a);  // a flat pillow
    claim(a, 1, 2);
  });
}

TEST_CASE("surgery that breaks the structure is caught: vertices and edges") {
  expectCaught(joining(), FindingKind::severalFans, [](Mesh& mesh, Attempt&) {  // two vertices welded
    TriangleSoup s = mesh.compact();
    const int last = static_cast<int>(s.points.size()) - 1;
    for (Triangle& t : s.triangles)
      for (int& v : t)
        if (v == last) v = 0;
    mesh = Mesh(s);
    mesh.removeVertex(last);
  });
  expectCaught(joining(), FindingKind::vertexWithoutFace, [](Mesh& mesh, Attempt&) {
    mesh.addVertex({9, 0, 0});
  });
}

TEST_CASE("surgery that does something else than its events say is caught") {
  expectCaught(joining(), FindingKind::otherEuler,  // a handle more than it says
               [](Mesh&, Attempt& a) { a.events.back().after.euler += 2; });
  expectCaught(joining(), FindingKind::otherEuler, [](Mesh&, Attempt& a) { a.events.clear(); });
  expectCaught(joining(), FindingKind::eventsDisagree,
               [](Mesh&, Attempt& a) { a.events.push_back(a.events.back()); });
  expectCaught(joining(), FindingKind::otherComponents, [](Mesh&, Attempt& a) {
    a.events.back().after.components += 1;  // two fronts of one component, it says: the same Euler number
    a.events.back().after.genus += 1;
  });
  expectCaught(joining(), FindingKind::otherComponents, [](Mesh& mesh, Attempt& a) {  // a torus from nowhere
    add(mesh, zoo::moved(zoo::torus(9, 7, 2, 1), Vec3(0, 0, 9)), a);
  });
}

TEST_CASE("a handle that joins another polygon than its event says is caught") {
  // The tips of a bent tube meet; beside it lies a ball. The tampered surgery joins the tube with the ball.
  const auto tubeAndBall = [](double overlap, double x) {
    return zoo::both(bentTube(overlap), zoo::moved(zoo::scaled(zoo::sphere(3), 0.4), Vec3(x, 0.03, 0.02)));
  };
  const TriangleSoup apart = tubeAndBall(-0.6, -2.5), tips = tubeAndBall(0.05, -2.5);
  const TriangleSoup wrong = tubeAndBall(-0.6, -1.62);
  expectCaught(scene(apart, tips), FindingKind::otherComponents, [&](Mesh& mesh, Attempt& a) {
    Mesh other(apart);
    const Attempt joined = moveAndAdapt(other, wrong.points);
    REQUIRE(joined.events.back().after.euler == a.events.back().after.euler);
    REQUIRE(joined.events.back().after.components != a.events.back().after.components);
    mesh = other;
    a.touched.assign(mesh.vertexSlots(), 1);
  });
}

TEST_CASE("components that lie in each other as no body's do are caught") {
  expectCaught(joining(), FindingKind::bodyInBody, [](Mesh& mesh, Attempt& a) {
    add(mesh, zoo::scaled(zoo::sphere(2), 0.3), a);  // floats in the first ball
    claim(a, 1, 2);
  });
  expectCaught(joining(), FindingKind::cavityOutside, [](Mesh& mesh, Attempt& a) {
    add(mesh, turned(zoo::moved(zoo::scaled(zoo::sphere(2), 0.3), Vec3(0, 0, 5))), a);
    claim(a, 1, 2);
  });
  // The body of a cavity goes, and says so, but the cavity stays. A larger ball keeps the volume positive.
  const auto hollow = [](double neck) {
    return zoo::both(cavityWithNeck(neck), zoo::moved(zoo::scaled(zoo::sphere(8), 3), Vec3(9, 0, 0)));
  };
  expectCaught(scene(hollow(0.06), hollow(-0.02)), FindingKind::cavityOutside, [](Mesh& mesh, Attempt& a) {
    deleteComponent(mesh, 0);
    claim(a, -1, -2);
  });
}

TEST_CASE("what changes behind the back of the detection, and what is no surface, is caught") {
  constexpr FindingKind kUnseen = FindingKind::unseenChange;
  expectCaught(joining(), kUnseen, [](Mesh& mesh, Attempt& a) {
    mesh.setPosition(3, mesh.position(3) * 1.01);
    a.touched[3] = 0;
  });
  expectCaught(joining(), kUnseen, [](Mesh& mesh, Attempt& a) {
    // As if the step had moved nothing there, but turned an edge.
    std::fill(a.touched.begin(), a.touched.end(), static_cast<unsigned char>(0));
    int h = 0;
    while (!mesh.isFace(Mesh::faceOf(h)) || !mesh.canFlip(h)) ++h;
    mesh.flipEdge(h);
  });
  expectCaught(joining(), FindingKind::enclosesNothing, [](Mesh& mesh, Attempt&) {
    const TriangleSoup s = mesh.compact();
    mesh = Mesh(turned(s));
    for (int v = mesh.vertexSlots() - 1; v >= 0; --v) mesh.setPosition(v, s.points[v]);
  });
  expectCaught(joining(), FindingKind::enclosesNothing, [](Mesh& mesh, Attempt&) {
    mesh.setPosition(mesh.face(anyFace(mesh))[0], Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  });
}

namespace {

//! The first vertex that surgery has not marked. In joining() all were moved, and marked, before it.
int unmarked(const Mesh& mesh, const VertexMarks& marks) {
  int v = 0;
  while (!mesh.isVertex(v) || marks[v] != 0) ++v;
  return v;
}

AdaptationResult thenMoves(Mesh& mesh, std::span<const FacePair> pairs, const AdaptationSettings& settings,
                           VertexMarks& touched) {
  AdaptationResult result = adaptTopology(mesh, pairs, settings, touched);
  const int v = unmarked(mesh, touched);
  mesh.setPosition(v, mesh.position(v) * 1.01);
  return result;
}

AdaptationResult thenFlips(Mesh& mesh, std::span<const FacePair> pairs, const AdaptationSettings& settings,
                           VertexMarks& touched) {
  AdaptationResult result = adaptTopology(mesh, pairs, settings, touched);
  const auto isMarked = [&](int v) { return touched[v] != 0; };
  int h = 0;
  while (!mesh.isFace(Mesh::faceOf(h)) || !mesh.canFlip(h) || isMarked(mesh.origin(h)) ||
         isMarked(mesh.target(h)) || isMarked(mesh.target(Mesh::next(h))) ||
         isMarked(mesh.target(Mesh::next(mesh.opposite(h)))))
    ++h;
  mesh.flipEdge(h);
  return result;
}

Attempt adaptBy(AdaptationRounds::Surgery surgery) {
  const Scene s = joining();
  Mesh mesh = s.start;
  for (std::size_t v = 0; v < s.goal.size(); ++v) mesh.setPosition(static_cast<int>(v), s.goal[v]);
  Attempt a;
  a.touched.assign(mesh.vertexSlots(), 1);
  CollisionDetector detector;
  AdaptationSettings settings;
  settings.topology = topologyNumbers(s.start);
  AdaptationRounds(surgery).run(mesh, detector, settings, 0.3, a);
  return a;
}

}  // namespace

TEST_CASE("what surgery changes without a word is caught also where the step had moved it before") {
  const Attempt whole = adaptBy(adaptTopology);
  CHECK(whole.conflicts.empty());
  CHECK_FALSE(whole.events.empty());
  for (const AdaptationRounds::Surgery broken : {thenMoves, thenFlips}) {
    const Attempt a = adaptBy(broken);
    REQUIRE(a.conflicts.size() == 1);
    CHECK(a.conflicts[0].reason.kind == FindingKind::unseenChange);
  }
}

namespace {

//! A body of radius 1 and a small one beside it, which a step may take anywhere while it smooths a fold.
struct BodyAndPart {
  Mesh mesh{zoo::both(zoo::sphere(6), zoo::moved(zoo::scaled(zoo::sphere(3), 0.1), Vec3(1.5, 0, 0)))};
  Transaction transaction;
  int whole = static_cast<int>(zoo::sphere(6).points.size());  // vertices of the body

  Event fold(const std::vector<int>& loopSizes) const {
    Event e;
    e.before = e.after = topologyNumbers(mesh);
    e.loopSizes = loopSizes;
    return e;
  }
  //! Vertices from `first` to before `end` are moved.
  Attempt step(int first, int end, const Vec3& by, const std::vector<int>& loopSizes = {}) {
    constexpr double kEdge = 0.05;  // shorter than they are: so that the margin ends between the two
    const auto attempt = [&] {
      Attempt a;
      a.touched.assign(static_cast<std::size_t>(mesh.vertexSlots()), 0);
      for (int v = first; v < end; ++v) {
        mesh.setPosition(v, mesh.position(v) + by);
        a.touched[v] = 1;
      }
      a.events = {fold(loopSizes)};
      return a;
    };
    const auto allowAll = [](const Attempt&) { return std::vector<HeldChange>(); };
    return transaction.run(
        {mesh, topologyNumbers(mesh), kEdge, kEdge, attempt, allowAll, [](const Conflict&) {}});
  }
};

}  // namespace

TEST_CASE(
    "a fold that takes a component into another one is taken back, also where all were known to be far") {
  BodyAndPart b;
  const int all = b.mesh.vertexSlots();
  REQUIRE(b.step(0, 1, Vec3(-1e-3, 0, 0), {3}).isKept());  // as after surgery: all components are looked at
  REQUIRE(b.step(0, 1, Vec3(1e-3, 0, 0)).isKept());        // far from the part
  const Mesh before = b.mesh;
  const Attempt swallowed = b.step(b.whole, all, Vec3(-1.5, 0, 0));
  CHECK_FALSE(swallowed.isKept());
  CHECK(swallowed.conflicts[0].reason.kind == FindingKind::bodyInBody);
  CHECK(isSame(b.mesh, before));
  CHECK(b.step(b.whole, all, Vec3(0.2, 0, 0)).isKept());
}

TEST_CASE("a fold that moves the surface past a component is taken back") {
  BodyAndPart b;
  REQUIRE(b.step(0, 1, Vec3(-1e-3, 0, 0), {3}).isKept());
  const Attempt passed = b.step(0, b.whole, Vec3(1.5, 0, 0));  // now the part lies in the middle of the body
  CHECK_FALSE(passed.isKept());
  CHECK(passed.conflicts[0].reason.kind == FindingKind::bodyInBody);
}
