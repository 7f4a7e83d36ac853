// What was carried through the frames and what was corrected there, when something else changes.

#include <functional>

#include "core/io/report/session.h"
#include "tests/io/dicom_test_support.h"
#include "tests/sequence/beating_support.h"
#include "tests/ui/model/objects_support.h"
#include "tests/ui/model/time_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

bool carryFrom(Document& document, const BeatingFile& heart) {
  return growInFrame(document, heart) && carryAll(document);
}

//! As it was carried there, and at rest.
bool startCorrecting(Document& document, int frame) {
  if (!showFrame(document, frame)) return false;
  document.correctShownFrame();
  return waitFor([&] { return document.state() == GrowthState::finished; }, 120);
}

//! Kept, and carried on.
bool keepCorrection(Document& document) {
  document.endCorrection(true);
  return waitFor([&] { return !document.time().isCarrying(); }, 200);
}

bool saveTo(Document& document, const QString& path) {
  QString written;
  const auto done =
      QObject::connect(&document, &Document::sessionSaved, [&](const QString& p) { written = p; });
  document.saveSession(path);
  const bool isWritten = waitFor([&] { return written == path; });
  QObject::disconnect(done);
  return isWritten;
}

double volumeAt(const Document& document, int frame) { return document.time().resultOf(frame)->volume; }

}  // namespace

TEST_CASE("work without a correction that was saved is unsaved until it is saved again", "[document][time]") {
  const BeatingFile heart;
  Document document;
  const QString session = heart.file("session.json");
  REQUIRE(carryFrom(document, heart));
  REQUIRE(saveTo(document, session));
  CHECK_FALSE(document.isModified());
  REQUIRE(startCorrecting(document, 3));
  CHECK(document.isModified());
  SECTION("it was left after that") {
    REQUIRE(saveTo(document, session));
    CHECK_FALSE(document.isModified());
    document.endCorrection(false);
  }
  SECTION("it was left while it was written") {
    QString written;
    QObject::connect(&document, &Document::sessionSaved, [&](const QString& path) { written = path; });
    document.saveSession(session);
    document.endCorrection(false);
    REQUIRE(waitFor([&] { return written == session; }));
  }
  CHECK(document.isModified());
  REQUIRE(readSession(session.toStdString()).overTime.has_value());
  CHECK(readSession(session.toStdString()).overTime->corrections.size() == 1);
  REQUIRE(saveTo(document, session));
  CHECK_FALSE(document.isModified());
  CHECK(readSession(session.toStdString()).overTime->corrections.empty());
}

TEST_CASE("what is undone in the list of objects ends the correction of a frame first", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  const auto surface = document.snapshot();
  handlebody::ui::rename(document, 0, "Ventricle");
  REQUIRE(startCorrecting(document, 3));
  document.undoStack()->undo();  // the name
  CHECK_FALSE(document.correctedFrame());
  CHECK(document.time().workFrame() == 0);
  REQUIRE(showFrame(document, 0));
  CHECK(document.snapshot() == surface);
  CHECK(document.isCarriedCurrent());
}

TEST_CASE("where the frame that is grown in is undone no correction stays open", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  const Volume first = document.volume();
  REQUIRE(showFrame(document, 1));
  document.growInShownFrame();
  REQUIRE(runToEnd(document));
  REQUIRE(carryAll(document));
  REQUIRE(startCorrecting(document, 3));
  document.undoStack()->undo();  // over time
  document.undoStack()->undo();  // grow in frame 1
  REQUIRE(waitFor([&] { return document.time().grownFrame() == 0; }));
  CHECK_FALSE(document.correctedFrame());
  CHECK(document.time().workFrame() == 0);
  REQUIRE(showFrame(document, 0));
  CHECK(std::memcmp(document.volume().voxels.get(), first.voxels.get(), first.grid.voxelCount()) == 0);
}

TEST_CASE("undo of what is asked for over time leaves corrections as they are", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  REQUIRE(startCorrecting(document, 2));
  REQUIRE(keepCorrection(document));
  REQUIRE(document.time().request().corrections.size() == 1);
  document.undoStack()->undo();  // over time
  document.undoStack()->redo();
  CHECK(document.time().request().corrections.size() == 1);
  CHECK(document.isCarriedCurrent());
}

TEST_CASE("with another range or topology than it was carried with a surface over time is out of date",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QObject::connect(&document, &Document::exportRefused, [&](const QString& why) { refused = why; });
  REQUIRE(carryFrom(document, heart));
  OverTimeRequest other = document.time().request();
  if (GENERATE(true, false))
    other.holdTopology = !other.holdTopology;
  else
    other.frames = OverTimeRequest::Range{0, 2};
  document.setOverTime(other, QStringLiteral("Over time"));
  CHECK_FALSE(document.isCarriedCurrent());
  // It is told as it was made.
  CHECK(document.time().report().request.holdTopology);
  CHECK(document.time().report().request.frames->last == BeatingFile::kFrames - 1);
  document.exportFrames(heart.file("frames.stl"), CoordinateSpace::lps);
  CHECK(refused.contains("carry it through"));
  document.undoStack()->undo();
  CHECK(document.isCarriedCurrent());
  // How its drift is looked for is no matter of the surfaces.
  other = document.time().request();
  other.drift = DriftCheck::none;
  document.setOverTime(other, QStringLiteral("Over time"));
  CHECK(document.isCarriedCurrent());
  CHECK(document.time().report().request.drift == DriftCheck::back);
}

