// Thin triangles of what the Document writes are bettered, as the command line does it.

#include <QJsonDocument>
#include <QJsonObject>

#include "core/io/report/session.h"
#include "core/mesh/quality.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! A torus that was cut by a plane, which leaves thin triangles at the rim.
struct CutWork : ObjectsWork {
  QString told;
  QStringList polishing;

  CutWork() {
    document.addSeed(torus.seed);
    REQUIRE(runToEnd(document));
    cut();
    QObject::connect(&document, &Document::polished, [this](const QString& text) { told = text; });
    QObject::connect(&document, &Document::exportPolishes,
                     [this](const QString& name) { polishing << name; });
  }
  void cut() {
    bool isCut = false;
    const auto done = QObject::connect(&document, &Document::meshEdited, [&] { isCut = true; });
    MeshEdit edit{0, MeshEditKind::cut, testing::kMiddle + Vec3(0.3, 0.2, 0.1)};
    edit.vector = Vec3(1, 2, 9);
    edit.keep = KeptSide::positive;
    document.editMesh(edit);
    REQUIRE(waitFor([&] { return isCut; }));
    QObject::disconnect(done);
  }
};

double leastAngle(const QString& mesh) { return meshQuality(readMesh(mesh.toStdString())).angles.least; }

}  // namespace

TEST_CASE("a session of the window is replayed as it was polished", "[document][polish]") {
  CutWork work;
  const QString on = work.torus.file("on.stl"), off = work.torus.file("off.stl"),
                session = work.torus.file("s.json"), again = work.torus.file("again.stl");
  CHECK(work.document.polishes());
  REQUIRE(work.exportActive(on));
  CHECK(work.told.contains(QLatin1String("Polished")));
  CHECK(work.polishing.size() == 1);
  REQUIRE(work.save(session));
  REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again,
                  QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(again) == bytesOf(on));

  work.document.setPolishes(false);
  work.told.clear();
  REQUIRE(work.exportActive(off));
  CHECK(work.told.isEmpty());
  CHECK(leastAngle(off) < 15);
  CHECK(leastAngle(on) > leastAngle(off));
  REQUIRE(work.save(session));
  REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again,
                  QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(again) == bytesOf(off));
  Document other;
  REQUIRE(openAndWait(other, session));
  CHECK_FALSE(other.polishes());
}

TEST_CASE("the report tells of the surface as it was polished", "[document][polish]") {
  CutWork work;
  const QString mesh = work.torus.file("m.stl"), report = work.torus.file("r.json");
  REQUIRE(work.exportActive(mesh));
  work.written.clear();
  work.document.exportReport(report);
  REQUIRE(work.isWritten(report));
  const QJsonObject json = QJsonDocument::fromJson(bytesOf(report)).object();
  const QJsonObject after = json["polish"].toObject()["after"].toObject();
  CHECK(after["least_angle_degrees"].toDouble() == Approx(leastAngle(mesh)).epsilon(1e-6));
  CHECK(json["mesh"].toObject()["faces"].toInt() ==
        static_cast<int>(readMesh(mesh.toStdString()).triangles.size()));
}

TEST_CASE("several objects are polished clear of each other, and one alone as among them",
          "[objects][polish]") {
  ObjectsWork work;
  work.growFirst();
  work.growSecond();
  const QString all = work.torus.file("all.vtp"), one = work.torus.file("one.vtp"),
                session = work.torus.file("s.json"), again = work.torus.file("again.vtp");
  const bool isExported = work.exportAll(all);
  INFO(work.failed.toStdString());
  REQUIRE(isExported);
  REQUIRE(work.exportActive(one));
  REQUIRE(work.save(session));
  const QString named = QString::fromStdString(nameOf(work.document, 1)) + QLatin1Char('=') + again;
  REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), named,
                  QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(again) == bytesOf(one));
}

TEST_CASE("polishing is given up when it is cancelled, and nothing is written", "[document][polish]") {
  CutWork work;
  bool isCancelled = false;
  QObject::connect(&work.document, &Document::exportCancelled, [&] { isCancelled = true; });
  QObject::connect(&work.document, &Document::exportPolishes, [&] { work.document.cancelExport(); });
  const QString path = work.torus.file("none.stl");
  work.document.exportResult(path, CoordinateSpace::lps);
  work.document.cancelExport();
  REQUIRE(waitFor([&] { return isCancelled || !work.written.isEmpty(); }));
  CHECK(isCancelled);
  CHECK_FALSE(QFile::exists(path));
}
