// The surface of a 4D volume in a document, carried through its frames.

#include <QStandardPaths>

#include "core/errors.h"
#include "core/io/report/session.h"
#include "core/sequence/over_time.h"
#include "tests/ui/model/time_support.h"

using namespace handlebody;
using namespace handlebody::ui;

TEST_CASE("the surface is carried both ways as the command line does it, bit for bit", "[document][time]") {
  const BeatingFile heart;
  Document document;
  QStringList written;
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  QObject::connect(&document, &Document::sessionSaved, [&](const QString& path) { written << path; });
  REQUIRE(growInFrame(document, heart, 2));
  REQUIRE(carryAll(document));
  CHECK(document.time().isComplete());
  CHECK(document.time().curve().endDiastole.has_value());
  REQUIRE(document.time().drifts().size() == 2);
  CHECK(document.time().drifts()[0].dice > 0.97);
  REQUIRE(showFrame(document, 4));
  REQUIRE(document.snapshot() != nullptr);
  CHECK(document.snapshot()->certificate.passes());
  document.exportFrames(heart.file("window.ply"), CoordinateSpace::lps);
  document.exportFrames(heart.file("window.nii"), CoordinateSpace::lps);
  document.saveSession(heart.file("session.json"));
  REQUIRE(waitFor([&] { return written.size() == 3; }));
  REQUIRE(runCli({"replay", heart.file("session.json"), "-o", heart.file("cli.ply"), "-o",
                  heart.file("cli.nii"), "--quiet"}) == 0);
  for (int f = 0; f < BeatingFile::kFrames; ++f) {
    const QString number = QStringLiteral("_%1.ply").arg(f, 4, 10, QLatin1Char('0'));
    CHECK(bytesOf(heart.folder.filePath("window" + number)) ==
          bytesOf(heart.folder.filePath("cli" + number)));
    CHECK_FALSE(bytesOf(heart.folder.filePath("cli" + number)).isEmpty());
  }
  CHECK(bytesOf(heart.file("window.nii")) == bytesOf(heart.file("cli.nii")));
}

TEST_CASE(
    "frames are polished as they are exported, one alone as among all, and a replay makes the same bits",
    "[document][time][polish]") {
  const BeatingFile heart;
  Document document;
  QString told;
  QStringList written;
  QObject::connect(&document, &Document::polished, [&](const QString& text) { told = text; });
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  QObject::connect(&document, &Document::sessionSaved, [&](const QString& path) { written << path; });
  REQUIRE(openAndWait(document, heart.path));
  REQUIRE(showFrame(document, 2));
  document.addSeed({heart.seed, {}});
  Constraints constraints;  // the rim around this wall is sharp in the largest frames
  constraints.walls.balls = {{heart.seed + Vec3(0, 0, 25), 12}};
  document.setConstraints(constraints, "Wall");
  REQUIRE(runToEnd(document));
  OverTimeRequest request;
  request.drift = DriftCheck::none;
  document.setOverTime(request, "Drift");
  REQUIRE(carryAll(document));
  document.exportFrames(heart.file("window.ply"), CoordinateSpace::ras);
  document.exportFrames(heart.file("window.nii"), CoordinateSpace::ras);
  document.saveSession(heart.file("session.json"));
  REQUIRE(waitFor([&] { return written.size() == 3; }));
  CHECK(told.contains("Polished"));
  REQUIRE(runCli({"replay", heart.file("session.json"), "-o", heart.file("cli.ply"), "-o",
                  heart.file("cli.nii"), "--quiet"}) == 0);
  CHECK(bytesOf(heart.file("window.nii")) == bytesOf(heart.file("cli.nii")));

  REQUIRE(showFrame(document, 0));
  document.exportResult(heart.file("alone.ply"), CoordinateSpace::ras);
  document.setPolishes(false);
  document.exportFrames(heart.file("off.ply"), CoordinateSpace::ras);
  REQUIRE(waitFor([&] { return written.size() == 5; }));
  CHECK(bytesOf(heart.file("alone.ply")) == bytesOf(heart.file("window_0000.ply")));
  int changed = 0;
  for (int f = 0; f < BeatingFile::kFrames; ++f) {
    const QString number = QStringLiteral("_%1.ply").arg(f, 4, 10, QLatin1Char('0'));
    const QByteArray mesh = bytesOf(heart.folder.filePath("window" + number));
    CHECK(mesh == bytesOf(heart.folder.filePath("cli" + number)));
    if (mesh != bytesOf(heart.folder.filePath("off" + number))) ++changed;
  }
  CHECK(changed > 0);
}

