// Meshes and label maps as objects of a Document.

#include "ui/model/opened_objects.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "core/collision/body_contact.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/report/session.h"
#include "core/mesh/shapes.h"
#include "tests/io/overlapping_segments.h"
#include "tests/support/test_volume.h"
#include "tests/ui/model/objects_support.h"
#include "tests/ui/model/time_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

struct OpeningWork : ObjectsWork {
  QStringList opened;
  qint64 shared = 0;
  QString openingFailed;
  bool wasCancelled = false;

  OpeningWork() {
    QObject::connect(&document, &Document::objectsOpened,
                     [this](const QString&, const QStringList& names, qint64 voxels) {
                       opened = names;
                       shared = voxels;
                     });
    QObject::connect(&document, &Document::openingObjectsFailed,
                     [this](const QString& sentence) { openingFailed = sentence; });
    QObject::connect(&document, &Document::openingObjectsCancelled, [this] { wasCancelled = true; });
  }
  bool open(const QString& path, OpenAs as) { return open({path, as}); }
  bool open(const ObjectsToOpen& asked) {
    opened.clear();
    openingFailed.clear();
    document.openObjects(asked);
    return waitFor([&] { return !opened.isEmpty() || !openingFailed.isEmpty() || wasCancelled; }) &&
           !opened.isEmpty();
  }
  bool isShown(int index) const {
    const auto shown = document.objectInfo(index).snapshot;
    return shown && !shown->mesh.triangles.empty();
  }
  //! The mesh and the certificate of the only object that `asked` opens, as done.
  MeshSnapshot only(const ObjectsToOpen& asked) {
    REQUIRE(open(asked));
    REQUIRE(opened.size() == 1);
    REQUIRE(waitFor([&] { return isShown(0); }));
    MeshSnapshot shown = *document.objectInfo(0).snapshot;
    document.undoStack()->undo();
    return shown;
  }
  //! A ball in the torus, on the other side of it than its seed.
  QString ball(double radius = 3) const {
    const QString path = torus.file("ball.stl");
    writeMesh(icosphere(opposite().centre, radius, 1.0), path.toStdString());
    return path;
  }
};

constexpr int kBalls = 1, kRing = 4;

double ringDistance(const Vec3& p) {
  const Vec3 q = p - Vec3(28, 28, 20);
  return std::hypot(std::hypot(q.x(), q.y()) - 6, q.z()) - 2.7;
}

//! Two balls of one label, and a ring of another, in the volume's grid.
QString ballsAndRing(const TorusFile& torus) {
  const QString path = torus.file("labels.nrrd");
  const auto isInBalls = [large = test::inBall({9, 9, 10}, 5), small = test::inBall({9, 9, 26}, 2.5)](
                             const Vec3& p) { return large(p) || small(p); };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41),
                                     [&](int i, int j, int k) {
                                       const Vec3 p(i, j, k);
                                       return isInBalls(p) ? kBalls : ringDistance(p) < 0 ? kRing : 0;
                                     }),
              path.toStdString());
  return path;
}

const auto kBody = test::inBall({14, 20, 20}, 7), kLesion = test::inBall({21, 20, 20}, 4);

//! Segments 1 and 2, the smaller of which reaches into the other one.
QString overlapping(const TorusFile& torus) {
  const QString path = torus.file("overlapping.seg.nrrd");
  test::writeLayers({{"Body", "0 1 0", kBody}, {"Lesion", "1 0 0", kLesion}}, testing::cubicGrid(41),
                    path.toStdString());
  return path;
}

int voxelsOfBoth() {
  int count = 0;
  for (int k = 0; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i) count += kBody(Vec3(i, j, k)) && kLesion(Vec3(i, j, k));
  return count;
}

//! Part of the vertices that lie midway between two voxels that are neighbours.
double midwayPart(const TriangleSoup& mesh) {
  int midway = 0;
  for (const Vec3& p : mesh.points) {
    int whole = 0, half = 0;
    for (int a = 0; a < 3; ++a) {
      whole += std::abs(p[a] - std::round(p[a])) < 1e-5;
      half += std::abs(p[a] - std::floor(p[a]) - 0.5) < 1e-5;
    }
    midway += whole == 2 && half == 1;
  }
  return static_cast<double>(midway) / static_cast<double>(mesh.points.size());
}

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

