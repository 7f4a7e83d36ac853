// What the surface may not do, in the window's document: undone, saved, opened again.

#include <algorithm>
#include <set>

#include "core/collision/certify.h"
#include "core/evolution/painted_walls.h"
#include "core/io/report/report.h"
#include "core/io/report/session.h"
#include "tests/ui/model/document_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct Grown {
  TorusFile torus;
  Document document;

  Grown() {
    REQUIRE(openAndWait(document, torus.path));
    document.addSeed(torus.seed);
    REQUIRE(runToEnd(document));
  }
  int meeting() const {
    const auto& events = document.events();
    const auto at = std::find_if(events.begin(), events.end(),
                                 [](const Event& e) { return e.kind == EventKind::handleInserted; });
    REQUIRE(at != events.end());
    return static_cast<int>(at - events.begin());
  }
  int genus() const { return document.snapshot()->certificate.genus.at(0); }
  bool save(const QString& path) {
    bool saved = false;
    const auto done = QObject::connect(&document, &Document::sessionSaved, [&] { saved = true; });
    document.saveSession(path);
    const bool ended = waitFor([&] { return saved; });
    QObject::disconnect(done);
    return ended;
  }
};

}  // namespace

TEST_CASE("a change of topology is forbidden from the step before on, and undo brings it back",
          "[document]") {
  Grown grown;
  Document& document = grown.document;
  const Event event = document.events()[grown.meeting()];
  document.forbid(grown.meeting());
  REQUIRE(waitFor([&] { return document.iteration() == event.iteration - 1; }));
  const TriangleSoup before = document.snapshot()->mesh;
  REQUIRE(runToEnd(document));
  CHECK(grown.genus() == 0);
  REQUIRE(document.snapshot()->held.size() == 1);
  CHECK(document.snapshot()->held[0].isVetoed);
  const TriangleSoup apart = document.snapshot()->mesh;

  document.undoStack()->undo();
  REQUIRE(waitFor([&] { return document.iteration() == event.iteration - 1; }));
  CHECK(isSame(document.snapshot()->mesh, before));
  CHECK(document.constraints().empty());
  REQUIRE(runToEnd(document));
  CHECK(grown.genus() == 1);

  document.undoStack()->redo();
  REQUIRE(showIteration(document, event.iteration - 1));
  REQUIRE(runToEnd(document));
  CHECK(isSame(document.snapshot()->mesh, apart));
}

TEST_CASE("a part is pinned as it is shown, kept in a session, and freed by undo", "[document]") {
  Grown grown;
  Document& document = grown.document;
  const int middle = document.lastIteration() / 2;
  REQUIRE(showIteration(document, middle));
  const TriangleSoup before = document.snapshot()->mesh;
  const Vec3 centre = before.points.front();
  const auto held = [&](const TriangleSoup& mesh) {  // of the vertices in the ball, as they were
    int count = 0;
    for (const Vec3& p : before.points)
      count += (p - centre).norm() <= 3 &&
               std::find(mesh.points.begin(), mesh.points.end(), p) != mesh.points.end();
    return count;
  };
  const int all = held(before);
  REQUIRE(all > 3);
  REQUIRE(document.pin(centre, 3));
  CHECK(document.undoStack()->undoText() == "Pin here");
  CHECK(document.constraints().pins == std::vector<Pin>{{centre, 3, middle}});
  REQUIRE(runToEnd(document));
  CHECK(document.lastIteration() > middle);
  CHECK(held(document.snapshot()->mesh) == all);
  REQUIRE(document.snapshot()->pinned.size() == 1);
  CHECK(document.snapshot()->pinned[0].vertices == all);

  const QString path = grown.torus.file("pinned.json");
  REQUIRE(grown.save(path));
  Document again;
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(again.constraints() == document.constraints());
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));

  document.undoStack()->undo();
  CHECK(document.constraints().empty());
  REQUIRE(showIteration(document, middle));
  CHECK(isSame(document.snapshot()->mesh, before));
  REQUIRE(runToEnd(document));
  CHECK(held(document.snapshot()->mesh) < all);
}

