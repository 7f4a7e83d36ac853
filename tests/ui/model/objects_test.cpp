// Several objects in one Document: walls for one another, files, sessions and the journal.

#include <functional>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/collision/body_contact.h"
#include "core/io/report/session.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

TEST_CASE("a seed in what an earlier object encloses is refused with its name", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  document.addSeed(work.torus.seed);
  REQUIRE(runToEnd(document));
  rename(document, 0, "Ring");
  document.addObject();
  document.addSeed(work.opposite());
  REQUIRE(waitFor([&] { return !document.resolveError().isEmpty(); }));
  CHECK(document.resolveError().contains(QLatin1String("Ring")));
}

TEST_CASE("a finished object is a wall for the next, and the command line makes the same of the session",
          "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst();
  work.growSecond();
  rename(document, 1, "Rest");
  const TriangleSoup first = document.objectInfo(0).snapshot->mesh, second = document.snapshot()->mesh;
  CHECK(bodyContact(first, second) == BodyContact::none);
  CHECK(document.snapshot()->certificate.passes());
  CHECK(document.objectInfo(1).madeWithEarlier.isEmpty());
  CHECK(document.notReplayed().isEmpty());

  const QString session = work.torus.file("session.json"), all = work.torus.file("all.stl"),
                label = work.torus.file("all.seg.nrrd"), one = work.torus.file("rest.nrrd");
  REQUIRE(work.save(session));
  REQUIRE(work.exportAll(all));
  REQUIRE(work.exportAll(label));
  const QString again = work.torus.file("again.stl"), labelAgain = work.torus.file("again.seg.nrrd");
  REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again, QStringLiteral("-o"),
                  labelAgain, QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(all).size() > 10'000);
  CHECK(bytesOf(again) == bytesOf(all));
  CHECK(bytesOf(labelAgain) == bytesOf(label));

  SECTION("no voxel has two labels") {
    REQUIRE(work.exportAll(work.torus.file("all.nrrd")));
    const auto both = voxelsOf(work.torus.file("all.nrrd"));
    REQUIRE(both.size() == 2);
    REQUIRE(work.exportActive(one));
    CHECK(voxelsOf(one) == std::map<int, int>{{2, both.at(2)}});
    document.setActiveObject(0);
    REQUIRE(work.exportActive(one));
    CHECK(voxelsOf(one) == std::map<int, int>{{1, both.at(1)}});
  }
  SECTION("the session comes back in the window as it was") {
    document.setObjectVisible(0, false);
    document.setObjectLocked(1, true);
    REQUIRE(work.save(session));
    Document other;
    other.open(session);
    REQUIRE(waitFor([&] { return other.objectCount() == 2 && areAllAtRest(other); }));
    CHECK(namesOf(other) == "Object,Rest");
    CHECK(isSame(other.objectInfo(0).snapshot->mesh, first));
    CHECK(isSame(other.objectInfo(1).snapshot->mesh, second));
    CHECK(other.activeObject() == 1);
    CHECK_FALSE(other.objectInfo(0).visible);
    CHECK(other.objectInfo(1).locked);
    CHECK(other.objectInfo(1).label == document.objectInfo(1).label);
    CHECK(other.objectInfo(1).madeWithEarlier.isEmpty());
    CHECK_FALSE(other.isModified());
  }
  SECTION("the report tells of both, and is a session") {
    const QString report = work.torus.file("report.json");
    work.written.clear();
    document.exportReport(report);
    REQUIRE(work.isWritten(report));
    const QJsonObject told = QJsonDocument::fromJson(bytesOf(report)).object();
    const auto objects = told[QLatin1String("objects")].toArray();
    REQUIRE(objects.size() == 2);
    CHECK(objects[1].toObject()[QLatin1String("name")].toString() == QLatin1String("Rest"));
    REQUIRE(told[QLatin1String("distances")].toArray().size() == 1);
    const QJsonObject gap = told[QLatin1String("distances")].toArray()[0].toObject();
    CHECK(gap[QLatin1String("to")].toString() == QLatin1String("Rest"));
    CHECK(gap[QLatin1String("distance_mm")].toDouble() > 0);
    REQUIRE(runCli({QStringLiteral("replay"), report, QStringLiteral("-o"), again,
                    QStringLiteral("--quiet")}) == 0);
    CHECK(bytesOf(again) == bytesOf(all));
  }
  SECTION("an object without a seed stays in the session, and a replay leaves it out") {
    document.addObject();
    REQUIRE(work.save(session));
    REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again,
                    QStringLiteral("--quiet")}) == 0);
    CHECK(bytesOf(again) == bytesOf(all));
    Document other;
    other.open(session);
    REQUIRE(waitFor([&] { return other.objectCount() == 3; }));
    CHECK(nameOf(other, 2) == "Object 3");
  }
}