TEST_CASE("what a label map leaves out of an object is told beside the file", "[objects][opened]") {
  OpeningWork work;
  QString told;
  QObject::connect(&work.document, &Document::leftOutOfLabelMap, [&](const QString& text) { told = text; });
  const QString part = work.torus.file("part.stl");
  writeMesh(icosphere(Vec3(20.5, 20.5, 33.5), 0.3, 0.1), part.toStdString());  // between voxel centres
  REQUIRE(work.open(part, OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  work.document.setActiveObject(0);
  REQUIRE(work.exportActive(work.torus.file("none.nii.gz")));
  CHECK(told.contains(QLatin1String("No voxel with a value has its centre inside")));
  told.clear();
  REQUIRE(work.exportActive(work.torus.file("none.ply")));
  CHECK(told.isEmpty());

  writeMesh(icosphere(Vec3(38, 38, 38), 5, 1), part.toStdString());
  REQUIRE(work.open(part, OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0) && work.isShown(1); }));
  REQUIRE(work.exportAll(work.torus.file("both.seg.nrrd")));
  CHECK(told.contains(QLatin1String("A part of the surface lies outside of the volume")));
  CHECK(told.contains(QString::fromStdString(nameOf(work.document, 0)) + QLatin1Char(':')));
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

TEST_CASE("codes of a file that are not ours stay with its object, and how it was made until it grows",
          "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  const SegmentSource source{
      Terminology{
          {"T-D0050", "SRT", "Tissue"}, {{"T-71000", "SRT", "Kidney"}, {{"G-A101", "SRT", "Left"}}}, {}},
      SegmentAlgorithm{AlgorithmType::automatic, "Net of X"}};
  // The file that is opened has been written here.
  SegmentSource read = source;
  read.algorithm->name = "Net of X, Handlebody";
  const std::vector<ExportedObject> meant{
      {{"One", {17, 200, 33}, 1, "tissue", source}, icosphere(work.opposite().centre, 3, 1.0)}};
  const QString path = work.torus.file("s.seg.dcm"), out = work.torus.file("out.seg.nrrd");
  DicomOrigin origin;
  origin.straight = false;
  writeDicomSegmentation(labelMap(meant, document.volume().grid), meant, origin, {}, path.toStdString());
  const auto written = [&](bool isAnonymous = false) {
    work.written.clear();
    document.exportObjects(out, CoordinateSpace::lps, {{}, {}, isAnonymous});
    REQUIRE(work.isWritten(out));
    return readSlicerLabels(out.toStdString()).begin()->second.source;
  };
  const OpenAs as = GENERATE(OpenAs::done, OpenAs::start);
  REQUIRE(work.open(path, as));
  const int index = as == OpenAs::done ? 0 : 1;
  REQUIRE(waitFor([&] { return work.isShown(index) && (as == OpenAs::done || isAtRest(document)); }));
  CHECK(document.objectInfo(index).label.source == read);
  CHECK(written().terminology == source.terminology);
  CHECK(written().algorithm->name == "Net of X, Handlebody");
  CHECK(written(true).algorithm == SegmentAlgorithm{AlgorithmType::automatic, "Handlebody"});
  if (as == OpenAs::done) {
    const QString session = work.torus.file("s.json");
    REQUIRE(work.save(session));
    Document other;
    REQUIRE(openAndWait(other, session));
    CHECK(other.objectInfo(index).label.source == read);
    document.duplicateObject(index);
    CHECK(document.objectInfo(index + 1).label.source == read);
  } else {
    REQUIRE(runToEnd(document));
    CHECK(written().terminology == source.terminology);
    CHECK_FALSE(written().algorithm);
  }
}

