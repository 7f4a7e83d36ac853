// What the Document writes: the same files as the command line's, sessions that come back, journals.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <functional>

#include "core/collision/certify.h"
#include "core/io/report/session.h"
#include "tests/ui/model/output_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct GrownWork : OutputWork {
  GrownWork() { document.addSeed(torus.seed); }
  bool exportTo(const QString& path) {
    document.exportResult(path, CoordinateSpace::lps);
    return isWritten(path);
  }
  bool saveTo(const QString& path) {
    document.saveSession(path);
    return isWritten(path);
  }
};

//! What `replay` makes of a session, as STL bytes.
QByteArray replayed(const TorusFile& torus, const QString& session) {
  const QString mesh = torus.file("replayed.stl");
  QFile::remove(mesh);
  CHECK(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), mesh, QStringLiteral("--quiet")}) ==
        0);
  return bytesOf(mesh);
}

}  // namespace

TEST_CASE("a surface that shrank away is not exported, and that is said", "[document]") {
  GrownWork work;
  Parameters p = work.document.parameters();
  p.direction = Direction::both;
  p.balloon = 0.01;
  p.curvature = 1;  // hardly anything but curvature: the seed ball shrinks to a point
  work.document.setParameters(p, QStringLiteral("Shrink"));
  REQUIRE(runToEnd(work.document));
  CHECK(work.document.stopReason() == StopReason::empty);
  REQUIRE(work.document.snapshot());
  CHECK(work.document.snapshot()->mesh.triangles.empty());
  CHECK_FALSE(work.exportTo(work.torus.file("nothing.stl")));
  CHECK(work.failed.contains(QLatin1String("Nothing is left")));
  CHECK_FALSE(QFile::exists(work.torus.file("nothing.stl")));
  work.document.goTo(0);
  CHECK(waitFor([&] { return work.document.iteration() == 0; }));
  work.failed.clear();
  CHECK(work.exportTo(work.torus.file("seed.stl")));
}

