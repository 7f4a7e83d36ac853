// Growing, stepping back, changing parameters on the way, export.

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "tests/ui/model/document_support.h"
#include "ui/model/snapshot.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! A document with a torus and a seed in it.
struct Work {
  TorusFile torus;
  Document document;

  Work() {
    REQUIRE(openAndWait(document, torus.path));
    document.addSeed(torus.seed);
  }
  bool stepForward() {
    const int before = document.iteration();
    document.stepForward();
    return waitFor([&] { return document.iteration() == std::max(0, before) + 1; });
  }
};

}  // namespace

TEST_CASE("a seed grows into the torus and stops by itself", "[document]") {
  Work work;
  Document& document = work.document;
  CHECK(document.state() == GrowthState::none);
  CHECK(document.snapshot() == nullptr);
  document.run();
  CHECK(document.state() == GrowthState::preparing);
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  CHECK(document.stopReason() == StopReason::converged);
  CHECK(document.growthError().isEmpty());
  const auto snapshot = document.snapshot();
  REQUIRE(snapshot);
  CHECK(snapshot->iteration == document.lastIteration());
  CHECK(snapshot->certificate.passes());
  CHECK(snapshot->states.size() == snapshot->mesh.triangles.size());
  REQUIRE(document.summaries().size() == static_cast<std::size_t>(document.lastIteration()) + 1);
  for (std::size_t i = 0; i < document.summaries().size(); ++i)
    CHECK(document.summaries()[i].iteration == static_cast<int>(i));
  CHECK(document.summaries().back().volume == Approx(snapshot->certificate.volume));
  int events = 0;
  for (const IterationSummary& s : document.summaries()) events += s.events;
  CHECK(events >= 1);
}

