// A frame to which the object of the frame beside it has moved, corrected in a document.

#include "core/io/report/session.h"
#include "tests/sequence/beating_support.h"
#include "tests/ui/model/time_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

constexpr int kFrames = 3;

//! A ball; in the frames after the first a core shows in it, and a click may mean that.
struct BallFile {
  QTemporaryDir folder;
  QString path{folder.filePath(QStringLiteral("balls.nii"))};

  BallFile() {
    const Volume ball = test::balls({{test::kMiddle, 12}}), cored = test::ballWithCore(12, 9.5);
    SequenceLayout layout;
    layout.grid = ball.grid;
    layout.type = ball.type;
    layout.frames = kFrames;
    layout.times = evenTimes(kFrames, 100, "phantom");
    writeSequence(layout, path.toStdString(), [&](int frame) { return frame == 0 ? ball : cored; });
  }
  QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
};

bool carry(Document& document, const BallFile& balls) {
  if (!openAndWait(document, balls.path)) return false;
  document.addSeed({test::kMiddle + Vec3(5, 0, 0), {}});
  return runToEnd(document) && carryAll(document);
}

//! Frame 1, with a wall over its side.
bool correct(Document& document) {
  if (!showFrame(document, 1)) return false;
  document.correctShownFrame();
  if (!waitFor([&] { return document.state() == GrowthState::finished; }, 60)) return false;
  if (!document.paintWalls({{test::kMiddle + Vec3(-12, 0, 0), 4}})) return false;
  return waitFor([&] { return document.wallConflict().has_value(); }) &&
         document.wallConflict()->canBePushedOut && runToEnd(document);
}

double volumeIn(const Document& document, int frame) { return document.time().resultOf(frame)->volume; }

}  // namespace

TEST_CASE("a frame with a moved object is corrected from that object, not from what clicks mean there",
          "[document][time]") {
  const BallFile balls;
  Document document;
  REQUIRE(carry(document, balls));
  REQUIRE(test::has(*document.time().resultOf(1), FrameFault::movedObject));
  const double carried = volumeIn(document, 1);
  REQUIRE(carried > 1.3 * test::ball(9.5));  // else it is what the clicks mean
  REQUIRE(showFrame(document, 1));
  document.correctShownFrame();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }, 60));
  CHECK(std::abs(document.snapshot()->certificate.volume / carried - 1) < 1e-4);  // but for the rounding
  document.endCorrection(false);
  CHECK(document.isCarriedCurrent());
}

TEST_CASE("a correction of a moved object is kept, opened and replayed with the same bits",
          "[document][time]") {
  const BallFile balls;
  Document document;
  QStringList written;
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  QObject::connect(&document, &Document::sessionSaved, [&](const QString& path) { written << path; });
  REQUIRE(carry(document, balls));
  const double before = volumeIn(document, 1);
  REQUIRE(correct(document));
  document.endCorrection(true);
  REQUIRE(waitFor([&] { return !document.time().isCarrying(); }, 100));
  CHECK(volumeIn(document, 1) < before);
  CHECK(volumeIn(document, 1) > 0.9 * before);
  REQUIRE(document.time().request().corrections.size() == 1);
  CHECK(document.time().request().corrections[0].isOfMoved);
  CHECK_FALSE(document.time().request().corrections[0].request.constraints.start);

  document.exportFrames(balls.file("window.ply"), CoordinateSpace::lps);
  document.saveSession(balls.file("session.json"));
  REQUIRE(waitFor([&] { return written.size() == 2; }));
  REQUIRE(runCli({"replay", balls.file("session.json"), "-o", balls.file("cli.ply"), "--quiet"}) == 0);
  for (int f = 0; f < kFrames; ++f) {
    const QString number = QStringLiteral("_%1.ply").arg(f, 4, 10, QLatin1Char('0'));
    CHECK(bytesOf(balls.folder.filePath("window" + number)) ==
          bytesOf(balls.folder.filePath("cli" + number)));
  }

  // Corrected again, it is as it was left.
  const double corrected = volumeIn(document, 1);
  REQUIRE(showFrame(document, 1));
  document.correctShownFrame();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }, 60));
  CHECK(std::abs(document.snapshot()->certificate.volume / corrected - 1) < 1e-4);
}