TEST_CASE("what is opened as done is not said to have an edge all around", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  REQUIRE(work.open(work.ball(), OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  document.setActiveObject(0);
  CHECK(document.snapshot()->support.faces.empty());
  const QString report = work.torus.file("report.json"), again = work.torus.file("again.json");
  work.written.clear();
  document.exportReport(report);
  REQUIRE(work.isWritten(report));
  REQUIRE(runCli({QStringLiteral("replay"), report, QStringLiteral("-o"), work.torus.file("again.stl"),
                  QStringLiteral("--report"), again, QStringLiteral("--quiet")}) == 0);
  for (const QString& path : {report, again})
    CHECK(QJsonDocument::fromJson(bytesOf(path)).object()[QLatin1String("unsupported_surface")].isNull());
}

TEST_CASE("an encapsulated STL is opened as any mesh", "[objects][opened]") {
  OpeningWork work;
  const QString path = work.torus.file(GENERATE("ball.stl.dcm", "ball.dcm", "ball"));
  writeDicomStl({{{}, icosphere(testing::kMiddle, 4, 1.0)}}, {}, {}, path.toStdString());
  REQUIRE(work.open(path, OpenAs::done));
  CHECK(nameOf(work.document, 0) == "ball");
  REQUIRE(waitFor([&] { return work.isShown(0); }));
}

TEST_CASE("a 3MF file is opened as any mesh", "[objects][opened]") {
  OpeningWork work;
  const QString path = work.torus.file("ball.3mf");
  writeThreeMf({{{}, icosphere(testing::kMiddle, 4, 1.0)}}, path.toStdString(), CoordinateSpace::ras);
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
    work.document.openObjects({work.ball()});
    work.document.cancelOpeningObjects();
    REQUIRE(waitFor([&] { return work.wasCancelled; }));
    CHECK(work.document.objectCount() == 1);
  }
}

TEST_CASE("of objects in whose place others are opened nothing is told", "[objects][opened]") {
  OpeningWork work;
  QStringList begun;
  QObject::connect(&work.document, &Document::openingObjects, [&](const QString& p) { begun << p; });
  const QString labels = ballsAndRing(work.torus), ball = work.ball();
  work.document.openObjects({labels});
  CHECK(work.open(ball, OpenAs::done));
  CHECK_FALSE(work.wasCancelled);  // it would end what is shown of the second
  CHECK(begun == QStringList{labels, ball});
  CHECK(work.opened.size() == 1);
  CHECK(work.document.objectCount() == 2);
}

TEST_CASE("objects go into the volume that they were opened for, or nowhere", "[objects][opened]") {
  OpeningWork work;
  const QString ball = work.ball();
  const TorusFile other;
  SECTION("not into one that is read meanwhile") {
    work.document.open(other.path);
    CHECK_FALSE(work.open(ball, OpenAs::done));
    CHECK(work.wasCancelled);
    CHECK(work.document.path() == other.path);
    CHECK(work.document.objectCount() == 1);
  }
  SECTION("also if another one cannot be read") {
    work.document.openObjects({ball, OpenAs::done});
    work.document.open(work.torus.file("missing.mha"));
    CHECK(waitFor([&] { return !work.opened.isEmpty() || work.wasCancelled; }));
    CHECK_FALSE(work.wasCancelled);
    CHECK(work.document.objectCount() == 2);
  }
}

TEST_CASE("with work over time no object is opened, nor while a frame is corrected, and it says why",
          "[objects][opened]") {
  const BeatingFile heart;
  Document document;
  REQUIRE(growInFrame(document, heart));
  REQUIRE(carryAll(document));
  REQUIRE(showFrame(document, 3));
  const QString ball = heart.file("ball.stl");
  writeMesh(icosphere(heart.seed, 9, 3.0), ball.toStdString());
  QString failed;
  int begun = 0;
  QObject::connect(&document, &Document::openingObjectsFailed, [&](const QString& why) { failed = why; });
  QObject::connect(&document, &Document::openingObjects, [&] { ++begun; });
  document.openObjects({ball, OpenAs::done});
  CHECK(failed.contains("work over time"));
  document.correctShownFrame();
  REQUIRE(document.correctedFrame() == 3);
  document.openObjects({ball, OpenAs::done});
  CHECK(failed.contains("being corrected"));
  CHECK(begun == 0);
  CHECK(document.objectCount() == 1);
}

TEST_CASE("of a label map only the labels that are chosen become objects", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  const QString path = ballsAndRing(work.torus);
  REQUIRE(work.open({path, OpenAs::done, {kRing}}));
  CHECK(work.opened == QStringList{QStringLiteral("labels 4")});
  REQUIRE(document.objectCount() == 2);
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  CHECK(document.objectInfo(0).label.value == kRing);
  CHECK(document.objectInfo(0).snapshot->certificate.genus == std::vector<int>{1});
  document.undoStack()->undo();
  CHECK(document.objectCount() == 1);
  REQUIRE(work.open({path, OpenAs::start}));
  CHECK(work.opened.size() == 2);
  SECTION("and one that the file does not have is refused") {
    CHECK_FALSE(work.open({path, OpenAs::done, {kBalls, 9}}));
    CHECK(work.openingFailed.contains(QLatin1Char('9')));
    CHECK(document.objectCount() == 3);
  }
}

TEST_CASE("the only label of a map is called after the file", "[objects][opened]") {
  OpeningWork work;
  const QString path = work.torus.file("liver.mha");
  const auto inside = test::inBall({20, 20, 20}, 5);
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41),
                                     [&](int i, int j, int k) { return inside(Vec3(i, j, k)) ? 3 : 0; }),
              path.toStdString());
  REQUIRE(work.open({path, OpenAs::done, {3}}));
  CHECK(work.opened == QStringList{QStringLiteral("liver")});
  CHECK(work.shared == 0);
}

