// What is kept for the case of a crash: when it cannot be, and what stands in it.

#include <QStandardPaths>
#include <stdexcept>

#include "core/io/report/session.h"
#include "tests/ui/model/output_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

QDir journalFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/journal");
}

//! A document, and where it keeps its journal: a lock stands there as long as it lives.
template <typename Work>
struct JournalledWork {
  const QStringList before = locks();
  Work work;
  const QString journal = journalFolder().filePath(newLock().chopped(5));

  static QStringList locks() { return journalFolder().entryList({"*.json.lock"}, QDir::Files); }
  QString newLock() const {
    for (const QString& lock : locks())
      if (!before.contains(lock)) return lock;
    throw std::runtime_error("the journal has no lock");
  }
  //! A folder in its place: no file can be written there.
  bool block() const { return QDir().mkdir(journal); }
  bool unblock() const { return QDir().rmdir(journal); }
  //! It holds that one of the first seed.
  bool hasRadius(double radius) const {
    return QFile::exists(journal) && readSession(journal.toStdString()).seeds.at(0).radius == radius;
  }
};

}  // namespace

TEST_CASE("a journal that cannot be written is told once, and again after one that could be", "[document]") {
  const TorusFile torus;
  JournalledWork<Document> kept;
  Document& document = kept.work;
  QStringList told;
  QObject::connect(&document, &Document::journalFailed, [&](const QString& why) { told << why; });
  REQUIRE(kept.block());
  REQUIRE(openAndWait(document, torus.path));
  document.addSeed(torus.seed);
  REQUIRE(waitFor([&] { return told.size() == 1; }));
  document.setSeedRadius(0, 4.0);
  waitMilliseconds(200);
  CHECK(told.size() == 1);
  REQUIRE(kept.unblock());
  document.setSeedRadius(0, 5.0);
  REQUIRE(waitFor([&] { return kept.hasRadius(5); }));
  REQUIRE(QFile::remove(kept.journal));
  REQUIRE(kept.block());
  document.setSeedRadius(0, 6.0);
  CHECK(waitFor([&] { return told.size() == 2; }));
  CHECK(kept.unblock());
}

TEST_CASE("a journal that is restored stays until the one that takes its place is written", "[document]") {
  const QString killed = journalFolder().filePath("killed.json");
  const TorusFile torus;
  {
    Document document;
    bool isSaved = false;
    QObject::connect(&document, &Document::sessionSaved, [&] { isSaved = true; });
    REQUIRE(openAndWait(document, torus.path));
    document.addSeed(torus.seed);
    document.saveSession(killed);
    REQUIRE(waitFor([&] { return isSaved; }));
  }
  JournalledWork<Document> kept;
  Document& document = kept.work;
  int failed = 0;
  QObject::connect(&document, &Document::journalFailed, [&] { ++failed; });
  REQUIRE(kept.block());
  REQUIRE(openAndWait(document, killed));
  REQUIRE(waitFor([&] { return failed == 1; }));
  CHECK(QFile::exists(killed));
  REQUIRE(kept.unblock());
  document.setSeedRadius(0, 4.0);
  CHECK(waitFor([&] { return !QFile::exists(killed); }));
  CHECK(kept.hasRadius(4));
}

TEST_CASE("how files are written is a change of what is saved, and stands in the journal", "[document]") {
  JournalledWork<OutputWork> kept;
  OutputWork& work = kept.work;
  const QString session = work.torus.file("session.json");
  const auto savedAgain = [&] {
    work.written.clear();
    work.document.saveSession(session);
    return work.isWritten(session);
  };
  const auto journalled = [&] { return readSession(kept.journal.toStdString()); };
  work.document.addSeed(work.torus.seed);
  REQUIRE(waitFor([&] { return QFile::exists(kept.journal); }));
  REQUIRE(work.stepTo(2));
  REQUIRE(savedAgain());
  CHECK_FALSE(work.document.isModified());
  work.document.setPolishes(false);
  CHECK(work.document.isModified());
  CHECK(waitFor([&] { return !journalled().polish; }));
  REQUIRE(savedAgain());
  CHECK_FALSE(work.document.isModified());
  work.document.exportResult(work.torus.file("ras.stl"), CoordinateSpace::ras);
  CHECK(work.document.isModified());
  REQUIRE(work.isWritten(work.torus.file("ras.stl")));
  CHECK(waitFor([&] { return journalled().space == CoordinateSpace::ras; }));
  REQUIRE(savedAgain());
  CHECK_FALSE(work.document.isModified());
  CHECK(readSession(session.toStdString()).space == CoordinateSpace::ras);
  work.document.exportResult(work.torus.file("again.stl"), CoordinateSpace::ras);
  CHECK_FALSE(work.document.isModified());  // nothing has changed
}
