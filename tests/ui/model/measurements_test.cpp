// Rulers and angles of the open work: undone, saved, read again; measures of surfaces and references.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <numbers>

#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/report/compared_table.h"
#include "core/mesh/shapes.h"
#include "tests/ui/model/output_support.h"
#include "ui/model/comparing.h"
#include "ui/model/measurements.h"
#include "ui/model/measuring.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

const Measurement kRuler{MeasurementKind::ruler, {Vec3(1.5, 2.25, 3), Vec3(4.5, 6.25, 3)}};
const Measurement kAngle{MeasurementKind::angle, {Vec3(5, 0, 0), Vec3(0, 0, 0), Vec3(0, 7, 0)}};

QJsonObject jsonOf(const QString& path) { return QJsonDocument::fromJson(bytesOf(path)).object(); }

//! A ball as an object that is grown.
MeasuredSurface ballSurface(const char* name, const Vec3& centre, double radius) {
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->mesh = icosphere(centre, radius, radius / 12);
  return {QString::fromLatin1(name), std::make_shared<const FinishedMesh>(snapshot)};
}

Volume constantVolume(double value) {
  return testing::volumeByIndex(testing::cubicGrid(41), [value](int, int, int) { return value; });
}

//! That have this value; of 1 mm³ each.
int voxelsOf(const Volume& labels, int value) {
  int count = 0;
  visitVoxels(labels, [&](const auto* voxels) {
    for (std::size_t i = 0; i < labels.grid.voxelCount(); ++i) count += static_cast<int>(voxels[i]) == value;
  });
  return count;
}

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("rulers and angles are undone and redone, and a drag is one change", "[document][measurements]") {
  OutputWork work;
  Measurements& list = work.document.measurements();
  list.add(kRuler);
  list.add(kAngle);
  CHECK(list.nameOf(0) == "Ruler 1");
  CHECK(list.nameOf(1) == "Angle 2");
  CHECK(measuredValue(list.all()[0]) == "5.00 mm");
  CHECK(measuredValue(list.all()[1]) == "90.0°");
  const Measurement fine{MeasurementKind::ruler, {{0, 0, 0}, {0.0234, 0, 0}}};
  CHECK(measuredValue(fine, 5) == "0.02340 mm");  // as fine as the voxels ask for
  for (int i = 1; i <= 5; ++i) list.movePoint(0, 1, Vec3(i, 0, 0), 7);
  CHECK(work.document.isModified());
  work.document.undoStack()->undo();
  CHECK(list.all() == std::vector{kRuler, kAngle});
  list.remove(0);
  CHECK(list.all() == std::vector{kAngle});
  work.document.undoStack()->undo();
  CHECK(list.all() == std::vector{kRuler, kAngle});
  work.document.undoStack()->undo();
  work.document.undoStack()->undo();
  CHECK(list.all().empty());
  work.document.undoStack()->redo();
  CHECK(list.all() == std::vector{kRuler});
}

TEST_CASE("a session and the report keep rulers and angles; without any they are as before",
          "[document][measurements]") {
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.stepTo(2));
  const QString session = work.torus.file("s.json"), report = work.torus.file("r.json");
  work.document.saveSession(session);
  REQUIRE(work.isWritten(session));
  CHECK_FALSE(jsonOf(session).contains("measurements"));
  work.document.measurements().add(kRuler);
  work.document.measurements().add(kAngle);
  work.written.clear();
  work.document.saveSession(session);
  REQUIRE(work.isWritten(session));
  CHECK_FALSE(work.document.isModified());
  work.document.exportReport(report);
  REQUIRE(work.isWritten(report));
  for (const QString& path : {session, report}) {
    const QJsonArray list = jsonOf(path)["measurements"].toArray();
    REQUIRE(list.size() == 2);
    CHECK(list[0].toObject()["length_mm"].toDouble() == 5);
    CHECK(list[1].toObject()["angle_degrees"].toDouble() == Approx(90));
    Document again;
    REQUIRE(openAndWait(again, path));
    CHECK(again.measurements().all() == std::vector{kRuler, kAngle});
  }
  // Opening a volume alone leaves none of the work before.
  REQUIRE(openAndWait(work.document, work.torus.path));
  CHECK(work.document.measurements().all().empty());
}

