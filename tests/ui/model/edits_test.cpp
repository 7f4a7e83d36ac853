// Edits of the mesh in the window's document: a step each, undone, saved, opened again.

#include <numeric>

#include "core/io/report/session.h"
#include "tests/ui/model/document_support.h"
#include "ui/model/measurements.h"
#include "ui/model/mesh_contents.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct GrownForEdits {
  TorusFile torus;
  Document document;
  int edited = 0;
  QString refused;

  GrownForEdits() {
    REQUIRE(openAndWait(document, torus.path));
    document.addSeed(torus.seed);
    REQUIRE(runToEnd(document));
    QObject::connect(&document, &Document::meshEdited, [this] { ++edited; });
    QObject::connect(&document, &Document::refused, [this](const QString& why) { refused = why; });
  }
  int genus() const {
    const auto& all = document.snapshot()->certificate.genus;
    return std::accumulate(all.begin(), all.end(), 0);
  }
  MeshEdit closing(TunnelCut cut = TunnelCut::tunnel) const {
    const MeshContents found = contentsOf(document.snapshot());
    REQUIRE(found.tunnels.size() == 1);
    return {0, MeshEditKind::closeTunnel, found.tunnels[0].place, cut};
  }
  bool close(TunnelCut cut = TunnelCut::tunnel) {
    const int made = edited;
    document.editMesh(closing(cut));
    return waitFor([&] { return edited > made; });
  }
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

TEST_CASE("an edit is the next step, undo shows the surface before it, redo makes it again", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  const int before = document.iteration();
  const TriangleSoup open = document.snapshot()->mesh;
  REQUIRE(grown.close());
  CHECK(document.iteration() == before + 1);
  CHECK(document.lastIteration() == before + 1);
  CHECK(grown.genus() == 0);
  CHECK(document.snapshot()->certificate.boundsBody());
  CHECK(document.state() == GrowthState::finished);
  CHECK(document.undoStack()->undoText() == "Fill tunnel");
  const Event& event = document.events().back();
  CHECK(event.kind == EventKind::tunnelClosed);
  REQUIRE(event.edit);
  CHECK(event.edit->volumeAfter > event.edit->volumeBefore);
  const TriangleSoup closed = document.snapshot()->mesh;

  document.undoStack()->undo();
  REQUIRE(waitFor([&] { return document.iteration() == before; }));
  CHECK(isSame(document.snapshot()->mesh, open));
  CHECK(grown.genus() == 1);
  CHECK(document.constraints().empty());
  document.undoStack()->redo();
  REQUIRE(waitFor([&] { return document.iteration() == before + 1; }));
  CHECK(isSame(document.snapshot()->mesh, closed));
  CHECK(grown.genus() == 0);
}

TEST_CASE("an edit that cannot be made is told, and all is as it was", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  const TriangleSoup before = document.snapshot()->mesh;
  const QString undo = document.undoStack()->undoText();
  document.editMesh({0, MeshEditKind::fillCavity, testing::kMiddle});
  REQUIRE(waitFor([&] { return !grown.refused.isEmpty(); }));
  CHECK(grown.refused.contains("finds no cavity"));
  CHECK(document.constraints().empty());
  CHECK(document.undoStack()->undoText() == undo);
  CHECK_FALSE(document.undoStack()->canRedo());
  CHECK(isSame(document.snapshot()->mesh, before));
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  REQUIRE(grown.close());  // nothing is in the way of another
  CHECK(grown.genus() == 0);
}

TEST_CASE("an edit that cannot be made is taken out whatever was done meanwhile, which stays", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  document.addObject();
  document.setActiveObject(0);
  const QString undo = document.undoStack()->undoText();
  const int entries = document.undoStack()->count();
  const auto meanwhile = GENERATE(0, 1, 2, 3);
  document.editMesh({0, MeshEditKind::fillCavity, testing::kMiddle});
  if (meanwhile == 0) document.measurements().add({MeasurementKind::ruler, {Vec3(1, 2, 3), Vec3(4, 5, 6)}});
  if (meanwhile == 1) document.setObjectVisible(0, false);
  if (meanwhile == 2) document.setActiveObject(1);
  if (meanwhile == 3) document.addSeed({testing::kMiddle + Vec3(0, 0, 15), std::nullopt, true});
  REQUIRE(waitFor([&] { return !grown.refused.isEmpty(); }));
  CHECK(grown.refused.contains("finds no cavity"));
  document.setActiveObject(0);
  CHECK(document.constraints().edits.empty());
  CHECK(document.seeds().size() == (meanwhile == 3 ? 2 : 1));
  REQUIRE(runToEnd(document));  // nothing is in the way
  if (meanwhile != 2) document.undoStack()->undo();
  CHECK(document.undoStack()->undoText() == undo);  // no entry does nothing
  CHECK(document.undoStack()->index() == entries);
  CHECK(document.constraints().edits.empty());
  if (meanwhile != 2) document.undoStack()->redo();
  CHECK(document.constraints().edits.empty());
}