TEST_CASE("an export of frames that is cancelled leaves nothing of them and is told", "[document][time]") {
  const BeatingFile heart;
  Document document;
  QStringList written, cancelled;
  QString failed;
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  QObject::connect(&document, &Document::exportCancelled, [&](const QString& path) { cancelled << path; });
  QObject::connect(&document, &Document::exportFailed, [&](const QString& why) { failed = why; });
  QObject::connect(&document, &Document::exportRefused, [&](const QString& why) { failed = why; });
  REQUIRE(growInFrame(document, heart));
  OverTimeRequest request;
  request.drift = DriftCheck::none;
  document.setOverTime(request, "Drift");
  REQUIRE(carryAll(document));
  const QStringList before = QDir(heart.folder.path()).entryList(QDir::Files | QDir::Hidden);
  for (const char* name : {"gone.vtp", "gone.nii.gz"}) {
    document.exportFrames(heart.file(name), CoordinateSpace::lps);
    document.cancelExport();
    const auto ended = written.size() + cancelled.size() + 1;
    REQUIRE(waitFor([&] { return written.size() + cancelled.size() == ended; }));
    CHECK(cancelled.contains(heart.file(name)));
  }
  const QString kept = heart.file("kept.nii.gz");  // begun when those were cancelled
  document.exportFrames(kept, CoordinateSpace::lps);
  REQUIRE(waitFor([&] { return !written.isEmpty() || !failed.isEmpty(); }));
  CHECK(written == QStringList{kept});
  CHECK(failed.isEmpty());
  const QStringList now = QDir(heart.folder.path()).entryList(QDir::Files | QDir::Hidden);
  CHECK(now == before + QStringList{QStringLiteral("kept.nii.gz")});
}

TEST_CASE("a frame in which it fails is told with its sentence, and the others are carried on",
          "[document][time]") {
  const BeatingFile heart(3);
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  const FrameResult* failed = document.time().resultOf(3);
  REQUIRE(failed != nullptr);
  CHECK_FALSE(failed->isTrusted());
  REQUIRE_FALSE(failed->faults.empty());
  CHECK_FALSE(sentence(failed->faults.front().finding).empty());
  REQUIRE(document.time().resultOf(4) != nullptr);
  CHECK(document.time().resultOf(4)->isTrusted());
  CHECK(document.time().resultOf(4)->from == 2);
}

TEST_CASE("what is carried can be cancelled, and what there was is kept", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  document.carryOverTime();
  REQUIRE(waitFor([&] { return document.time().carried().size() >= 2; }));
  document.time().cancel();
  CHECK_FALSE(document.time().isCarrying());
  const std::size_t kept = document.time().carried().size();
  waitMilliseconds(1000);
  CHECK(document.time().carried().size() == kept);
  CHECK_FALSE(document.time().isComplete());
}