TEST_CASE("what was carried of one object is not shown as another's", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  document.undoStack()->undo();  // what was asked for over time
  document.addObject();
  document.removeObject(0);
  REQUIRE(document.objectCount() == 1);
  REQUIRE(showFrame(document, 3));
  CHECK(document.snapshot() == nullptr);
  CHECK(document.finishedMesh(0) == nullptr);
}

namespace {

QByteArray savedSession(Document& document, const BeatingFile& heart) {
  const QString path = heart.file("kept.json");
  bool isSaved = false;
  const auto done = QObject::connect(&document, &Document::sessionSaved, [&] { isSaved = true; });
  document.saveSession(path);
  const bool ended = waitFor([&] { return isSaved; });
  QObject::disconnect(done);
  return ended ? bytesOf(path) : QByteArray();
}

}  // namespace

TEST_CASE("no object is added to work over time, which no session keeps with several, and it says why",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { refused = why; });
  QObject::connect(&document, &Document::openingObjectsFailed, [&](const QString& why) { refused = why; });
  REQUIRE(carryFrom(document, heart));
  const auto isRefused = [&](const std::function<void()>& door) {
    refused.clear();
    door();
    return document.objectCount() == 1 && refused.contains("over time of one object");
  };
  CHECK(isRefused([&] { document.addObject(); }));
  CHECK(isRefused([&] { document.duplicateObject(0); }));
  CHECK(isRefused([&] { document.openObjects({heart.file("surface.stl"), OpenAs::done}); }));
  CHECK(document.leftOut().isEmpty());
  CHECK(savedSession(document, heart).contains("over_time"));
  document.undoStack()->undo();
  document.addObject();
  CHECK(document.objectCount() == 2);
  refused.clear();
  document.setOverTime({}, QStringLiteral("Over time"));
  CHECK(refused.contains("Several objects"));
  CHECK_FALSE(document.time().isAsked());
}

TEST_CASE("work over time beside an object that undo brings back is told to be left out until that goes",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { refused = why; });
  REQUIRE(growInFrame(document, heart));
  document.addObject();
  document.removeObject(1);
  REQUIRE(carryAll(document));
  REQUIRE(startCorrecting(document, 3));
  REQUIRE(keepCorrection(document));
  document.undoStack()->undo();  // over time, but for what was corrected
  CHECK(savedSession(document, heart).contains("over_time"));
  CHECK(refused.isEmpty());
  document.undoStack()->undo();  // the deletion
  REQUIRE(document.objectCount() == 2);
  CHECK(refused.contains("left out"));
  CHECK(document.leftOut() == refused);
  CHECK_FALSE(savedSession(document, heart).contains("over_time"));
  document.removeObject(1);
  CHECK(document.leftOut().isEmpty());
  CHECK(savedSession(document, heart).contains("over_time"));
}

TEST_CASE("nothing grows in another frame while an object is locked, whose surface would be gone",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { refused = why; });
  REQUIRE(growInFrame(document, heart));
  const auto surface = document.snapshot();
  handlebody::ui::rename(document, 0, "Ventricle");
  document.setObjectLocked(0, true);
  document.addObject();
  REQUIRE(showFrame(document, 2));
  document.growInShownFrame();
  CHECK(refused.contains("Ventricle"));
  CHECK(document.time().grownFrame() == 0);
  REQUIRE(showFrame(document, 0));
  CHECK(document.objectInfo(0).snapshot == surface);
  REQUIRE(showFrame(document, 2));
  document.setObjectLocked(0, false);
  CHECK(document.lostElsewhere() == QStringList{QStringLiteral("Ventricle")});
  document.setActiveObject(0);
  CHECK(document.lostElsewhere().isEmpty());
  document.growInShownFrame();
  CHECK(document.time().grownFrame() == 2);
}

TEST_CASE("a carried surface that is out of date is shown, but neither measured nor written",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QObject::connect(&document, &Document::exportRefused, [&](const QString& why) { refused = why; });
  REQUIRE(carryFrom(document, heart));
  document.goTo(document.lastIteration() - 1);
  REQUIRE(waitFor([&] { return document.iteration() == document.lastIteration() - 1; }));
  REQUIRE_FALSE(document.isCarriedCurrent());
  CHECK_FALSE(document.isShownOutOfDate());  // in its own frame it is what there is
  REQUIRE(showFrame(document, 3));
  CHECK(document.snapshot());
  CHECK(document.isShownOutOfDate());
  CHECK(document.finishedMesh(0) == nullptr);
  document.exportResult(heart.file("frame.stl"), CoordinateSpace::lps);
  CHECK(refused.contains("carry it through"));
  CHECK_FALSE(QFile::exists(heart.file("frame.stl")));
}