TEST_CASE("a mesh is exported as the command line writes it", "[document]") {
  GrownWork work;
  REQUIRE(runToEnd(work.document));
  const QString mine = work.torus.file("mine.stl"), theirs = work.torus.file("theirs.stl");
  REQUIRE(work.exportTo(mine));
  const Vec3& c = work.torus.seed.centre;
  const QString seed =
      QStringLiteral("%1,%2,%3,3").arg(c.x(), 0, 'g', 17).arg(c.y(), 0, 'g', 17).arg(c.z(), 0, 'g', 17);
  REQUIRE(runCli({QStringLiteral("segment"), work.torus.path, QStringLiteral("--seed"), seed,
                  QStringLiteral("-o"), theirs, QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(mine).size() > 1000);
  CHECK(bytesOf(mine) == bytesOf(theirs));
  CHECK(certify(readMesh(mine.toStdString())).passes());
}

TEST_CASE("a label map and a report are written as well, and the report is a session", "[document]") {
  GrownWork work;
  REQUIRE(runToEnd(work.document));
  REQUIRE(work.exportTo(work.torus.file("label.nii.gz")));
  CHECK(readVolume(work.torus.file("label.nii.gz").toStdString()).grid.size == std::array{41, 41, 41});
  const QString report = work.torus.file("report.json"), mesh = work.torus.file("mesh.stl");
  work.document.exportReport(report);
  REQUIRE(waitFor([&] { return work.written.contains(report); }));
  REQUIRE(work.exportTo(mesh));
  CHECK(bytesOf(report).contains("\"stopped\": \"converged\""));
  CHECK(replayed(work.torus, report) == bytesOf(mesh));
}

TEST_CASE("the report's part without an edge is that of the shown surface, here and in a replay",
          "[document]") {
  GrownWork work;
  for (int iterations : {4, 12}) {  // on the way: the front has not come to the edge everywhere
    REQUIRE(work.stepTo(iterations));
    const SurfaceSupport support = work.document.snapshot()->support;
    CHECK(support.faces.size() == work.document.snapshot()->mesh.triangles.size());
    CHECK(support.withoutEdge > 0);
    const QString report = work.torus.file("report.json"), again = work.torus.file("again.json");
    work.written.clear();
    work.document.exportReport(report);
    REQUIRE(waitFor([&] { return work.written.contains(report); }));
    REQUIRE(runCli({QStringLiteral("replay"), report, QStringLiteral("-o"), work.torus.file("again.stl"),
                    QStringLiteral("--report"), again, QStringLiteral("--quiet")}) == 0);
    for (const QString& path : {report, again}) {
      const auto json = QJsonDocument::fromJson(bytesOf(path)).object();
      CHECK(json[QLatin1String("unsupported_surface")].toDouble() == Approx(support.withoutEdge));
    }
  }
}

TEST_CASE("an export that fails says so and leaves what was there", "[document]") {
  GrownWork work;
  work.document.exportResult(work.torus.file("early.stl"), CoordinateSpace::lps);
  CHECK_FALSE(work.failed.isEmpty());
  work.failed.clear();
  REQUIRE(runToEnd(work.document));
  for (const char* name : {"mesh.xyz", "nowhere/mesh.stl"}) {
    work.failed.clear();
    CHECK_FALSE(work.exportTo(work.torus.file(name)));
    INFO(work.failed.toStdString());
    CHECK(work.failed.endsWith(QLatin1Char('.')));
  }
  CHECK(work.document.state() == GrowthState::finished);
}

TEST_CASE("a growth with parameters changed on the way replays to the same bytes", "[document]") {
  GrownWork work;
  Document& document = work.document;
  REQUIRE(work.stepTo(20));
  document.stepBack();
  REQUIRE(waitFor([&] { return document.iteration() == 19; }));
  Parameters p = document.parameters();
  p.curvature = 0.5;
  document.setParameters(p, QStringLiteral("Change curvature"));
  REQUIRE(work.stepTo(30));
  CHECK(document.lastIteration() == 30);
  p.balloon = 0.7;
  p.edgeLength = 1.6;
  document.setParameters(p, QStringLiteral("Change edge length"));
  REQUIRE(work.stepTo(42));
  const QString session = work.torus.file("session.json"), mesh = work.torus.file("mesh.stl");
  REQUIRE(work.saveTo(session));
  REQUIRE(work.exportTo(mesh));
  const Session saved = readSession(session.toStdString());
  REQUIRE(saved.changes.size() == 2);
  CHECK(saved.changes[0].iteration == 19);
  CHECK(saved.changes[1].iteration == 30);
  CHECK(saved.stopAt == 42);
  CHECK(replayed(work.torus, session) == bytesOf(mesh));

  SECTION("and comes back in the window as it was") {
    Document other;
    other.open(session);
    REQUIRE(waitFor([&] { return other.iteration() == 42 && isAtRest(other); }));
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
    CHECK(other.parameters() == p);
    CHECK(other.lastIteration() == 42);
    CHECK(other.sessionPath() == session);
    CHECK_FALSE(other.isModified());
    other.run();
    document.run();
    REQUIRE(waitFor([&] { return other.state() == GrowthState::finished; }));
    REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
  }
  SECTION("and an earlier iteration is what is saved when that is shown") {
    REQUIRE(showIteration(document, 25));
    REQUIRE(work.saveTo(work.torus.file("earlier.json")));
    REQUIRE(work.exportTo(work.torus.file("earlier.stl")));
    CHECK(replayed(work.torus, work.torus.file("earlier.json")) == bytesOf(work.torus.file("earlier.stl")));
  }
  SECTION("and parameters changed at rest are kept for what comes next") {
    p.curvature = 0.1;
    document.setParameters(p, QStringLiteral("Change curvature"));
    CHECK(document.isModified());
    REQUIRE(work.saveTo(work.torus.file("later.json")));
    CHECK_FALSE(document.isModified());
    Document other;
    other.open(work.torus.file("later.json"));
    REQUIRE(waitFor([&] { return other.iteration() == 42 && isAtRest(other); }));
    CHECK(other.parameters() == p);
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
  }
}

TEST_CASE("a replay that is paused goes on as it was recorded, until something is edited", "[document]") {
  GrownWork work;
  REQUIRE(work.stepTo(10));
  Parameters stiff = work.document.parameters();
  stiff.curvature = 0.8;
  work.document.setParameters(stiff, QStringLiteral("Curvature"));
  REQUIRE(work.stepTo(20));
  const TriangleSoup recorded = work.document.snapshot()->mesh;
  const QString session = work.torus.file("session.json");
  REQUIRE(work.saveTo(session));

  OutputWork other;
  Document& document = other.document;
  REQUIRE(openAndWait(document, session));
  document.pause();
  REQUIRE(other.stepTo(5));
  REQUIRE(document.lastIteration() < 10);
  SECTION("step by step") {
    REQUIRE(other.stepTo(20));
    CHECK(isSame(document.snapshot()->mesh, recorded));
    CHECK_FALSE(document.isModified());
    REQUIRE(other.stepTo(21));  // what was recorded is done
  }
  SECTION("at once, after a look back") {
    REQUIRE(showIteration(document, 2));
    document.run();
    REQUIRE(waitFor([&] { return document.iteration() == 20 && isAtRest(document); }));
    waitMilliseconds(300);
    CHECK(document.lastIteration() == 20);
    CHECK(isSame(document.snapshot()->mesh, recorded));
  }
  SECTION("what is saved meanwhile is all of it") {
    const QString again = other.torus.file("again.json");
    document.saveSession(again);
    REQUIRE(other.isWritten(again));
    const auto saved = readSessions(again.toStdString());
    CHECK(saved.front().stopAt == 20);
    REQUIRE(saved.front().changes.size() == 1);
    CHECK(saved.front().changes[0].iteration == 10);
  }
  SECTION("with other parameters it is another growth") {
    stiff.curvature = 0.4;
    document.setParameters(stiff, QStringLiteral("Curvature"));
    REQUIRE(other.stepTo(document.iteration() + 1));
    const QString edited = other.torus.file("edited.json");
    document.saveSession(edited);
    REQUIRE(other.isWritten(edited));
    CHECK(readSessions(edited.toStdString()).front().stopAt == document.iteration());
  }
}

TEST_CASE("a growth with clicks changed on the way replays to the same bytes", "[document]") {
  GrownWork work;
  Document& document = work.document;
  REQUIRE(work.stepTo(9));
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), {}});
  REQUIRE(work.stepTo(15));
  document.addSeed({testing::kMiddle + Vec3(0, 0, 12), {}, true});
  document.moveSeed(1, testing::kMiddle - Vec3(testing::kTorusR, 0, 1));
  REQUIRE(work.stepTo(24));
  const QString session = work.torus.file("session.json"), mesh = work.torus.file("mesh.stl");
  REQUIRE(work.saveTo(session));
  REQUIRE(work.exportTo(mesh));
  const Session saved = readSession(session.toStdString());
  CHECK(saved.seeds == std::vector<Seed>{work.torus.seed});
  REQUIRE(saved.changes.size() == 2);
  CHECK(saved.changes[0].iteration == 9);
  CHECK(saved.changes[0].seeds->size() == 2);
  CHECK(saved.changes[1].iteration == 15);
  CHECK(saved.changes[1].seeds == document.seeds());
  CHECK(replayed(work.torus, session) == bytesOf(mesh));

  SECTION("and comes back in the window as it was") {
    Document other;
    other.open(session);
    REQUIRE(waitFor([&] { return other.iteration() == 24 && isAtRest(other); }));
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
    CHECK(other.seeds() == document.seeds());
    CHECK(other.corrections().size() == 2);
    CHECK_FALSE(other.isModified());
    REQUIRE(waitFor([&] { return other.resolved().has_value(); }));
    other.run();
    document.run();
    REQUIRE(waitFor([&] { return other.state() == GrowthState::finished; }));
    REQUIRE(waitFor([&] { return document.state() == GrowthState::finished; }));
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
  }
  SECTION("and the report tells what came of them, and is a session") {
    const QString report = work.torus.file("report.json");
    document.exportReport(report);
    REQUIRE(waitFor([&] { return work.written.contains(report) || !work.failed.isEmpty(); }));
    CHECK(bytesOf(report).contains("\"fronts_added\": 1"));
    CHECK(replayed(work.torus, report) == bytesOf(mesh));
  }
  SECTION("and a click that has not been gone on with is kept for what comes next") {
    document.removeSeed(2);
    CHECK(document.isModified());
    REQUIRE(work.saveTo(work.torus.file("later.json")));
    Document other;
    other.open(work.torus.file("later.json"));
    REQUIRE(waitFor([&] { return other.iteration() == 24 && isAtRest(other); }));
    CHECK(other.seeds() == document.seeds());
    CHECK(isSame(other.snapshot()->mesh, document.snapshot()->mesh));
  }
}