TEST_CASE("a stroke over the surface is one entry of the undo list, holds what it covers, and is replayed",
          "[document][pins]") {
  Grown grown;
  Document& document = grown.document;
  const int middle = document.lastIteration() / 2;
  REQUIRE(showIteration(document, middle));
  const TriangleSoup before = document.snapshot()->mesh;
  const auto nearest = [&](const Vec3& place) {
    return *std::min_element(before.points.begin(), before.points.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - place).squaredNorm() < (b - place).squaredNorm();
    });
  };
  const Vec3 from = before.points.front(), to = nearest(from + Vec3(4, 4, 0));
  std::vector<WallBall> stroke;
  for (const Vec3& p : {from, to, Vec3(to + Vec3(0, 0, 40))}) drawTo(stroke, p, 2);  // and off it
  const int entries = document.undoStack()->count();
  REQUIRE(document.pin(stroke));
  CHECK(document.undoStack()->count() == entries + 1);
  CHECK(document.undoStack()->undoText() == "Pin");
  const std::vector<Pin> pins = document.constraints().pins;
  CHECK(pins.size() > 1);
  CHECK(pins.size() < stroke.size());  // those in the air hold nothing
  std::set<std::array<double, 3>> covered;
  for (const Vec3& p : before.points)
    if (std::any_of(stroke.begin(), stroke.end(),
                    [&](const WallBall& b) { return (p - b.centre).norm() <= b.radius; }))
      covered.insert({p.x(), p.y(), p.z()});
  REQUIRE(runToEnd(document));
  CHECK(document.lastIteration() > middle);
  // Exactly those are held, bit for bit, and the snapshot tells which.
  const MeshSnapshot& end = *document.snapshot();
  REQUIRE(end.pinnedVertices.size() == end.mesh.points.size());
  std::set<std::array<double, 3>> held;
  for (std::size_t v = 0; v < end.mesh.points.size(); ++v) {
    const Vec3& p = end.mesh.points[v];
    if (end.pinnedVertices[v]) held.insert({p.x(), p.y(), p.z()});
  }
  CHECK(held == covered);

  const QString path = grown.torus.file("strokes.json");
  REQUIRE(grown.save(path));
  Document again;
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(again.constraints().pins == pins);
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));

  // The eraser takes those whose vertices it covers.
  document.unpin({{to, 0.5}});
  CHECK(document.undoStack()->undoText() == "Unpin");
  CHECK(document.constraints().pins.size() < pins.size());
  CHECK(document.constraints().pins.front() == pins.front());
  document.undoStack()->undo();
  CHECK(document.constraints().pins == pins);
  const int known = document.undoStack()->count();
  document.unpin({{testing::kMiddle, 0.5}});  // meets nothing: no entry
  CHECK(document.undoStack()->count() == known);
}

TEST_CASE("a pin that would hold nothing, is there already, or is of a locked object is refused",
          "[document]") {
  Grown grown;
  Document& document = grown.document;
  QStringList refused;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { refused << why; });
  const Vec3 centre = document.snapshot()->mesh.points.front();
  CHECK_FALSE(document.pin(testing::kMiddle, 0.5));
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].contains("nothing is pinned"));
  CHECK(document.constraints().empty());
  REQUIRE(document.pin(centre, 2));
  const int entries = document.undoStack()->count();
  CHECK_FALSE(document.pin(centre, 2));
  REQUIRE(refused.size() == 2);
  CHECK(refused[1].contains("pinned already"));
  document.duplicateObject(0);
  CHECK(document.constraints().empty());  // its surface is another one
  document.setActiveObject(0);
  document.setObjectLocked(0, true);
  CHECK_FALSE(document.pin(centre, 3));
  CHECK(refused.size() == 3);
  CHECK(document.constraints().pins.size() == 1);
  CHECK(entries < document.undoStack()->count());  // of duplicating alone
}

TEST_CASE("what was held may happen from the shown iteration on", "[document]") {
  Grown grown;
  Document& document = grown.document;
  document.forbid(grown.meeting());
  REQUIRE(runToEnd(document));
  REQUIRE(grown.genus() == 0);
  document.allow(document.snapshot()->held.at(0));
  CHECK(document.constraints().vetoes.empty());
  CHECK(document.state() == GrowthState::paused);
  REQUIRE(runToEnd(document));
  CHECK(grown.genus() == 1);
  CHECK(document.snapshot()->held.empty());
}

namespace {

Constraints asking() {
  Constraints c;
  c.topology.genus = 0;
  c.topology.asks = true;
  return c;
}

QStringList marksAt(const Document& document, int iteration) {
  for (const ChangeMark& mark : document.changeMarks())
    if (mark.iteration == iteration) return mark.what;
  return {};
}

}  // namespace