TEST_CASE("a session whose measurements make no sense is refused with a sentence",
          "[document][measurements]") {
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  const QString session = work.torus.file("s.json");
  work.document.measurements().add(kRuler);
  work.document.saveSession(session);
  REQUIRE(work.isWritten(session));
  const QByteArray good = bytesOf(session);
  for (const auto& [from, to] : {std::pair{"\"ruler\"", "\"rope\""},
                                 {"\"ruler\"", "\"angle\""},
                                 {"2.25", "\"x\""},
                                 {"\"points\"", "\"dots\""}}) {
    QByteArray bad = good;
    REQUIRE(bad.contains(from));
    bad.replace(from, to);
    QFile file(session);
    REQUIRE(file.open(QIODevice::WriteOnly));
    file.write(bad);
    file.close();
    CHECK_FALSE(openAndWait(work.document, session));
  }
}

TEST_CASE("the report holds the measures of the surface that is written", "[document][measurements]") {
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.stepTo(6));
  const QString report = work.torus.file("r.json");
  work.document.exportReport(report);
  REQUIRE(work.isWritten(report));
  const QJsonObject json = jsonOf(report);
  CHECK(json["measures"].toObject()["volume_mm3"].toDouble() ==
        Approx(json["mesh"].toObject()["volume_mm3"].toDouble()));
  CHECK(json["measures"].toObject()["intensity"].toObject()["voxels"].toInt() > 10);
}

TEST_CASE("a report without what names the patient says neither path nor view", "[document][measurements]") {
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.stepTo(2));
  const QString report = work.torus.file("r.json");
  work.document.exportReport(report, true);
  REQUIRE(work.isWritten(report));
  CHECK_FALSE(bytesOf(report).contains("torus"));
}

TEST_CASE("balls are measured, with their distance and the wall between them", "[measurements]") {
  const Vec3 left(12, 20, 20), right(30, 20, 20);
  MeasureQuestion question;
  question.surfaces = {ballSurface("Left", left, 7), ballSurface("Right", right, 5)};
  question.volume = constantVolume(42);
  question.wall = WantedWall{0, 1};
  std::vector<double> progress;
  const Measured m = measureAll(question, [&](double part) { progress.push_back(part); });
  REQUIRE(m.objects.size() == 2);
  CHECK(m.objects[0].name == "Left");
  CHECK(m.objects[0].measures.shape.volume == Approx(4 * kPi / 3 * 343).epsilon(0.01));
  CHECK(m.objects[1].measures.shape.largest.distance == Approx(10).epsilon(0.01));
  CHECK((m.objects[0].measures.shape.centroid - left).norm() < 0.01);
  CHECK(m.objects[0].measures.intensity->mean == 42);
  REQUIRE(m.gaps.size() == 1);
  CHECK(m.gaps[0].gap.distance == Approx(6).epsilon(0.01));
  REQUIRE(m.wall);
  CHECK(m.wall->wall.fromFirst.smallest == Approx(6).epsilon(0.01));
  CHECK(std::is_sorted(progress.begin(), progress.end()));
  CHECK(progress.back() == 1);
  // A ball has no cavity: that is said, and all else is there.
  question.wall = WantedWall{1, std::nullopt};
  const Measured other = measureAll(question, [](double) {});
  CHECK_FALSE(other.wall);
  REQUIRE(other.warnings.size() == 1);
  CHECK(other.warnings[0].kind == FindingKind::noCavity);
  CHECK(sentence(other.warnings[0]) == "“Right” has no cavity, and so no wall around one.");
}

TEST_CASE("a centre line is looked for in the object that holds its first place", "[measurements]") {
  LineQuestion question;
  question.surfaces = {ballSurface("Left", Vec3(12, 20, 20), 7), ballSurface("Right", Vec3(30, 20, 20), 5)};
  question.from = Vec3(30, 20, 16);
  question.to = Vec3(30, 20, 20);
  const LineAnswer none = lineOf({question.surfaces, Vec3(0, 0, 0), question.to});
  CHECK_FALSE(none.line);
  CHECK_FALSE(none.error.isEmpty());
  const LineAnswer away = lineOf({question.surfaces, question.from, Vec3(0, 0, 0)});
  CHECK_FALSE(away.line);
  CHECK(away.error.contains("Right"));
}