TEST_CASE("frames are not written while some are missing, and it says which there are", "[document][time]") {
  const BeatingFile heart;
  Document document;
  QString refused;
  QStringList written;
  QObject::connect(&document, &Document::exportRefused, [&](const QString& why) { refused = why; });
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  REQUIRE(growInFrame(document, heart));
  TimeSeries& time = document.time();
  const auto cancelling = QObject::connect(&time, &TimeSeries::carriedChanged, [&] {
    if (time.isCarrying() && time.carried().size() == 2) time.cancel();
  });
  REQUIRE(carryAll(document));
  QObject::disconnect(cancelling);
  REQUIRE(time.carried().size() == 2);
  CHECK(document.isCarriedCurrent());
  for (const char* name : {"part.nii", "part.ply"}) {
    refused.clear();
    document.exportFrames(heart.file(name), CoordinateSpace::lps);
    CHECK(refused.contains(QStringLiteral("0–2")));  // not those of the range, 0–4, alone
    CHECK(refused == document.framesFault());
  }
  REQUIRE(carryAll(document));
  CHECK(document.framesFault().isEmpty());
  document.exportFrames(heart.file("whole.nii"), CoordinateSpace::lps);
  REQUIRE(waitFor([&] { return !written.isEmpty(); }));
  CHECK(written == QStringList{heart.file("whole.nii")});
  CHECK_FALSE(QFile::exists(heart.file("part.nii")));
}

TEST_CASE("another surface in its frame makes what was carried out of date", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  CHECK(document.isCarriedCurrent());
  REQUIRE(showIteration(document, 2));
  CHECK_FALSE(document.isCarriedCurrent());
  REQUIRE(showIteration(document, document.lastIteration()));
  CHECK(document.isCarriedCurrent());
}

TEST_CASE("a session over time opens as it was and is carried again", "[document][time]") {
  const BeatingFile heart;
  std::vector<double> volumes;
  {
    Document document;
    bool saved = false;
    QObject::connect(&document, &Document::sessionSaved, [&] { saved = true; });
    REQUIRE(growInFrame(document, heart, 1));
    OverTimeRequest request;
    request.drift = DriftCheck::none;
    request.frames = OverTimeRequest::Range{1, 3};
    document.setOverTime(request, "Range");
    REQUIRE(carryAll(document));
    for (const auto& [frame, carried] : document.time().carried()) volumes.push_back(carried.result.volume);
    REQUIRE(volumes.size() == 2);
    document.saveSession(heart.file("session.json"));
    REQUIRE(waitFor([&] { return saved; }));
  }
  Document document;
  REQUIRE(openAndWait(document, heart.file("session.json")));
  REQUIRE(waitFor([&] { return document.time().isComplete() && !document.time().isCarrying(); }, 120));
  CHECK(document.time().grownFrame() == 1);
  std::vector<double> again;
  for (const auto& [frame, carried] : document.time().carried()) again.push_back(carried.result.volume);
  CHECK(again == volumes);
  CHECK(document.time().request().drift == DriftCheck::none);
}

TEST_CASE("how it is carried is an entry of the undo list", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  OverTimeRequest request;
  request.holdTopology = false;
  document.setOverTime(request, "Topology over time");
  CHECK(document.isModified());
  CHECK_FALSE(document.time().request().holdTopology);
  document.undoStack()->undo();
  CHECK(document.time().request().holdTopology);
  CHECK_FALSE(document.time().isAsked());
}

TEST_CASE("several objects, or none, are not carried, and it says why", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  CHECK(document.carryFault().contains("no surface"));
  REQUIRE(growInFrame(document, heart));
  CHECK(document.carryFault().isEmpty());
  document.addObject();
  CHECK(document.carryFault().contains("Several"));
  document.carryOverTime();
  CHECK_FALSE(document.time().isCarrying());
}

TEST_CASE("a surface that comes from a file is not carried, and it says why", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  const QString path = heart.file("surface.stl");
  QString written, opened;
  QObject::connect(&document, &Document::exported, [&](const QString& p) { written = p; });
  document.exportResult(path, CoordinateSpace::lps);
  REQUIRE(waitFor([&] { return !written.isEmpty(); }));
  REQUIRE(openAndWait(document, heart.path));
  QObject::connect(&document, &Document::objectsOpened, [&](const QString& p) { opened = p; });
  document.openObjects({path, OpenAs::start});
  REQUIRE(waitFor([&] { return !opened.isEmpty(); }));
  document.removeObject(0);  // the one without a click
  REQUIRE(document.objectCount() == 1);
  CHECK(document.carryFault().contains("from a file"));
}

