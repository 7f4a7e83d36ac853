// Walls that are painted, in the window's document.

#include "core/collision/certify.h"
#include "core/evolution/painted_walls.h"
#include "core/io/report/session.h"
#include "tests/support/wall_support.h"
#include "tests/ui/model/document_support.h"
#include "ui/model/preparation.h"

using namespace handlebody;
using namespace handlebody::ui;
using testing::kMiddle;
using testing::kTorusR;

namespace {

const Vec3 kFar = kMiddle - Vec3(kTorusR, 0, 0);  // where the fronts meet

//! Across the tube, as a hand would draw it.
std::vector<WallBall> strokeAcross(const Vec3& place, double radius) {
  std::vector<WallBall> stroke;
  for (double x = -5; x <= 5; x += 0.3) drawTo(stroke, place + Vec3(x, 0, 0), radius);
  return stroke;
}

struct Open {
  TorusFile torus;
  Document document;
  QString refused;

  Open() {
    REQUIRE(openAndWait(document, torus.path));
    document.addSeed(torus.seed);
    QObject::connect(&document, &Document::refused, [this](const QString& sentence) { refused = sentence; });
  }
  double clearance() const {
    return testing::clearance(Mesh(document.snapshot()->mesh), document.constraints().walls.balls);
  }
  //! What is found in the background.
  bool meetsWall() {
    return waitFor([this] { return document.wallConflict().has_value(); });
  }
  int genus() const { return document.snapshot()->certificate.genus.at(0); }
  void expectMended() const {
    CHECK(document.snapshot()->certificate.passes());
    CHECK(clearance() > 0);
    CHECK(genus() == 0);
  }
};

}  // namespace

TEST_CASE("a stroke is one entry of the undo list, and the surface stays out of it at every iteration",
          "[document][painting]") {
  Open open;
  Document& document = open.document;
  const auto stroke = strokeAcross(kFar, 7);
  REQUIRE(document.paintWalls(stroke));
  CHECK(document.undoStack()->undoText() == QStringLiteral("Paint wall"));
  const WallList walls = document.constraints().walls;
  CHECK(walls.balls.size() >= 3);
  double least = 1e300;
  const auto look = QObject::connect(&document, &Document::snapshotChanged,
                                     [&] { least = std::min(least, open.clearance()); });
  REQUIRE(runToEnd(document));
  QObject::disconnect(look);
  CHECK(least > 0);
  open.expectMended();

  document.undoStack()->undo();
  CHECK(document.constraints().empty());
  document.undoStack()->redo();
  CHECK(document.constraints().walls == walls);
}

TEST_CASE("painted walls are in the session, and replay to the same surface", "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(document.paintWalls(strokeAcross(kFar, 7)));
  REQUIRE(runToEnd(document));
  bool saved = false;
  QObject::connect(&document, &Document::sessionSaved, [&] { saved = true; });
  document.saveSession(open.torus.file("painted.json"));
  REQUIRE(waitFor([&] { return saved; }));
  Document again;
  REQUIRE(openAndWait(again, open.torus.file("painted.json")));
  REQUIRE(waitFor([&] { return again.iteration() == document.iteration() && isAtRest(again); }));
  CHECK(again.constraints() == document.constraints());
  CHECK(isSame(again.snapshot()->mesh, document.snapshot()->mesh));
}

TEST_CASE("walls over a seed or outside of the volume are refused with a sentence and nothing has changed",
          "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(runToEnd(document));
  const int entries = document.undoStack()->count(), iteration = document.iteration();
  CHECK_FALSE(document.paintWalls(strokeAcross(open.torus.seed.centre, 2)));
  CHECK(open.refused.contains(QStringLiteral("over the seed at")));
  CHECK_FALSE(document.paintWalls({{{-50, 0, 0}, 3}, {{-55, 0, 0}, 3}}));
  CHECK(open.refused.contains(QStringLiteral("outside of the volume")));
  CHECK(document.undoStack()->count() == entries);
  CHECK(document.constraints().empty());
  CHECK(document.iteration() == iteration);
  CHECK(document.state() == GrowthState::finished);
  // What reaches out of it is kept as far as it lies within.
  REQUIRE(document.paintWalls({{{-50, 20, 20}, 3}, {{0, 20, 20}, 3}}));
  CHECK(document.constraints().walls.balls.size() == 1);
}

TEST_CASE("painted over the surface it goes on from before it came in there", "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(runToEnd(document));
  REQUIRE(open.genus() == 1);
  const int end = document.iteration();
  REQUIRE(document.paintWalls(strokeAcross(kFar, 7)));
  CHECK_FALSE(document.wallConflict());  // nothing waits for that
  REQUIRE(open.meetsWall());
  CHECK_FALSE(document.wallConflict()->canBePushedOut);  // outward alone
  CHECK(document.iteration() == end);

  // Without another gesture it does not go on: it says why.
  document.run();
  REQUIRE(waitFor([&] { return !document.growthError().isEmpty(); }));
  CHECK(document.growthError().contains(QStringLiteral("go back to before")));
  REQUIRE(document.wallConflict());

  document.goOnBeforeWalls();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
  open.expectMended();
  CHECK_FALSE(document.wallConflict());
  const auto& changes = document.summaries();
  CHECK(changes.size() > 2);

  // Undone, the surface is again as it was when the wall was put up, and closes to a ring.
  document.undoStack()->undo();
  REQUIRE(runToEnd(document));
  CHECK(open.genus() == 1);
}