TEST_CASE("the faces of a new handle are marked, in its step each of them and no other", "[document]") {
  History history(ActiveContour(testing::torusVolume(),
                                {{testing::kMiddle + Vec3(testing::kTorusR, 0, 0), 3.0}}, Parameters{}));
  int handles = 0, later = 0;
  for (; history.stopReason() == StopReason::running; history.advance()) {
    std::multiset<std::array<double, 9>> expected, marked;
    const auto corners = [](const Vec3& a, const Vec3& b, const Vec3& c) {
      std::array<std::array<double, 3>, 3> p{
          {{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, {c.x(), c.y(), c.z()}}};
      std::sort(p.begin(), p.end());
      return std::array<double, 9>{p[0][0], p[0][1], p[0][2], p[1][0], p[1][1],
                                   p[1][2], p[2][0], p[2][1], p[2][2]};
    };
    const Mesh& mesh = history.shown().mesh();
    for (const Event& e : history.events())
      if (e.kind == EventKind::handleInserted && e.iteration == history.iteration())
        for (const Triangle& t : e.faces)
          expected.insert(corners(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
    const auto snapshot = makeSnapshot(history, Checking::structure);
    for (std::size_t f = 0; f < snapshot->states.size(); ++f) {
      const Triangle& t = snapshot->mesh.triangles[f];
      const auto& p = snapshot->mesh.points;
      const auto at = [&](std::size_t i) { return p[t[i]]; };
      if (snapshot->states[f] == FaceState::newHandle) marked.insert(corners(at(0), at(1), at(2)));
    }
    if (!expected.empty()) {
      ++handles;
      CHECK(marked == expected);
    } else if (!marked.empty()) {
      ++later;
    }
  }
  CHECK(handles == 1);
  CHECK(later > 0);  // it stays marked for a while
}

TEST_CASE("what is shown on the way has the numbers of the full certificate", "[document]") {
  History history(ActiveContour(testing::torusVolume(),
                                {{testing::kMiddle + Vec3(testing::kTorusR, 0, 0), 3.0}}, Parameters{}));
  for (; history.stopReason() == StopReason::running; history.advance()) {
    const auto snapshot = makeSnapshot(history, Checking::structure);
    const Certificate a = snapshot->certificate, b = certify(snapshot->mesh);
    INFO("iteration " << history.iteration());
    CHECK(a.passes());
    CHECK(b.passes());
    CHECK(std::tie(a.vertices, a.faces, a.components, a.genus, a.euler) ==
          std::tie(b.vertices, b.faces, b.components, b.genus, b.euler));
    CHECK(a.volume == Approx(b.volume));
    CHECK(a.area == Approx(b.area));
  }
}

TEST_CASE("without a seed nothing grows, and it is said why", "[document]") {
  const TorusFile torus;
  Document document;
  REQUIRE(openAndWait(document, torus.path));
  document.run();
  CHECK(document.state() == GrowthState::none);
  CHECK_FALSE(document.growthError().isEmpty());
}

TEST_CASE("a seed that is in no object ends in a sentence", "[document]") {
  Work work;
  work.document.moveSeed(0, Vec3(1000, 0, 0));
  work.document.run();
  REQUIRE(waitFor([&] { return work.document.state() == GrowthState::none; }));
  CHECK(work.document.growthError().contains(QStringLiteral("outside the volume")));
}

TEST_CASE("steps forward and back show each iteration exactly", "[document]") {
  Work work;
  Document& document = work.document;
  std::vector<TriangleSoup> meshes(1);
  for (int i = 1; i <= 12; ++i) {
    REQUIRE(work.stepForward());
    CHECK(waitFor([&] { return document.state() == GrowthState::paused; }));
    meshes.push_back(document.snapshot()->mesh);
  }
  for (int i = 11; i >= 1; --i) {
    document.stepBack();
    REQUIRE(waitFor([&] { return document.iteration() == i; }));
    CHECK(isSame(document.snapshot()->mesh, meshes[i]));
  }
  CHECK(document.lastIteration() == 12);
}

TEST_CASE("any jump shows what was there", "[document]") {
  Work work;
  Document& document = work.document;
  REQUIRE(runToEnd(document));
  std::map<int, TriangleSoup> seen;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, document.lastIteration());
  for (int jump = 0; jump < 40; ++jump) {
    const int target = any(random) / 4 * 4;  // so that some come again
    REQUIRE(showIteration(document, target));
    const auto [at, first] = seen.emplace(target, document.snapshot()->mesh);
    if (!first) CHECK(isSame(document.snapshot()->mesh, at->second));
  }
}

TEST_CASE("next and previous event go where something happened", "[document]") {
  Work work;
  Document& document = work.document;
  document.goToNextEvent();
  REQUIRE(waitFor([&] { return document.iteration() > 0 && isAtRest(document); }));
  const int first = document.iteration();
  CHECK(document.summaries().back().events > 0);
  CHECK(document.lastIteration() == first);
  REQUIRE(runToEnd(document));
  document.goToStart();
  REQUIRE(waitFor([&] { return document.iteration() == 0; }));
  document.goToNextEvent();
  REQUIRE(waitFor([&] { return document.iteration() == first; }));
  document.goTo(document.lastIteration());
  REQUIRE(waitFor([&] { return document.iteration() == document.lastIteration(); }));
  document.goToPreviousEvent();
  REQUIRE(waitFor([&] { return document.iteration() != document.lastIteration(); }));
  CHECK(document.summaries()[document.iteration()].events > 0);
}

TEST_CASE("a click on the way: the growth goes on from the shown iteration with it", "[document]") {
  Work work;
  Document& document = work.document;
  for (int i = 0; i < 8; ++i) REQUIRE(work.stepForward());
  REQUIRE(showIteration(document, 6));
  const Seed further{testing::kMiddle - Vec3(testing::kTorusR, 0, 0), {}};
  document.addSeed(further);
  CHECK(document.iteration() == 6);
  CHECK(document.lastIteration() == 8);  // until it goes on
  CHECK(document.snapshot() != nullptr);
  REQUIRE(runToEnd(document));
  CHECK(document.iteration() > 8);
  REQUIRE(document.corrections().size() == 1);
  CHECK(document.corrections()[0].iteration == 6);
  CHECK(document.corrections()[0].what.fronts == 1);
  CHECK_FALSE(document.corrections()[0].what.beganAnew);
  ActiveContour straight(document.volume(), {work.torus.seed}, Parameters{});
  for (int i = 0; i < 6; ++i) straight.step();
  straight.change({document.seeds(), Parameters{}});
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(document.snapshot()->mesh, straight.mesh().compact()));
  CHECK(document.lastIteration() == straight.iteration());
}

TEST_CASE("a click while it runs is prepared in the background, and the growth goes on with it",
          "[document]") {
  Work work;
  Document& document = work.document;
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() >= 3; }));
  QElapsedTimer clock;
  clock.start();
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), {}});
  CHECK(clock.elapsed() < 100);
  CHECK(document.iteration() >= 3);
  REQUIRE(waitFor([&] { return !document.corrections().empty(); }));
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  CHECK(document.snapshot()->certificate.genus == std::vector<int>{1});
}