namespace {

//! Frame 2 of a surface that was grown in frame 0, with a wall over its tip: it is pushed out of that. (One
//! that lies wholly in the surface is refused, as in every growth.)
bool correct(Document& document, const BeatingFile& heart) {
  if (!showFrame(document, 2)) return false;
  document.correctShownFrame();
  if (!waitFor([&] { return document.state() == GrowthState::finished; }, 120)) return false;
  if (!document.paintWalls({{heart.seed + Vec3(0, 0, 36), 10}})) return false;
  if (!waitFor([&] { return document.wallConflict().has_value(); })) return false;
  return document.wallConflict()->canBePushedOut && runToEnd(document);
}

}  // namespace

TEST_CASE("a corrected frame starts as it was carried", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  REQUIRE(showFrame(document, 3));
  const double carried = document.snapshot()->certificate.volume;
  document.correctShownFrame();
  CHECK(document.correctedFrame() == 3);
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }, 120));
  CHECK(std::abs(document.snapshot()->certificate.volume / carried - 1) < 1e-4);  // but for the rounding
  document.endCorrection(false);
  CHECK_FALSE(document.correctedFrame());
  CHECK(document.isCarriedCurrent());
  CHECK(document.time().request().corrections.empty());
}

TEST_CASE("a frame is corrected, those beyond it start from it, and a replay makes the same bits",
          "[document][time]") {
  const BeatingFile heart;
  Document document;
  QStringList written;
  QObject::connect(&document, &Document::exported, [&](const QString& path) { written << path; });
  QObject::connect(&document, &Document::sessionSaved, [&](const QString& path) { written << path; });
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  std::vector<double> before;
  for (int f = 0; f < BeatingFile::kFrames; ++f) before.push_back(document.time().resultOf(f)->volume);
  REQUIRE(correct(document, heart));
  document.endCorrection(true);
  CHECK_FALSE(document.correctedFrame());
  REQUIRE(waitFor([&] { return !document.time().isCarrying(); }, 200));
  CHECK(document.time().resultOf(1)->volume == before[1]);
  CHECK(document.time().resultOf(2)->volume < before[2]);
  CHECK(document.time().resultOf(4)->volume != before[4]);
  document.exportFrames(heart.file("window.ply"), CoordinateSpace::lps);
  document.saveSession(heart.file("session.json"));
  REQUIRE(waitFor([&] { return written.size() == 2; }));
  REQUIRE(runCli({"replay", heart.file("session.json"), "-o", heart.file("cli.ply"), "--quiet"}) == 0);
  for (int f = 0; f < BeatingFile::kFrames; ++f) {
    const QString number = QStringLiteral("_%1.ply").arg(f, 4, 10, QLatin1Char('0'));
    CHECK(bytesOf(heart.folder.filePath("window" + number)) ==
          bytesOf(heart.folder.filePath("cli" + number)));
  }
}

TEST_CASE(
    "a wall that lies wholly in the corrected surface is refused with a sentence, and undo takes it away",
    "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  REQUIRE(showFrame(document, 2));
  document.correctShownFrame();
  REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }, 120));
  REQUIRE(document.paintWalls({{heart.seed + Vec3(0, 0, 14), 8}}));
  REQUIRE(waitFor([&] { return document.wallConflict().has_value(); }));
  CHECK_FALSE(document.wallConflict()->canBePushedOut);
  document.run();
  REQUIRE(waitFor([&] { return !document.growthError().isEmpty(); }));
  document.goOnBeforeWalls();  // it is in what was carried already: there is nothing to begin with
  REQUIRE(waitFor([&] { return document.state() == GrowthState::none; }));
  CHECK_FALSE(document.growthError().isEmpty());
  document.undoStack()->undo();
  REQUIRE(runToEnd(document));
  CHECK_FALSE(document.wallConflict());
  document.endCorrection(false);
  CHECK(document.isCarriedCurrent());
}