TEST_CASE("a correction and another parameter on the way keep the walls, here and in a replay", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst();
  document.addObject();
  document.addSeed(work.opposite());
  document.addSeed({testing::kMiddle + Vec3(0, 0, 15), std::nullopt, true});
  REQUIRE(work.stepTo(10));
  Parameters p = document.parameters();
  p.curvature = 0.35;
  document.setParameters(p, QStringLiteral("Change curvature"));
  REQUIRE(work.stepTo(20));
  document.moveSeed(1, testing::kMiddle);
  REQUIRE(runToEnd(document));
  CHECK(bodyContact(document.objectInfo(0).snapshot->mesh, document.snapshot()->mesh) == BodyContact::none);
  const QString session = work.torus.file("session.json"), all = work.torus.file("all.stl");
  REQUIRE(work.save(session));
  REQUIRE(work.exportAll(all));
  const std::vector<Session> saved = readSessions(session.toStdString());
  REQUIRE(saved.size() == 2);
  CHECK(saved[1].changes.size() == 2);
  const QString again = work.torus.file("again.stl");
  REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again,
                  QStringLiteral("--quiet")}) == 0);
  CHECK(bytesOf(again) == bytesOf(all));
  Document other;
  other.open(session);
  REQUIRE(waitFor([&] { return other.objectCount() == 2 && areAllAtRest(other); }));
  CHECK(isSame(other.objectInfo(1).snapshot->mesh, document.snapshot()->mesh));
}

TEST_CASE("all objects are not written while one of them grows, and it says which", "[objects]") {
  ObjectsWork work;
  Document& document = work.document;
  work.growFirst(5);
  document.addObject();
  rename(document, 1, "Rest");
  document.addSeed(work.opposite());
  document.run();
  REQUIRE(waitFor([&] { return document.iteration() >= 1; }));
  document.setActiveObject(0);
  REQUIRE(document.objectInfo(1).state == GrowthState::running);
  const QString path = work.torus.file("all.stl"), report = work.torus.file("report.json");
  const auto isRefused = [&](const std::function<void()>& writes) {
    work.failed.clear();
    writes();
    return work.failed.contains("“Rest” still grows");
  };
  CHECK(isRefused([&] { document.exportObjects(path, CoordinateSpace::lps); }));
  CHECK(isRefused([&] { document.exportEachObject(path, ".stl", CoordinateSpace::lps); }));
  CHECK(isRefused([&] { document.exportReport(report); }));
  CHECK(work.exportActive(path));  // it is at rest
  REQUIRE(waitFor([&] { return document.objectInfo(1).state == GrowthState::finished; }, 120));
  CHECK(document.allFault().isEmpty());
  CHECK(work.exportAll(path));
}

// Run by the test below in a process of its own, which is then killed.
TEST_CASE("works on two objects until it is killed", "[.child]") {
  Document document;
  REQUIRE(openAndWait(document, qEnvironmentVariable("HANDLEBODY_TEST_VOLUME")));
  document.addSeed({testing::kMiddle + Vec3(testing::kTorusR, 0, 0), 3.0});
  for (int i = 1; i <= 8; ++i) {
    document.stepForward();
    REQUIRE(waitFor([&] { return document.iteration() == i && isAtRest(document); }));
  }
  document.addObject();
  rename(document, 1, "Rest");
  document.addSeed({testing::kMiddle - Vec3(testing::kTorusR, 0, 0), 3.0});
  document.stepForward();
  REQUIRE(waitFor([&] { return document.iteration() == 1 && isAtRest(document); }));
  document.addObject();
  waitMilliseconds(300);
  std::puts("ready");
  std::fflush(stdout);
  waitMilliseconds(60'000);
}

TEST_CASE("the journal of a killed program holds all objects", "[objects]") {
  const TorusFile torus;
  const QStringList orphans = killedAtWork(torus, QStringLiteral("works on two objects until it is killed"));
  REQUIRE(orphans.size() == 1);
  Document document;
  REQUIRE(openAndWait(document, orphans[0]));
  Document::discardRecoverable(orphans[0]);
  CHECK(namesOf(document) == "Object,Rest,Object 3");
  CHECK(document.activeObject() == 2);
  CHECK(waitFor([&] {
    return document.objectInfo(0).snapshot && document.objectInfo(0).snapshot->iteration == 8 &&
           document.objectInfo(1).snapshot && document.objectInfo(1).snapshot->iteration == 1;
  }));
  CHECK(document.objectInfo(1).madeWithEarlier.isEmpty());
  CHECK(document.isModified());
}