TEST_CASE("undo takes a grown correction back exactly, and redo grows it again the same", "[document]") {
  Work work;
  Document& document = work.document;
  for (int i = 0; i < 10; ++i) REQUIRE(work.stepForward());
  const TriangleSoup before = document.snapshot()->mesh;
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), {}});
  REQUIRE(runToEnd(document));
  const TriangleSoup after = document.snapshot()->mesh;
  document.undoStack()->undo();
  REQUIRE(waitFor([&] { return document.iteration() == 10; }));
  CHECK(isSame(document.snapshot()->mesh, before));
  CHECK(document.seeds().size() == 1);
  CHECK(document.state() == GrowthState::paused);
  document.undoStack()->redo();
  REQUIRE(runToEnd(document));
  CHECK(isSame(document.snapshot()->mesh, after));
  document.undoStack()->undo();
  REQUIRE(runToEnd(document));
  CHECK(document.corrections().empty());
  ActiveContour straight(document.volume(), document.seeds(), Parameters{});
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(document.snapshot()->mesh, straight.mesh().compact()));
}

TEST_CASE("clicks moved before it goes on change nothing that is shown, and undo leaves it", "[document]") {
  Work work;
  Document& document = work.document;
  REQUIRE(runToEnd(document));
  const TriangleSoup mesh = document.snapshot()->mesh;
  const int last = document.lastIteration();
  document.addSeed({testing::kMiddle, {}, true});
  document.moveSeed(1, testing::kMiddle + Vec3(0, 0, 12));
  CHECK(document.state() == GrowthState::paused);
  document.undoStack()->undo();
  document.undoStack()->undo();
  CHECK(document.state() == GrowthState::finished);
  CHECK(document.lastIteration() == last);
  CHECK(isSame(document.snapshot()->mesh, mesh));
}

TEST_CASE("at the beginning other clicks begin the growth again", "[document]") {
  Work work;
  Document& document = work.document;
  for (int i = 0; i < 3; ++i) REQUIRE(work.stepForward());
  REQUIRE(showIteration(document, 0));
  document.setSeedRadius(0, 2.0);
  REQUIRE(runToEnd(document));
  CHECK(document.corrections().empty());
  ActiveContour straight(document.volume(), document.seeds(), Parameters{});
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(document.snapshot()->mesh, straight.mesh().compact()));
}

TEST_CASE("without any seed left the growth goes, and undo lets it be grown again the same", "[document]") {
  Work work;
  Document& document = work.document;
  REQUIRE(runToEnd(document));
  const TriangleSoup mesh = document.snapshot()->mesh;
  document.removeSeed(0);
  CHECK(document.state() == GrowthState::none);
  CHECK(document.snapshot() == nullptr);
  CHECK(document.summaries().empty());
  CHECK(document.events().empty());
  CHECK(document.iteration() == -1);
  document.undoStack()->undo();
  REQUIRE(runToEnd(document));
  CHECK(isSame(document.snapshot()->mesh, mesh));
}

