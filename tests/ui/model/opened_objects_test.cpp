// Meshes and label maps as objects of a Document.

#include "core/collision/body_contact.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/report/session.h"
#include "core/mesh/shapes.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct OpeningWork : ObjectsWork {
  QStringList opened;
  QString openingFailed;
  bool wasCancelled = false;

  OpeningWork() {
    QObject::connect(&document, &Document::objectsOpened,
                     [this](const QString&, const QStringList& names) { opened = names; });
    QObject::connect(&document, &Document::openingObjectsFailed,
                     [this](const QString& sentence) { openingFailed = sentence; });
    QObject::connect(&document, &Document::openingObjectsCancelled, [this] { wasCancelled = true; });
  }
  bool open(const QString& path, OpenAs as) {
    opened.clear();
    openingFailed.clear();
    document.openObjects(path, as);
    return waitFor([&] { return !opened.isEmpty() || !openingFailed.isEmpty() || wasCancelled; }) &&
           !opened.isEmpty();
  }
  bool isShown(int index) const {
    const auto shown = document.objectInfo(index).snapshot;
    return shown && !shown->mesh.triangles.empty();
  }
  //! A ball in the torus, on the other side of it than its seed.
  QString ball(double radius = 3) const {
    const QString path = torus.file("ball.stl");
    writeMesh(icosphere(opposite().centre, radius, 1.0), path.toStdString());
    return path;
  }
};

}  // namespace

TEST_CASE("a mesh that is opened as done is shown, locked, and a wall for what grows", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  REQUIRE(work.open(work.ball(), OpenAs::done));
  CHECK(work.opened == QStringList{QStringLiteral("ball")});
  REQUIRE(document.objectCount() == 2);
  CHECK(nameOf(document, 0) == "ball");
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  CHECK(document.objectInfo(0).locked);
  CHECK(document.objectInfo(0).state == GrowthState::finished);
  CHECK(document.activeObject() == 1);
  document.addSeed(work.torus.seed);
  REQUIRE(runToEnd(document));
  const TriangleSoup ball = document.objectInfo(0).snapshot->mesh, grown = document.snapshot()->mesh;
  CHECK(bodyContact(ball, grown) == BodyContact::none);

  SECTION("the session holds it, and the command line makes the same files of it") {
    const QString session = work.torus.file("s.json"), all = work.torus.file("all.stl"),
                  again = work.torus.file("again.stl");
    REQUIRE(work.save(session));
    REQUIRE(work.exportAll(all));
    REQUIRE(runCli({QStringLiteral("replay"), session, QStringLiteral("-o"), again,
                    QStringLiteral("--quiet")}) == 0);
    CHECK(bytesOf(again) == bytesOf(all));
    Document other;
    REQUIRE(openAndWait(other, session));
    REQUIRE(waitFor([&] { return other.objectInfo(1).state == GrowthState::finished; }, 120));
    CHECK(isSame(other.objectInfo(0).snapshot->mesh, ball));
    CHECK(isSame(other.objectInfo(1).snapshot->mesh, grown));
    CHECK(other.objectInfo(0).locked);
  }
}

TEST_CASE("an object that is called after its file is not called so in what is not to name the patient",
          "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  REQUIRE(work.open(work.ball(), OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  const auto exported = [&](bool isAnonymous) {
    const QString path = work.torus.file("all.gltf");
    work.written.clear();
    document.exportObjects(path, CoordinateSpace::lps, {{}, {}, isAnonymous});
    REQUIRE(work.isWritten(path));
    return bytesOf(path);
  };
  CHECK(exported(false).contains("\"ball\""));
  CHECK_FALSE(exported(true).contains("\"ball\""));
  CHECK(exported(true).contains("\"Object 1\""));
  const QString report = work.torus.file("r.json");
  document.exportReport(report, true);
  REQUIRE(work.isWritten(report));
  CHECK(bytesOf(report).contains("\"Object 1\""));
  CHECK_FALSE(bytesOf(report).contains("\"ball\""));
  rename(document, 0, "Lesion");
  CHECK(exported(true).contains("\"Lesion\""));
  CHECK(nameOf(document, 0) == "Lesion");
}