TEST_CASE("labels are opened without smoothing, as their largest part, or with fewer tunnels as is chosen",
          "[objects][opened]") {
  OpeningWork work;
  const QString path = ballsAndRing(work.torus);
  const MeshSnapshot ring = work.only({path, OpenAs::done, {kRing}}),
                     balls = work.only({path, OpenAs::done, {kBalls}});
  REQUIRE(ring.certificate.genus == std::vector<int>{1});
  REQUIRE(balls.certificate.components == 2);
  CHECK(midwayPart(ring.mesh) < 0.5);

  const TriangleSoup steps = work.only({path, OpenAs::done, {kRing}, {.smoothing = 0}}).mesh;
  CHECK(midwayPart(steps) > 0.75);  // the others lie in the middle of cells
  CHECK_FALSE(isSame(steps, ring.mesh));
  CHECK_FALSE(isSame(work.only({path, OpenAs::done, {kRing}, {.smoothing = 2}}).mesh, ring.mesh));

  const Certificate part = work.only({path, OpenAs::done, {kBalls}, {.keepsLargest = true}}).certificate;
  CHECK(part.components == 1);
  CHECK(part.volume > 0.5 * balls.certificate.volume);
  CHECK(work.only({path, OpenAs::done, {kRing}, {.genus = 0}}).certificate.genus == std::vector<int>{0});
}

TEST_CASE("how labels became surfaces is kept by the session", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  REQUIRE(
      work.open({ballsAndRing(work.torus), OpenAs::done, {kBalls}, {.smoothing = 0, .keepsLargest = true}}));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  document.removeObject(1);
  const QString session = work.torus.file("s.json");
  REQUIRE(work.save(session));
  Document other;
  REQUIRE(openAndWait(other, session));
  REQUIRE(waitFor([&] { return other.objectInfo(0).snapshot != nullptr; }));
  CHECK(isSame(other.objectInfo(0).snapshot->mesh, document.objectInfo(0).snapshot->mesh));
}

TEST_CASE("what several segments hold is left to the smallest, and told", "[objects][opened]") {
  OpeningWork work;
  Document& document = work.document;
  const QString path = overlapping(work.torus);
  REQUIRE(work.open({path}));
  CHECK(work.opened == QStringList{QStringLiteral("Body"), QStringLiteral("Lesion")});
  REQUIRE(voxelsOfBoth() > 0);
  CHECK(work.shared == voxelsOfBoth());
  REQUIRE(waitFor([&] { return work.isShown(0) && work.isShown(1); }));
  CHECK(bodyContact(document.objectInfo(0).snapshot->mesh, document.objectInfo(1).snapshot->mesh) ==
        BodyContact::none);
  const QString report = work.torus.file("r.json");
  document.exportReport(report);
  REQUIRE(work.isWritten(report));
  CHECK(bytesOf(report).count("\"given-shares\"") == 1);
  SECTION("one that is opened alone is whole") {
    const double left = document.objectInfo(0).snapshot->certificate.volume;
    document.undoStack()->undo();
    CHECK(work.only({path, OpenAs::done, {1}}).certificate.volume > left + 0.5 * voxelsOfBoth());
    CHECK(work.shared == 0);
  }
}

TEST_CASE("why what was opened has no surface is told once, as soon as it is known", "[objects][opened]") {
  OpeningWork work;
  QStringList told;
  QObject::connect(&work.document, &Document::refused, [&](const QString& sentence) { told << sentence; });
  REQUIRE(work.open(work.ball(), OpenAs::done));
  REQUIRE(waitFor([&] { return work.isShown(0); }));
  CHECK(told.isEmpty());
  const OpenAs as = GENERATE(OpenAs::done, OpenAs::start);
  REQUIRE(work.open(work.ball(2.5), as));
  REQUIRE(waitFor([&] { return !told.isEmpty(); }));
  CHECK(told.front().contains(QLatin1String("meets the object")));
  for (int index = 0; index < work.document.objectCount(); ++index) work.document.setActiveObject(index);
  CHECK(told.size() == 1);
  CHECK(work.isShown(0));
}

TEST_CASE("the labels of a map are listed with what its file says of them", "[objects][opened]") {
  const TorusFile torus;
  const std::atomic<bool> goesOn{false}, cancelled{true};
  const LabelsToOpen segments = labelsToOpen(overlapping(torus), goesOn);
  CHECK(segments.error.isEmpty());
  CHECK(segments.mayOverlap);
  REQUIRE(segments.labels.size() == 2);
  CHECK(segments.labels[0].value == 1);
  CHECK(segments.labels[1].value == 2);
  CHECK(segments.labels[1].name == "Lesion");
  CHECK(segments.labels[1].colour == Colour{255, 0, 0});
  const LabelsToOpen plain = labelsToOpen(ballsAndRing(torus), goesOn);
  CHECK_FALSE(plain.mayOverlap);
  REQUIRE(plain.labels.size() == 2);
  CHECK(plain.labels[1].value == kRing);
  CHECK(labelsToOpen(torus.path, goesOn).error.contains(QLatin1String("whole numbers")));
  const LabelsToOpen unwanted = labelsToOpen(overlapping(torus), cancelled);
  CHECK(unwanted.labels.empty());
  CHECK(unwanted.error.isEmpty());
}