TEST_CASE("a session keeps seeds, parameters and the window's view", "[document]") {
  GrownWork work;
  Parameters p;
  p.smoothing = 0.4;
  work.document.setParameters(p, QStringLiteral("Change smoothing"));
  work.document.setView("{\"zoom\":2}");
  const QString session = work.torus.file("session.json");
  CHECK(work.document.isModified());
  REQUIRE(work.saveTo(session));
  CHECK_FALSE(work.document.isModified());
  CHECK(work.document.sessionPath() == session);
  Document other;
  REQUIRE(openAndWait(other, session));
  CHECK(other.seeds() == work.document.seeds());
  CHECK(other.parameters() == p);
  CHECK(other.view() == "{\"zoom\":2}");
  CHECK(other.sessionPath() == session);
  CHECK_FALSE(other.isModified());
  CHECK(other.state() == GrowthState::none);
}

TEST_CASE("what a session says of frames of a 4D volume is kept, though the window shows one", "[document]") {
  GrownWork work;
  const QString session = work.torus.file("session.json"), again = work.torus.file("again.json"),
                plain = work.torus.file("plain.json");
  REQUIRE(work.saveTo(session));
  QFile file(session);
  REQUIRE(file.open(QIODevice::ReadWrite));
  QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
  CHECK_FALSE(json.contains("over_time"));
  const QJsonObject over{{"frames", QJsonArray{0, 0}}, {"topology", "free"}, {"drift_check", "none"}};
  json["over_time"] = over;
  file.resize(0);
  file.write(QJsonDocument(json).toJson());
  file.close();
  REQUIRE(openAndWait(work.document, session));
  REQUIRE(work.saveTo(again));
  QFile saved(again);
  REQUIRE(saved.open(QIODevice::ReadOnly));
  const QJsonObject kept = QJsonDocument::fromJson(saved.readAll()).object()["over_time"].toObject();
  for (const QString& key : over.keys()) CHECK(kept[key] == over[key]);
  REQUIRE(openAndWait(work.document, work.torus.path));  // another volume is not over time
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.saveTo(plain));
  QFile other(plain);
  REQUIRE(other.open(QIODevice::ReadOnly));
  CHECK_FALSE(QJsonDocument::fromJson(other.readAll()).object().contains("over_time"));
}