TEST_CASE("the growth pauses where a limit that asks holds something, and goes on with the answer",
          "[document][ask]") {
  const bool allows = GENERATE(true, false);
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  document.setConstraints(asking(), "Ask");
  int told = 0;
  QObject::connect(&document, &Document::asked, [&] { ++told; });
  document.run();
  REQUIRE(waitFor([&] { return told > 0 && isAtRest(document); }));
  CHECK(document.state() == GrowthState::paused);
  REQUIRE(document.openQuestions().size() == 1);
  const HeldPlace question = document.openQuestions()[0];
  CHECK(question.iteration == document.iteration());

  allows ? document.allow(question) : document.keepHeld(question);
  CHECK(document.undoStack()->undoText() == (allows ? "Let it happen" : "Hold it"));
  CHECK(document.openQuestions().empty());
  document.undoStack()->undo();
  CHECK(document.openQuestions().size() == 1);
  document.undoStack()->redo();
  REQUIRE(runToEnd(document));
  CHECK(told == 1);
  CHECK(document.openQuestions().empty());
  CHECK(document.snapshot()->certificate.genus.at(0) == (allows ? 1 : 0));
  CHECK(marksAt(document, question.iteration) ==
        QStringList(allows ? "Decided: let it happen" : "Decided: hold it"));

  // The session has the answer, and making it again asks nobody.
  const QString path = torus.file("asked.json");
  bool saved = false;
  QObject::connect(&document, &Document::sessionSaved, [&] { saved = true; });
  document.saveSession(path);
  REQUIRE(waitFor([&] { return saved; }));
  const Session session = readSession(path.toStdString());
  REQUIRE(session.changes.size() == 1);
  CHECK(session.changes[0].iteration == question.iteration);
  CHECK(answerTo(question, session) == (allows ? HeldAnswer::allow : HeldAnswer::hold));
  Document again;
  QObject::connect(&again, &Document::asked, [&] { ++told; });
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));
}

TEST_CASE("gone on without an answer a change stays held and undecided", "[document][ask]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  document.setConstraints(asking(), "Ask");
  document.run();
  REQUIRE(waitFor([&] { return !document.openQuestions().empty() && isAtRest(document); }));
  REQUIRE(document.state() == GrowthState::paused);
  REQUIRE(runToEnd(document));
  CHECK(document.snapshot()->certificate.genus.at(0) == 0);
  CHECK(document.openQuestions().size() == 1);
}

TEST_CASE("a session with vetoes, limits and walls comes back as it was, and nothing of it is lost",
          "[document]") {
  Grown grown;
  Document& document = grown.document;
  document.forbid(grown.meeting());
  REQUIRE(runToEnd(document));
  const QString path = grown.torus.file("vetoed.json");
  REQUIRE(grown.save(path));
  Document again;
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));
  CHECK(again.constraints() == document.constraints());

  // As the command line writes it: known from the start.
  Session session = readSession(path.toStdString());
  session.changes.clear();
  session.stopAt.reset();
  session.constraints = {{{{testing::kMiddle - Vec3(testing::kTorusR, 0, 0), 2.0}}, {}}, {}, {3, 0, {}}};
  writeSession(session, path.toStdString());
  Document third;
  REQUIRE(openAndWait(third, path));
  CHECK(third.constraints() == session.constraints);
  REQUIRE(runToEnd(third));
  ActiveContour straight(third.volume(), session.seeds, session.requested, session.constraints);
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(third.snapshot()->mesh, straight.mesh().compact()));
}

TEST_CASE("a pin that holds nothing on another way is told, and lifted the growth goes on", "[document]") {
  Grown grown;
  Document& document = grown.document;
  const int middle = document.lastIteration() / 2;
  REQUIRE(showIteration(document, middle));
  REQUIRE(document.pin(document.snapshot()->mesh.points.front(), 0.01));
  REQUIRE(showIteration(document, 0));
  Parameters other = document.parameters();
  other.edgeLength = 1.3 * document.resolved()->edgeLength;
  document.setParameters(other, "Other edges");
  document.run();
  REQUIRE(waitFor(
      [&] {
        return isAtRest(document) &&
               (!document.growthError().isEmpty() || document.state() == GrowthState::finished);
      },
      120));
  CHECK(document.iteration() < middle);  // the step is not made
  CHECK(document.growthError().contains("holds nothing"));
  Constraints none;
  document.setConstraints(none, "Lift the pin");
  REQUIRE(runToEnd(document));
  CHECK(document.growthError().isEmpty());
}