TEST_CASE("a correction is kept when the surface that it was carried from is undone", "[document][time]") {
  const BeatingFile heart;
  Document document;
  QStringList refused;
  QObject::connect(&document, &Document::refused, [&](const QString& why) { refused << why; });
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  REQUIRE(correct(document, heart));
  while (document.undoStack()->canUndo()) document.undoStack()->undo();  // to before the seed
  while (document.undoStack()->canRedo()) document.undoStack()->redo();
  REQUIRE(document.correctedFrame() == 2);
  REQUIRE(runToEnd(document));
  document.endCorrection(true);
  CHECK_FALSE(document.correctedFrame());
  CHECK(document.time().request().corrections.size() == 1);
  CHECK_FALSE(document.time().isCarrying());
  CHECK(refused == QStringList{document.carryFault()});
}

TEST_CASE("undo leads back into the corrected frame", "[document][time]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  REQUIRE(correct(document, heart));
  document.endCorrection(true);
  REQUIRE(waitFor([&] { return !document.time().isCarrying(); }, 200));
  REQUIRE(showFrame(document, 0));
  document.undoStack()->undo();  // the wall
  CHECK(document.correctedFrame() == 2);
  CHECK(document.constraints().walls.empty());
  CHECK(document.time().shownFrame() == 2);
  document.endCorrection(false);
  CHECK(document.seeds().size() == 1);
  CHECK(document.time().workFrame() == 0);
}

namespace {

QDir journalFolder() {
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/journal");
  folder.mkpath(".");
  return folder;
}

//! As a killed program leaves it: clicked into, not grown yet, and asked for over time with a correction.
bool leaveJournal(const BeatingFile& heart, const QString& path) {
  Document document;
  QString written;
  QObject::connect(&document, &Document::sessionSaved, [&](const QString& p) { written = p; });
  if (!openAndWait(document, heart.path)) return false;
  document.addSeed({heart.seed, {}});
  OverTimeRequest request;
  request.holdTopology = false;
  request.corrections.push_back({2, {{{heart.seed, {}}}, {}, {}}});
  document.time().setRequest(request, true);
  document.saveSession(path);
  return waitFor([&] { return written == path; });
}

}  // namespace

TEST_CASE("what was asked for over time stands in the journal of what was restored", "[document][time]") {
  const BeatingFile heart;
  const QDir folder = journalFolder();
  const QString killed = folder.filePath("killed.json");
  REQUIRE(leaveJournal(heart, killed));
  Document document;
  REQUIRE(openAndWait(document, killed));
  Document::discardRecoverable(killed);
  const auto kept = [&] { return folder.entryList({"*.json"}, QDir::Files); };
  REQUIRE(waitFor([&] { return kept().size() == 1; }));
  const Session session = readSession(folder.filePath(kept().front()).toStdString());
  REQUIRE(session.overTime.has_value());
  CHECK_FALSE(session.overTime->holdTopology);
  REQUIRE(session.overTime->corrections.size() == 1);
  CHECK(session.overTime->corrections[0].frame == 2);
  CHECK(session.overTime->corrections[0].request.seeds == std::vector<Seed>{{heart.seed, {}}});
  CHECK(document.isModified());
}

TEST_CASE("what is asked for over time is journalled at once", "[document][time]") {
  const BeatingFile heart;
  const QDir folder = journalFolder();
  const QStringList before = folder.entryList({"*.json"}, QDir::Files);
  Document document;
  REQUIRE(openAndWait(document, heart.path));
  document.addSeed({heart.seed, {}});
  QStringList kept;
  REQUIRE(waitFor([&] {
    kept = folder.entryList({"*.json"}, QDir::Files);
    return kept.size() == before.size() + 1;
  }));
  for (const QString& old : before) kept.removeAll(old);
  OverTimeRequest request;
  request.holdTopology = false;
  document.setOverTime(request, "Topology over time");
  const auto journalled = [&] { return readSession(folder.filePath(kept.front()).toStdString()).overTime; };
  CHECK(waitFor([&] { return journalled() && !journalled()->holdTopology; }));
  document.undoStack()->undo();
  CHECK(waitFor([&] { return !journalled(); }));
}
