// Sessions that name neither the patient nor a file.

#include "core/mesh/shapes.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! A torus that grows, and a ball of a file that is done: the files have the patient's name.
struct NamedWork : ObjectsWork {
  QString volume = torus.file("DOE_JANE.mha"), ball = torus.file("DOE_JANE_ball.stl"),
          session = torus.file("s.json");

  NamedWork() {
    REQUIRE(QFile::copy(torus.path, volume));
    REQUIRE(openAndWait(document, volume));
    writeMesh(icosphere(opposite().centre, 3, 1.0), ball.toStdString());
    int opened = 0;
    QObject::connect(&document, &Document::objectsOpened, [&] { ++opened; });
    document.openObjects({ball});
    REQUIRE(waitFor([&] { return opened == 1; }));
    document.addSeed(torus.seed);
  }
  QByteArray exported() {
    document.exportAnonymousSession(session);
    REQUIRE(isWritten(session));
    return bytesOf(session);
  }
};

//! A document that is asked for files.
struct AskedWork {
  Document document;
  std::vector<FindingKind> asked;
  QString refused, failed;
  int opened = 0;

  AskedWork() {
    QObject::connect(&document, &Document::fileNeeded,
                     [this](const QString&, FindingKind missing, const QString& why) {
                       asked.push_back(missing);
                       refused = why;
                     });
    QObject::connect(&document, &Document::opened, [this] { ++opened; });
    QObject::connect(&document, &Document::openFailed, [this](const QString& why) { failed = why; });
  }
  //! What it asks for next; none: it is open.
  FindingKind next(const QString& session, const QStringList& files) {
    asked.clear();
    opened = 0;
    document.open(session, {}, files);
    REQUIRE(waitFor([&] { return !asked.empty() || opened > 0 || !failed.isEmpty(); }));
    REQUIRE(failed.isEmpty());
    return asked.empty() ? FindingKind::none : asked.front();
  }
};

}  // namespace

TEST_CASE("an anonymous session names neither files nor what is called after them", "[document][anonymous]") {
  NamedWork work;
  REQUIRE(work.save(work.torus.file("named.json")));
  const QByteArray named = bytesOf(work.torus.file("named.json"));
  CHECK((named.contains("DOE_JANE.mha") && named.contains("DOE_JANE_ball.stl")));
  work.document.setView(R"({"from": "DOE_JANE"})");
  const QByteArray hidden = work.exported();
  CHECK_FALSE(hidden.contains("DOE"));
  CHECK_FALSE(hidden.contains(work.torus.folder.path().toUtf8()));
  CHECK(hidden.contains("\"Object 1\""));
  // It is an export: the session stays the one that was saved.
  CHECK(work.document.sessionPath() == work.torus.file("named.json"));
  CHECK(nameOf(work.document, 0) == "DOE_JANE_ball");
}

TEST_CASE("an anonymous session asks for its files, refuses others, and goes on", "[document][anonymous]") {
  NamedWork work;
  work.exported();
  AskedWork other;
  CHECK(other.next(work.session, {}) == FindingKind::sessionWithoutVolume);
  CHECK(other.refused.isEmpty());
  CHECK(other.next(work.session, {work.ball}) == FindingKind::sessionWithoutVolume);
  CHECK((other.refused.contains(work.ball) && other.refused.contains("SHA-256")));
  CHECK_FALSE(other.document.hasVolume());
  CHECK(other.next(work.session, {work.volume}) == FindingKind::sessionWithoutStart);
  CHECK(other.refused.isEmpty());
  CHECK(other.next(work.session, {work.volume, work.ball}) == FindingKind::none);
  CHECK(other.document.path() == work.volume);
  REQUIRE(other.document.objectCount() == 2);
  CHECK(other.document.objectInfo(0).locked);
  CHECK(other.document.objectInfo(1).seeded);
  CHECK(waitFor([&] { return !other.document.isModified(); }));  // once it has come to where it was
}

TEST_CASE("what was opened from an anonymous session is saved elsewhere, with its files",
          "[document][anonymous]") {
  NamedWork work;
  const QByteArray anonymous = work.exported();
  AskedWork other;
  REQUIRE(other.next(work.session, {work.volume, work.ball}) == FindingKind::none);
  CHECK(other.document.sessionPath().isEmpty());
  const QString named = work.torus.file("named.json");
  int saved = 0;
  QObject::connect(&other.document, &Document::sessionSaved, [&] { ++saved; });
  other.document.saveSession(named);
  REQUIRE(waitFor([&] { return saved == 1; }));
  CHECK(other.document.sessionPath() == named);
  CHECK((bytesOf(named).contains("DOE_JANE.mha") && bytesOf(named).contains("DOE_JANE_ball.stl")));
  CHECK(bytesOf(work.session) == anonymous);
  CHECK(other.next(named, {}) == FindingKind::none);
  CHECK(other.document.sessionPath() == named);
}

TEST_CASE("the command line replays an anonymous session of the window when it is told the files",
          "[document][anonymous]") {
  NamedWork work;
  REQUIRE(runToEnd(work.document));
  work.exported();
  const QString mesh = work.torus.file("replayed.stl"), shown = work.torus.file("shown.stl");
  CHECK(runCli({"replay", work.session, "-o", mesh}) == 3);
  CHECK(runCli({"replay", work.session, "--volume", work.volume, "-o", mesh}) == 3);
  REQUIRE(runCli({"replay", work.session, "--volume", work.volume, "--start", work.ball, "-o", mesh}) == 0);
  REQUIRE(work.exportAll(shown));
  CHECK(bytesOf(mesh) == bytesOf(shown));
}

TEST_CASE("no anonymous session is written without a seed, and it is said why", "[document][anonymous]") {
  OutputWork work;
  work.document.exportAnonymousSession(work.torus.file("s.json"));
  CHECK(work.failed.contains("seed"));
  CHECK_FALSE(QFile::exists(work.torus.file("s.json")));
}