TEST_CASE("a session whose volume has changed is refused", "[document]") {
  GrownWork work;
  const QString session = work.torus.file("session.json");
  REQUIRE(work.saveTo(session));
  QFile volume(work.torus.path);
  REQUIRE(volume.open(QIODevice::ReadWrite));
  volume.seek(volume.size() - 1);
  volume.write("x");
  volume.close();
  Document other;
  QString sentence;
  QObject::connect(&other, &Document::openFailed, [&](const QString& text) { sentence = text; });
  CHECK_FALSE(openAndWait(other, session));
  CHECK(sentence.contains(QStringLiteral("SHA-256")));
}

TEST_CASE("a session that is saved while another file is read is not where that is saved again",
          "[document]") {
  GrownWork work;
  const TorusFile other;
  const QString session = work.torus.file("session.json");
  work.document.open(other.path);
  CHECK(work.saveTo(session));
  REQUIRE(waitFor([&] { return work.document.path() == other.path; }));
  CHECK(work.document.sessionPath().isEmpty());
  CHECK_FALSE(work.document.isModified());
}

TEST_CASE("a session is saved where another file that is read meanwhile cannot be opened", "[document]") {
  GrownWork work;
  const QString session = work.torus.file("session.json");
  int failed = 0;
  QObject::connect(&work.document, &Document::openFailed, [&] { ++failed; });
  work.document.saveSession(session);
  work.document.open(work.torus.file("missing.mha"));
  CHECK(work.isWritten(session));
  CHECK(waitFor([&] { return failed == 1; }));
  CHECK(work.document.sessionPath() == session);
  CHECK_FALSE(work.document.isModified());
}

TEST_CASE("a session that somebody else has written is told from the one that was opened or saved",
          "[document]") {
  GrownWork work;
  const QString session = work.torus.file("session.json");
  const auto writeElsewhere = [&] {
    QFile file(session);
    return file.open(QIODevice::Append) && file.write("\n") == 1;
  };
  CHECK_FALSE(work.document.isSessionChangedElsewhere());  // there is none
  REQUIRE(work.saveTo(session));
  CHECK_FALSE(work.document.isSessionChangedElsewhere());
  Document other;
  REQUIRE(openAndWait(other, session));
  CHECK_FALSE(other.isSessionChangedElsewhere());
  REQUIRE(writeElsewhere());
  CHECK(work.document.isSessionChangedElsewhere());
  CHECK(other.isSessionChangedElsewhere());
  work.written.clear();
  REQUIRE(work.saveTo(session));
  CHECK_FALSE(work.document.isSessionChangedElsewhere());
  CHECK(other.isSessionChangedElsewhere());
  REQUIRE(QFile::remove(session));
  CHECK_FALSE(other.isSessionChangedElsewhere());  // nothing is lost
}

