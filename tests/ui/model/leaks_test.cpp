// The leak alarm in the window's document: paused at, walled, undone.

#include "tests/ui/dumbbell.h"
#include "tests/ui/model/document_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! Two balls with a neck, and a click in the left one that means all that is dark.
struct Leaking {
  QTemporaryDir folder;
  Document document;

  Leaking() {
    const QString path = folder.filePath(QStringLiteral("dumbbell.mha"));
    writeVolume(testing::dumbbellVolume(), path.toStdString());
    REQUIRE(openAndWait(document, path));
    document.addSeed({testing::kLeftBall, 3.0});
    Parameters p = document.parameters();
    p.range = IntensityRange{-1000, 100};
    document.setParameters(p, QStringLiteral("Range"));
  }
  double furthest() const {
    double x = 0;
    for (const Vec3& q : document.snapshot()->mesh.points) x = std::max(x, q.x());
    return x;
  }
};

}  // namespace

TEST_CASE("the growth pauses at a leak where that is wanted, and goes on past it", "[document][leaks]") {
  Leaking leaking;
  Document& document = leaking.document;
  int told = -1;
  QObject::connect(&document, &Document::leaked, [&](int index) { told = index; });
  document.setPausesAtLeaks(true);
  document.run();
  REQUIRE(waitFor([&] { return told >= 0 && document.state() == GrowthState::paused; }));
  REQUIRE(document.leaks().size() == 1);
  CHECK(told == 0);
  const FoundLeak found = document.leaks()[0];
  CHECK(document.iteration() == found.leak.iteration);
  CHECK(found.before < found.leak.iteration);
  CHECK((found.leak.place.x() > testing::kLeftBall.x() && found.leak.place.x() < testing::kRightBall.x()));
  REQUIRE(runToEnd(document));
  CHECK(document.leaks().size() == 1);
  CHECK(leaking.furthest() > testing::kRightBall.x());

  // Shown again it does not pause.
  REQUIRE(showIteration(document, 1));
  REQUIRE(runToEnd(document));
}

TEST_CASE("a leak of an object that is not shown is told, and one that comes back by undo pauses too",
          "[document][leaks][objects]") {
  Leaking leaking;
  Document& document = leaking.document;
  int elsewhere = -1, told = -1;
  QObject::connect(&document, &Document::leakedElsewhere, [&](int object) { elsewhere = object; });
  QObject::connect(&document, &Document::leaked, [&](int index) { told = index; });
  document.addObject();
  document.removeObject(0);
  document.setPausesAtLeaks(true);  // while it is away
  document.undoStack()->undo();
  REQUIRE(document.objectCount() == 2);
  document.setActiveObject(0);
  document.run();
  document.setActiveObject(1);
  REQUIRE(waitFor([&] { return elsewhere == 0; }));
  CHECK(told == -1);
  CHECK(waitFor([&] { return document.objectInfo(0).state == GrowthState::paused; }));
  document.setActiveObject(0);
  CHECK(document.leaks().size() == 1);
}

TEST_CASE("where no pause is wanted a leak is told all the same", "[document][leaks]") {
  Leaking leaking;
  REQUIRE(runToEnd(leaking.document));
  CHECK(leaking.document.leaks().size() == 1);
}

TEST_CASE("a wall at a leak goes back to before it, holds, and is undone", "[document][leaks]") {
  Leaking leaking;
  Document& document = leaking.document;
  document.setPausesAtLeaks(true);
  document.run();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::paused && !document.leaks().empty(); }));
  const FoundLeak found = document.leaks()[0];
  document.wallAt(0);
  REQUIRE(waitFor([&] { return document.iteration() == found.before; }));
  REQUIRE(document.constraints().walls.discs.size() == 1);
  REQUIRE(runToEnd(document));
  CHECK(document.leaks().empty());
  CHECK(leaking.furthest() < testing::kRightBall.x() - 10);
  document.undoStack()->undo();
  CHECK(document.constraints().walls.discs.empty());
  document.setPausesAtLeaks(false);
  REQUIRE(runToEnd(document));
  CHECK(leaking.furthest() > testing::kRightBall.x());
}