TEST_CASE("what is measured no more is not answered", "[measurements]") {
  Measurer measurer;
  MeasureQuestion question;
  question.surfaces = {ballSurface("Left", Vec3(12, 20, 20), 7), ballSurface("Right", Vec3(30, 20, 20), 5)};
  question.volume = constantVolume(42);
  std::atomic<int> answers{0}, last{0};
  for (int i = 1; i <= 5; ++i)
    measurer.measure(
        question, [](double) {},
        [&, i](const MeasureAnswer&) {
          ++answers;
          last = i;
        });
  REQUIRE(waitFor([&] { return answers > 0; }));
  waitMilliseconds(200);
  CHECK(last == 5);
  const int before = answers;
  measurer.measure(
      question, [](double) {}, [&](const MeasureAnswer&) { ++answers; });
  measurer.cancel();
  waitMilliseconds(500);
  CHECK(answers == before);
}

TEST_CASE("a ball against a larger one about the same centre lies inside by the difference of their radii",
          "[measurements]") {
  const QTemporaryDir folder;
  const Vec3 centre(20, 20, 20);
  const QString reference = folder.filePath("larger.ply");
  writeMesh(icosphere(centre, 9, 0.7), reference.toStdString());
  const CompareAnswer answer = compareWith({ballSurface("Ball", centre, 7), reference});
  REQUIRE(answer.pair);
  CHECK(answer.isSigned);
  CHECK(*answer.pair->found.dice == Approx(2 * 343.0 / (343 + 729)).epsilon(0.01));
  CHECK(answer.pair->found.distances->percentile95() == Approx(2).epsilon(0.02));
  for (const double d : answer.distances) CHECK(std::abs(d + 2) < 0.05);
  CHECK_THROWS(compareWith({ballSurface("Ball", centre, 7), folder.filePath("none.ply")}));
}

TEST_CASE("of a label map as reference the labels are told by number and name, and one of them is compared",
          "[measurements]") {
  const QTemporaryDir folder;
  const Vec3 left(12, 20, 20), right(30, 20, 20);
  const std::vector<ExportedObject> meant{
      {{"Left kidney", {17, 200, 33}, 1, "kidney"}, icosphere(left, 7, 0.7)},
      {{"Cyst \u00e9", {200, 17, 33}, 2, "tissue"}, icosphere(right, 5, 0.7)}};
  const Volume labels = labelMap(meant, testing::cubicGrid(41));
  const QString path = folder.filePath(GENERATE("two.seg.nrrd", "two.seg.dcm", "two.nii.gz"));
  DicomOrigin origin;
  origin.straight = false;  // no series stands behind it
  const bool isNamed = !path.endsWith(QLatin1String(".nii.gz"));
  if (path.endsWith(QLatin1String(".dcm")))
    writeDicomSegmentation(labels, meant, origin, {}, path.toStdString());
  else if (isNamed)
    writeSlicerSegmentation(labels, meant, path.toStdString());
  else
    writeVolume(labels, path.toStdString());

  CompareQuestion question{ballSurface("Ball", right, 5), path};
  ReferenceLabels told;
  const CompareAnswer all = compareWith(question, [&](ReferenceLabels l) { told = std::move(l); });
  CHECK(told.error.isEmpty());
  REQUIRE(told.all.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(told.all[i].value == meant[i].label.value);
    CHECK(told.all[i].name == (isNamed ? meant[i].label.name : std::string()));
  }
  CHECK(all.pair->b.solid.volume() == voxelsOf(labels, 1) + voxelsOf(labels, 2));
  question.label = 2;
  const CompareAnswer one = compareWith(question);
  CHECK(one.pair->b.label == 2);
  CHECK(one.pair->b.solid.volume() == voxelsOf(labels, 2));
  CHECK(*one.pair->found.dice > 0.9);
  CHECK(*all.pair->found.dice < 0.6);
}

TEST_CASE("a label map with too many labels is compared as a whole, and why none is listed is told",
          "[measurements]") {
  const QTemporaryDir folder;
  const QString path = folder.filePath("many.nii.gz");
  const Vec3 centre(20, 20, 20);
  const auto label = [&](int i, int j, int k) {
    return (Vec3(i, j, k) - centre).norm() < 7 ? 1 + (i + 41 * (j + 41 * k)) % 1000 : 0;
  };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41), label), path.toStdString());
  ReferenceLabels told;
  const CompareAnswer answer =
      compareWith({ballSurface("Ball", centre, 7), path}, [&](ReferenceLabels l) { told = std::move(l); });
  CHECK(told.all.empty());
  CHECK(told.error.contains(QLatin1String("many.nii.gz")));
  REQUIRE(answer.pair);
  CHECK(*answer.pair->found.dice > 0.9);
}