TEST_CASE("after a pause nothing is grown any more", "[document]") {
  Work work;
  Document& document = work.document;
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() >= 5; }));
  document.pause();
  CHECK(document.state() == GrowthState::paused);
  waitMilliseconds(500);  // what the worker had done by then has arrived
  const int stopped = document.lastIteration();
  CHECK(document.stopReason() == StopReason::running);  // it has not simply come to its end
  waitMilliseconds(300);
  CHECK(document.lastIteration() == stopped);
  CHECK(document.iteration() == stopped);
}

TEST_CASE("another range on the way is prepared first, and the growth goes on with it", "[document]") {
  Work work;
  Document& document = work.document;
  for (int i = 0; i < 5; ++i) REQUIRE(work.stepForward());
  Parameters p = document.parameters();
  p.range = IntensityRange{-100, 90};
  document.setParameters(p, QStringLiteral("Change range"));
  document.run();
  CHECK(document.state() == GrowthState::preparing);
  CHECK(document.iteration() == 5);
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  CHECK(document.resolved()->range == *p.range);
  ActiveContour straight(document.volume(), document.seeds(), Parameters{});
  for (int i = 0; i < 5; ++i) straight.step();
  straight.changeParameters(p);
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(isSame(document.snapshot()->mesh, straight.mesh().compact()));
}

TEST_CASE("a range that the seed is not in stops with a sentence, and the growth stays", "[document]") {
  Work work;
  Document& document = work.document;
  for (int i = 0; i < 5; ++i) REQUIRE(work.stepForward());
  Parameters p = document.parameters();
  p.range = IntensityRange{150, 250};
  document.setParameters(p, QStringLiteral("Change range"));
  document.run();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::paused; }));
  CHECK(document.growthError().contains(QStringLiteral("not in the object")));
  CHECK(document.iteration() == 5);
  document.undoStack()->undo();
  CHECK(document.growthError().isEmpty());  // what it was about is gone
  REQUIRE(runToEnd(document));
  CHECK(document.growthError().isEmpty());
}

TEST_CASE("parameters changed while it runs take effect on the way", "[document]") {
  Work work;
  Document& document = work.document;
  Parameters slow;
  slow.balloon = 0.3;
  document.setParameters(slow, QStringLiteral("Change balloon"));
  document.run();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::running; }));
  Parameters fast;
  fast.range = IntensityRange{-100, 90};
  document.setParameters(fast, QStringLiteral("Change range"));
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  CHECK(document.snapshot()->certificate.genus == std::vector<int>{1});
  document.goTo(0);
  REQUIRE(waitFor([&] { return document.iteration() == 0; }));
}

TEST_CASE("a document that is closed while it prepares does not wait for that", "[document]") {
  QElapsedTimer clock;
  {
    Work work;
    work.document.run();
    clock.start();
  }
  CHECK(clock.elapsed() < 100);
}

TEST_CASE("the stages of an event come on request", "[document]") {
  Work work;
  Document& document = work.document;
  REQUIRE(runToEnd(document));
  int handle = -1;
  for (std::size_t i = 0; i < document.events().size(); ++i)
    if (document.events()[i].kind == EventKind::handleInserted) handle = static_cast<int>(i);
  REQUIRE(handle >= 0);
  EventTrace got;
  int of = -1;
  QObject::connect(&document, &Document::eventTraced, [&](int index, const EventTrace& trace) {
    of = index;
    got = trace;
  });
  document.requestTrace(handle);
  REQUIRE(waitFor([&] { return of == handle; }));
  CHECK_FALSE(got.handleFaces.empty());
  CHECK(got.boundaryLoops.size() == 2);
  CHECK(document.iteration() == document.lastIteration());
}