TEST_CASE("opening objects is one entry of the undo list", "[objects][opened]") {
  OpeningWork work;
  REQUIRE(work.open(work.ball(), OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  work.document.undoStack()->undo();
  CHECK(work.document.objectCount() == 1);
  work.document.undoStack()->redo();
  REQUIRE(work.document.objectCount() == 2);
  CHECK(work.isShown(0));
}

TEST_CASE("a mesh that is opened to grow from grows onto the image", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  document.addSeed(work.torus.seed);
  REQUIRE(runToEnd(document));
  const double meant = document.snapshot()->certificate.volume;
  document.undoStack()->undo();
  REQUIRE(work.open(work.ball(), OpenAs::start));
  CHECK(document.activeObject() == 1);
  REQUIRE(waitFor([&] { return work.isShown(1) && isAtRest(document); }));
  CHECK(document.iteration() == 0);
  REQUIRE(runToEnd(document));
  CHECK(document.snapshot()->certificate.volume == Approx(meant).epsilon(0.02));
  CHECK(document.snapshot()->certificate.genus == std::vector<int>{1});
}

TEST_CASE("the labels of a map become objects with names and values of their own", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  work.growFirst();
  work.growSecond();
  rename(document, 1, "Rest");
  const QString both = work.torus.file("both.seg.nrrd");
  REQUIRE(work.exportAll(both));
  OpeningWork other;
  REQUIRE(other.open(both, OpenAs::done));
  CHECK(other.opened.size() == 2);
  CHECK(other.opened.contains(QStringLiteral("Rest")));
  REQUIRE(other.document.objectCount() == 3);
  REQUIRE(waitFor([&] { return other.isShown(0) && other.isShown(1); }));
  CHECK(bodyContact(other.document.objectInfo(0).snapshot->mesh,
                    other.document.objectInfo(1).snapshot->mesh) == BodyContact::none);
  CHECK(other.document.objectInfo(0).label.value != other.document.objectInfo(1).label.value);
}

TEST_CASE("the segments of a file become objects with the names, colours and terms that it has for them",
          "[objects][opened]") {
  OpeningWork work;
  const Vec3 aside(9, 0, 0);
  // The second is as one that nobody has named or coloured.
  const std::vector<ExportedObject> meant{
      {{"Left kidney", {17, 200, 33}, 3, "kidney"}, icosphere(testing::kMiddle + aside, 4, 1.0)},
      {{"Cyst \u00e9", ObjectLabel{}.colour, 7, "tissue"}, icosphere(testing::kMiddle - aside, 3, 1.0)}};
  const Volume labels = labelMap(meant, work.document.volume().grid);
  const QString path = work.torus.file(GENERATE("all.seg.nrrd", "all.seg.dcm"));
  DicomOrigin origin;
  origin.straight = false;  // no series stands behind it
  if (path.endsWith(QLatin1String(".dcm")))
    writeDicomSegmentation(labels, meant, origin, {}, path.toStdString());
  else
    writeSlicerSegmentation(labels, meant, path.toStdString());
  REQUIRE(work.open(path, OpenAs::done));
  REQUIRE(work.document.objectCount() == 3);
  for (int i = 0; i < 2; ++i) {
    const ObjectLabel is = work.document.objectInfo(i).label, was = meant[i].label;
    CHECK(is.name == was.name);
    CHECK(is.term == was.term);
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(int{is.colour[c]} - int{was.colour[c]}) <= 1);
  }
}

TEST_CASE("an encapsulated STL is opened as any mesh", "[objects][opened]") {
  OpeningWork work;
  const QString path = work.torus.file("ball.stl.dcm");
  writeDicomStl({{{}, icosphere(testing::kMiddle, 4, 1.0)}}, {}, {}, path.toStdString());
  REQUIRE(work.open(path, OpenAs::done));
  CHECK(nameOf(work.document, 0) == "ball");
  REQUIRE(waitFor([&] { return work.isShown(0); }));
}

TEST_CASE("what is no object of this volume is refused in a sentence, and nothing changes",
          "[objects][opened]") {
  OpeningWork work;
  TriangleSoup open = icosphere(testing::kMiddle, 4, 1.0);
  open.triangles.pop_back();
  const QString path = work.torus.file("open.ply"), far = work.torus.file("far.ply");
  writeMesh(open, path.toStdString());
  writeMesh(icosphere(Vec3(500, 0, 0), 4, 1.0), far.toStdString());
  CHECK_FALSE(work.open(path, OpenAs::done));
  CHECK(work.openingFailed.contains(QLatin1String("not closed")));
  CHECK_FALSE(work.open(far, OpenAs::start));
  CHECK(work.openingFailed.contains(QLatin1String("does not belong to this volume")));
  CHECK_FALSE(work.open(work.torus.file("none.stl"), OpenAs::done));
  CHECK(work.document.objectCount() == 1);
  SECTION("and so is what was cancelled") {
    work.document.openObjects(work.ball(), OpenAs::done);
    work.document.cancelOpeningObjects();
    REQUIRE(waitFor([&] { return work.wasCancelled; }));
    CHECK(work.document.objectCount() == 1);
  }
}