TEST_CASE("what is changed while a session is written is not saved", "[document]") {
  GrownWork work;
  Document& document = work.document;
  const QString session = work.torus.file("session.json");
  const auto saveDuring = [&](const std::function<void()>& change) {
    document.saveSession(session);
    change();
    return work.isWritten(session);
  };
  const auto radius = [&](double r, int gesture = -1) { document.setSeedRadius(0, r, gesture); };
  SECTION("nothing is") {
    CHECK(saveDuring([] {}));
    CHECK_FALSE(document.isModified());
  }
  SECTION("one change is undone and another one made") {
    CHECK(saveDuring([&] {
      document.undoStack()->undo();
      document.addSeed({testing::kMiddle, 2.0});
    }));
    CHECK(document.isModified());
  }
  SECTION("a drag goes on") {
    radius(3.5, 7);
    CHECK(saveDuring([&] { radius(3.6, 7); }));
    CHECK(document.undoStack()->count() == 2);
    CHECK(document.isModified());
  }
  SECTION("and what was saved before is not what the file holds") {
    REQUIRE(saveDuring([] {}));
    work.written.clear();
    radius(3.5);
    CHECK(saveDuring([&] { radius(3.6); }));
    document.undoStack()->undo();
    document.undoStack()->undo();
    CHECK(document.isModified());
  }
}

TEST_CASE("how files are written is no work to be saved before there is a seed", "[document]") {
  OutputWork work;
  work.document.setPolishes(false);
  CHECK_FALSE(work.document.isModified());
}

TEST_CASE("a session without a seed is not saved, and it is said why", "[document]") {
  GrownWork work;
  work.document.removeSeed(0);
  CHECK_FALSE(work.saveTo(work.torus.file("session.json")));
  CHECK_FALSE(QFile::exists(work.torus.file("session.json")));
}

TEST_CASE("a clean close leaves nothing to recover", "[document]") {
  for (const QString& path : Document::recoverable()) Document::discardRecoverable(path);
  {
    GrownWork work;
    waitMilliseconds(200);
    CHECK(Document::recoverable().isEmpty());  // this process lives
  }
  CHECK(Document::recoverable().isEmpty());
}

// Run by the test below in a process of its own, which is then killed.
TEST_CASE("works until it is killed", "[.child]") {
  Document document;
  REQUIRE(openAndWait(document, qEnvironmentVariable("HANDLEBODY_TEST_VOLUME")));
  document.addSeed({testing::kMiddle + Vec3(testing::kTorusR, 0, 0), 3.0});
  Parameters p;
  p.curvature = 0.3;
  document.setParameters(p, QStringLiteral("Change curvature"));
  for (int i = 1; i <= 8; ++i) {
    document.stepForward();
    REQUIRE(waitFor([&] { return document.iteration() == i && isAtRest(document); }));
  }
  document.moveSeed(0, document.seeds()[0].centre + Vec3(0, 0, 0.25));
  document.undoStack()->undo();
  waitMilliseconds(300);
  std::puts("ready");
  std::fflush(stdout);
  waitMilliseconds(60'000);
}

TEST_CASE("what a killed program was about is recovered", "[document]") {
  const TorusFile torus;
  const QStringList orphans = killedAtWork(torus, QStringLiteral("works until it is killed"));
  REQUIRE(orphans.size() == 1);
  Document document;
  REQUIRE(openAndWait(document, orphans[0]));
  Document::discardRecoverable(orphans[0]);
  CHECK(document.path().toStdString() == torus.path.toStdString());
  REQUIRE(document.seeds().size() == 1);
  CHECK(document.seeds()[0] == torus.seed);
  CHECK(document.parameters().curvature == 0.3);
  CHECK(document.sessionPath().isEmpty());
  CHECK(document.isModified());
  CHECK(Document::recoverable().isEmpty());
}