TEST_CASE("every frame shows the walls that its surface was made with, and the clicks where they are",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  CHECK(document.shownSeeds().size() == 1);
  const auto wallsIn = [&](int frame) {
    REQUIRE(showFrame(document, frame));
    return document.shownWalls().balls.size();
  };
  REQUIRE(startCorrecting(document, 2));
  REQUIRE(document.paintWalls({{heart.seed + Vec3(0, 0, 36), 10}}));
  CHECK(wallsIn(2) == 1);
  CHECK(document.shownSeeds() == document.seeds());
  for (const int frame : {0, 1, 4}) {
    CHECK(wallsIn(frame) == 0);
    CHECK(document.shownSeeds().empty());
    CHECK(document.shownPins().empty());
  }
  REQUIRE(showFrame(document, 2));
  REQUIRE(waitFor([&] { return document.wallConflict().has_value(); }));
  REQUIRE(runToEnd(document));
  REQUIRE(keepCorrection(document));
  CHECK(wallsIn(0) == 0);
  CHECK(document.shownSeeds() == document.seeds());
  CHECK(wallsIn(1) == 0);
  CHECK(wallsIn(2) == 1);
  CHECK(wallsIn(4) == 1);  // it starts from the corrected one, with its walls
  CHECK(document.constraints().walls.empty());
}

TEST_CASE("whether a carried surface is out of date is told when it is asked for otherwise",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  REQUIRE(showFrame(document, 3));
  CHECK_FALSE(document.isShownOutOfDate());
  int told = 0;
  QObject::connect(&document, &Document::snapshotChanged, [&] { ++told; });
  OverTimeRequest other = document.time().request();
  other.holdTopology = !other.holdTopology;
  document.setOverTime(other, QStringLiteral("Over time"));
  CHECK(document.isShownOutOfDate());
  CHECK(told > 0);
  told = 0;
  document.undoStack()->undo();
  CHECK_FALSE(document.isShownOutOfDate());
  CHECK(told > 0);
}

TEST_CASE("a frame that is corrected again begins with what was carried there meanwhile",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(carryFrom(document, heart));
  REQUIRE(startCorrecting(document, 3));
  REQUIRE(keepCorrection(document));
  REQUIRE(startCorrecting(document, 1));
  REQUIRE(document.paintWalls({{heart.seed + Vec3(0, 0, 36), 10}}));
  REQUIRE(waitFor([&] { return document.wallConflict().has_value(); }));
  REQUIRE(runToEnd(document));
  REQUIRE(keepCorrection(document));
  const double carried = volumeAt(document, 3);
  REQUIRE(startCorrecting(document, 3));
  CHECK(std::abs(document.snapshot()->certificate.volume / carried - 1) < 1e-4);  // but for the rounding
}

namespace {

//! Two time points of a dark ball; the images of time point T are called 1.9.T.…
void writeBeatingSeries(const std::string& folder) {
  constexpr int kSide = 24;
  std::vector<test::Slice> slices;
  for (int t = 0; t < 2; ++t)
    for (int z = 0; z < kSide; ++z) {
      test::Slice s;
      s.columns = s.rows = kSide;
      s.spacing = "1\\1";
      s.position = {0, 0, double(z)};
      s.temporalPosition = 1 + t;
      s.number = 1 + t * kSide + z;
      s.instance = "1.9." + std::to_string(t) + "." + std::to_string(1 + z);
      s.pixel = [z](int x, int y) { return (Vec3(x, y, z) - Vec3::Constant(12)).norm() < 7 ? 50 : 200; };
      slices.push_back(s);
    }
  test::writeSeries(folder, slices);
}

}  // namespace

TEST_CASE("a DICOM segmentation refers to the images of the time point that is shown", "[document][time]") {
  const QTemporaryDir folder;
  const QString series = folder.filePath(QStringLiteral("series"));
  writeBeatingSeries(series.toStdString());
  Document document;
  QString written;
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written = path; });
  REQUIRE(openAndWait(document, series));
  REQUIRE(document.time().frameCount() == 2);
  const int frame = GENERATE(0, 1);
  if (frame != document.time().shownFrame()) REQUIRE(showFrame(document, frame));
  document.addSeed({Vec3::Constant(12), {}});
  REQUIRE(runToEnd(document));
  const QString path = folder.filePath(QStringLiteral("ball.seg.dcm"));
  document.exportResult(path, CoordinateSpace::lps);
  REQUIRE(waitFor([&] { return !written.isEmpty(); }));
  const QByteArray bytes = bytesOf(path);
  const auto refersTo = [&](int t) {
    return bytes.contains(QByteArray("1.9.") + QByteArray::number(t) + ".");
  };
  CHECK(refersTo(frame));
  CHECK_FALSE(refersTo(1 - frame));
}