TEST_CASE("an object as reference is compared as its mesh in a file is", "[measurements]") {
  const QTemporaryDir folder;
  const Vec3 centre(20, 20, 20), aside(22, 21, 20);
  const MeasuredSurface other = ballSurface("Other", aside, 8);
  const QString file = folder.filePath("other.vtp");
  writeMesh(other.mesh->get().mesh, file.toStdString());
  CompareQuestion question{ballSurface("Ball", centre, 7), file};
  const CompareAnswer asFile = compareWith(question);
  question.path.clear();
  question.object = other;
  CompareAnswer asObject = compareWith(question, [](const ReferenceLabels&) { FAIL("it has no labels"); });
  CHECK(asObject.pair->b.path == "Other");
  CHECK(asObject.distances == asFile.distances);
  auto renamed = *asObject.pair;
  renamed.b.path = asFile.pair->b.path;
  CHECK(comparisonJson(renamed) == comparisonJson(*asFile.pair));
}

TEST_CASE("distances are written as the command line writes them", "[measurements]") {
  const QTemporaryDir folder;
  const MeasuredSurface ball = ballSurface("Ball", Vec3(20, 20, 20), 7);
  TriangleSoup reference = icosphere(Vec3(22, 21, 20), 8, 0.7);
  if (GENERATE(false, true)) reference.triangles.pop_back();  // it has no inside then
  const QString a = folder.filePath("a.ply"), b = folder.filePath("b.ply"),
                mine = folder.filePath("mine.vtp"), told = folder.filePath("told.vtp");
  writeMesh(ball.mesh->get().mesh, a.toStdString());
  writeMesh(reference, b.toStdString());
  const CompareAnswer answer = compareWith({ball, b});
  writeDistances(*answer.pair, answer.distances, mine.toStdString());
  REQUIRE(QProcess::execute(HANDLEBODY_CLI, {"compare", a, b, "-o", told}) == 0);
  CHECK(!bytesOf(mine).isEmpty());
  CHECK(bytesOf(mine) == bytesOf(told));
}

TEST_CASE("an export that is cancelled before it begins leaves nothing and is told",
          "[document][measurements]") {
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.stepTo(6));
  QStringList cancelled, begun;
  QObject::connect(&work.document, &Document::exportCancelled, [&](const QString& p) { cancelled << p; });
  QObject::connect(&work.document, &Document::exporting, [&](const QString& p) { begun << p; });
  const QString path = work.torus.file("gone.nii.gz");
  work.document.exportResult(path, CoordinateSpace::lps);
  work.document.cancelExport();
  REQUIRE(waitFor([&] { return !cancelled.isEmpty() || work.written.contains(path); }));
  CHECK(begun == QStringList{path});
  CHECK(QFile::exists(path) == cancelled.isEmpty());
  CHECK(work.failed.isEmpty());
}

TEST_CASE("to cancel cancels every export that is under way, not the newest alone",
          "[document][measurements]") {
  constexpr int kFiles = 8;
  OutputWork work;
  work.document.addSeed(work.torus.seed);
  REQUIRE(work.stepTo(6));
  QStringList paths, cancelled;
  QObject::connect(&work.document, &Document::exportCancelled, [&](const QString& p) { cancelled << p; });
  for (int i = 0; i < kFiles; ++i)
    paths << work.torus.folder.filePath(QStringLiteral("gone%1.nii.gz").arg(i));
  for (const QString& path : paths) work.document.exportResult(path, CoordinateSpace::lps);
  work.document.cancelExport();
  REQUIRE(waitFor([&] { return cancelled.size() + work.written.size() == kFiles; }));
  CHECK(work.failed.isEmpty());
  CHECK(cancelled.size() > 1);  // the first may have been written already
  for (const QString& path : paths) CHECK(QFile::exists(path) != cancelled.contains(path));
  const QString later = work.torus.file("later.nii.gz");
  work.document.exportResult(later, CoordinateSpace::lps);
  CHECK(work.isWritten(later));
}

TEST_CASE("a format that cannot be made of the volume is told with its reason", "[document][measurements]") {
  OutputWork work;
  for (const char* ending : {".stl", ".nii.gz", ".seg.nrrd", ".3mf"})
    CHECK(work.document.exportFault(QString::fromLatin1(ending)).isEmpty());
  for (const char* ending : {".seg.dcm", ".stl.dcm"}) {
    const QString why = work.document.exportFault(QString::fromLatin1(ending));
    CHECK(why.contains("DICOM"));
    CHECK(why.front().isUpper());
    CHECK_FALSE(why.contains(".dcm"));
  }
}