TEST_CASE("an edit on the way that cannot be made leaves the iterations after it", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  const int last = document.lastIteration();
  const TriangleSoup end = document.snapshot()->mesh;
  REQUIRE(showIteration(document, last / 2));
  const TriangleSoup before = document.snapshot()->mesh;
  document.editMesh({0, MeshEditKind::fillCavity, testing::kMiddle});
  REQUIRE(waitFor([&] { return !grown.refused.isEmpty(); }));
  CHECK(document.constraints().empty());
  CHECK(document.iteration() == last / 2);
  CHECK(isSame(document.snapshot()->mesh, before));
  REQUIRE(document.lastIteration() == last);
  REQUIRE(showIteration(document, last));
  CHECK(isSame(document.snapshot()->mesh, end));
}

TEST_CASE("an edit is left out from the step before it on", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  const int before = document.iteration();
  REQUIRE(grown.close(TunnelCut::handle));
  const auto& events = document.events();
  document.forbid(static_cast<int>(events.size()) - 1);  // what the inspector's button calls
  REQUIRE(waitFor([&] { return document.iteration() == before; }));
  CHECK(document.constraints().empty());
  REQUIRE(runToEnd(document));
  CHECK(grown.genus() == 1);
  CHECK(document.lastIteration() == before);
}

TEST_CASE("a session with edits opens to the same surface, and replays to it", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  REQUIRE(grown.close());
  const QString path = grown.torus.file("edited.json");
  REQUIRE(grown.save(path));
  Document again;
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));
  CHECK(again.constraints() == document.constraints());
  CHECK(again.constraints().edits.size() == 1);

  const Session session = readSession(path.toStdString());
  ActiveContour contour(document.volume(), session.seeds, session.requested, session.constraints);
  while (contour.iteration() < session.stopAt.value()) {
    for (const ParameterChange& c : session.changes)
      if (c.iteration == contour.iteration()) contour.change(changed(contour.request(), c));
    contour.step();
  }
  CHECK(isSame(contour.mesh().compact(), document.snapshot()->mesh));
}

TEST_CASE("a place that was pulled, smoothed and cut is the same again from a session", "[document]") {
  GrownForEdits grown;
  Document& document = grown.document;
  const int before = document.iteration();
  const Vec3 end = testing::kMiddle - Vec3(testing::kTorusR + testing::kTorusr, 0, 0);
  const auto make = [&](MeshEdit edit) {
    const int made = grown.edited;
    document.editMesh(edit);
    return waitFor([&] { return grown.edited > made; });
  };
  MeshEdit pull{0, MeshEditKind::pull, end}, smooth{0, MeshEditKind::smooth, end},
      cut{0, MeshEditKind::cut, testing::kMiddle};
  pull.vector = end - Vec3(1.5, 0, 0);
  pull.radius = smooth.radius = 4;
  cut.vector = Vec3(1, 0, 0);
  cut.keep = KeptSide::negative;
  REQUIRE(make(pull));
  CHECK(document.undoStack()->undoText() == "Pull here");
  REQUIRE(make(smooth));
  CHECK(document.undoStack()->undoText() == "Smooth here");
  REQUIRE(make(cut));
  CHECK(document.undoStack()->undoText() == "Cut here");
  CHECK(document.iteration() == before + 3);
  CHECK(document.snapshot()->certificate.boundsBody());
  CHECK(grown.genus() == 0);  // half of a ring

  const QString path = grown.torus.file("places.json");
  REQUIRE(grown.save(path));
  Document again;
  REQUIRE(openAndWait(again, path));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));
  CHECK(again.constraints() == document.constraints());
}

TEST_CASE("what is looked for can be cancelled, and tells nothing then", "[document]") {
  GrownForEdits grown;
  std::atomic<int> told{0};
  {
    ContentsFinder finder;
    for (int i = 0; i < 20; ++i) {
      finder.find(grown.document.snapshot(), [&](const MeshContents&) { ++told; });
      finder.cancel();
    }
    finder.find(grown.document.snapshot(), [&](const MeshContents& found) {
      if (found.error.isEmpty() && found.tunnels.size() == 1) told = 100;
    });
    REQUIRE(waitFor([&] { return told >= 100; }));
  }
  CHECK(told == 100);
}