TEST_CASE("a wall over the ball that it began with begins again beside it", "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(runToEnd(document));
  // The seed's ball has 3 mm: the wall reaches into it, not to its middle.
  const Vec3 beside = open.torus.seed.centre + Vec3(0, 0, 3.5);
  REQUIRE(document.paintWalls({{beside, 1.5}}));
  REQUIRE(open.meetsWall());
  document.goOnBeforeWalls();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished && !document.wallConflict(); }));
  CHECK(open.clearance() > 0);
}

TEST_CASE("a surface that may shrink is pushed out of a wall that crosses it", "[document][painting]") {
  Open open;
  Document& document = open.document;
  Parameters p = document.parameters();
  p.direction = Direction::both;
  document.setParameters(p, QStringLiteral("Direction"));
  REQUIRE(runToEnd(document));
  REQUIRE(document.paintWalls({{kFar + Vec3(0, 0, 5), 2.5}}));  // from outside through the tube's wall
  REQUIRE(open.meetsWall());
  CHECK(document.wallConflict()->canBePushedOut);
  REQUIRE(runToEnd(document));
  CHECK_FALSE(document.wallConflict());
  CHECK(open.clearance() > 0);
}

TEST_CASE("a growth that runs into a wall that is painted over it pauses there", "[document][painting]") {
  Open open;
  Document& document = open.document;
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() > 12; }));
  // Where the surface is now, 8 mm along the ring.
  const Vec3 place = kMiddle + Vec3(kTorusR * std::cos(0.5), kTorusR * std::sin(0.5), 0);
  REQUIRE(document.paintWalls({{place, 3}}));
  REQUIRE(waitFor([&] { return isAtRest(document); }));
  CHECK(document.wallConflict());
}

TEST_CASE("a wall over the surface that is undone, or erased, stands in nobody's way",
          "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(runToEnd(document));
  int told = 0;
  QObject::connect(&document, &Document::wallConflictChanged, [&] { ++told; });
  REQUIRE(document.paintWalls({{kFar, 3}}));
  document.undoStack()->undo();                  // before the answer has come
  REQUIRE(document.paintWalls({{kMiddle, 3}}));  // in the hole of the ring
  REQUIRE(document.paintWalls({{kFar, 2}}));
  REQUIRE(open.meetsWall());
  CHECK(told == 1);
  document.eraseWalls({{kFar, 1}});
  CHECK(waitFor([&] { return !document.wallConflict(); }));
  CHECK(told == 2);
  CHECK(document.constraints().walls.balls.size() == 1);
}

TEST_CASE("the eraser takes what it touches, and undo brings it back", "[document][painting]") {
  Open open;
  Document& document = open.document;
  REQUIRE(document.paintWalls(strokeAcross(kFar, 2)));
  const WallList walls = document.constraints().walls;
  document.eraseWalls({{kFar - Vec3(5, 0, 0), 1}});
  CHECK(document.undoStack()->undoText() == QStringLiteral("Erase wall"));
  CHECK(document.constraints().walls.balls.size() < walls.balls.size());
  CHECK_FALSE(document.constraints().walls.balls.empty());
  document.undoStack()->undo();
  CHECK(document.constraints().walls == walls);
  const int entries = document.undoStack()->count();
  document.eraseWalls({{kFar + Vec3(0, 30, 0), 1}});  // touches nothing: no entry
  CHECK(document.undoStack()->count() == entries);
}

TEST_CASE("walls are of the object that was active", "[document][painting][objects]") {
  Open open;
  Document& document = open.document;
  document.addObject();
  CHECK(document.constraints().empty());
  REQUIRE(document.paintWalls({{kFar, 3}}));
  document.setActiveObject(0);
  CHECK(document.constraints().empty());
  document.setObjectLocked(0, true);
  document.paintWalls({{kFar, 3}});
  CHECK(document.constraints().empty());
  document.undoStack()->undo();  // the lock
  document.undoStack()->undo();  // the stroke: its object is active again
  CHECK(document.activeObject() == 1);
  CHECK(document.constraints().empty());
}

TEST_CASE("other walls do not choose the object again", "[document][painting]") {
  const Open open;
  const Volume& volume = open.document.volume();
  Preparation preparation;
  const auto secondsOf = [&](const Request& request) {
    std::optional<Prepared> done;
    std::mutex mutex;
    preparation.request(volume, request, {}, nullptr, [&](Prepared p) {
      const std::lock_guard lock(mutex);
      done = std::move(p);
    });
    REQUIRE(waitFor([&] {
      const std::lock_guard lock(mutex);
      return done.has_value();
    }));
    REQUIRE(done->contour);
    return done->seconds;
  };
  Request request{open.document.seeds(), {}, {}};
  const double first = secondsOf(request);
  request.constraints.walls.balls = strokeAcross(kFar, 2);
  const double second = secondsOf(request);
  std::printf("prepared in %.0f ms, with walls in %.1f ms\n", 1000 * first, 1000 * second);
  CHECK(second < first / 3);
}
