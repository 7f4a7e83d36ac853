// The panel Measures by mouse and keys: the table of the objects, rulers and angles, a centre line with its
// plot, a reference; and what the step Export says of the formats.

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QProgressBar>
#include <QSpinBox>
#include <QTableWidget>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/volume_io.h"
#include "core/io/report/measured.h"
#include "core/mesh/shapes.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/model/measurements.h"
#include "ui/view/distance_colours.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/measures/centre_line_page.h"
#include "ui/window/measures/compare_page.h"
#include "ui/window/measures/measures_panel.h"
#include "ui/window/measures/object_measures_page.h"
#include "ui/window/measures/rulers_page.h"
#include "ui/window/measures/section_plot.h"
#include "ui/window/measures/sensitivity_page.h"
#include "ui/window/widgets/language.h"
#include "ui/window/widgets/numbers.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;
using ui::MeasuresPanel;

namespace {

constexpr double kRadius = 6;  // of the bar, voxels of 1 mm
const Vec3 kOneEnd(16, 16, 16), kOtherEnd(40, 16, 16);

//! A dark bar with round ends along x.
QString writeBar(const QTemporaryDir& folder) {
  const QString path = folder.filePath("bar.nii.gz");
  Grid grid = testing::cubicGrid(33);
  grid.size[0] = 57;
  const auto intensity = [](int i, int j, int k) {
    const Vec3 p(i, j, k), nearest(std::clamp(p.x(), kOneEnd.x(), kOtherEnd.x()), 16, 16);
    const double distance = (p - nearest).norm() - kRadius;
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 110 + 90 * std::clamp(distance, -1.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  writeVolume(testing::volumeByIndex(grid, intensity), path.toStdString());
  return path;
}

//! A window in which the bar has grown.
std::unique_ptr<ui::MainWindow> grownWindow(const QTemporaryDir& folder) {
  auto window = shownWindow();
  if (!window || !open(*window, writeBar(folder))) return nullptr;
  window->document().addSeed({Vec3(28, 16, 16), {}});
  window->document().run();
  return waitFor(*window, GrowthState::finished) ? std::move(window) : nullptr;
}

bool isMeasured(ui::MainWindow& window) {
  const auto& page = window.measures().objects();
  return QTest::qWaitFor([&] { return page.shown() && !page.isMeasuring(); }, kPatience);
}

QTableWidget* tableNamed(ui::MainWindow& window, const char* name) {
  const auto tables = window.measures().findChildren<QTableWidget*>();
  for (QTableWidget* table : tables)
    if (table->accessibleName() == QLatin1String(name)) return table;
  return nullptr;
}

//! Of one page.
QAbstractButton* buttonOf(QWidget& page, const char* text) {
  const auto buttons = page.findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons)
    if (button->text() == QString::fromUtf8(text)) return button;
  return nullptr;
}

ui::ComparePage& shownComparePage(ui::MainWindow& window) {
  QTest::keyClick(&window, Qt::Key_M, Qt::ControlModifier);
  window.measures().show(MeasuresPanel::Page::compare);
  return window.measures().compare();
}

bool isCompared(const ui::ComparePage& page) {
  return QTest::qWaitFor([&] { return !page.isComparing(); }, kPatience) && page.shown();
}

//! Two balls in the ends of the bar, as a label map by the ending of its name.
QString writeBalls(const QTemporaryDir& folder, const Grid& grid, const char* name) {
  const std::vector<ExportedObject> balls{
      {{"Left internal carotid artery, lumen", {17, 200, 33}, 1, "artery"}, icosphere(kOneEnd, 5, 0.8)},
      {{"Cyst \u00e9", {200, 17, 33}, 2, "tissue"}, icosphere(kOtherEnd, 4, 0.8)}};
  const Volume labels = labelMap(balls, grid);
  const QString path = folder.filePath(QString::fromLatin1(name));
  DicomOrigin origin;
  origin.straight = false;  // no series stands behind it
  if (path.endsWith(QLatin1String(".seg.nrrd")))
    writeSlicerSegmentation(labels, balls, path.toStdString());
  else if (path.endsWith(QLatin1String(".dcm")))
    writeDicomSegmentation(labels, balls, origin, {}, path.toStdString());
  else
    writeVolume(labels, path.toStdString());
  return path;
}

QStringList textsOf(const QComboBox& box) {
  QStringList texts;
  for (int i = 0; i < box.count(); ++i) texts << box.itemText(i);
  return texts;
}

//! A ball beside the bar, which it may not meet, opened as an object that is done.
bool openBall(ui::MainWindow& window, const QString& path) {
  writeMesh(icosphere(Vec3(28, 27.5, 16), 4, 0.8), path.toStdString());
  ui::Document& document = window.document();
  QSignalSpy opened(&document, &ui::Document::objectsOpened);
  document.openObjects({path, ui::OpenAs::done});
  if (opened.isEmpty() && !opened.wait(kPatience)) return false;
  return QTest::qWaitFor([&] { return document.finishedMesh(1) != nullptr; }, kPatience);
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

//! Of every page of the panel. With HANDLEBODY_PICTURES, a folder, pictures of them are left there to be
//! looked at.
QStringList faultsOfPages(ui::MainWindow& window) {
  static int number = 0;
  const QString folder = qEnvironmentVariable("HANDLEBODY_PICTURES");
  QStringList faults;
  for (auto page : {MeasuresPanel::Page::objects, MeasuresPanel::Page::rulers,
                    MeasuresPanel::Page::centreLine, MeasuresPanel::Page::compare}) {
    window.measures().show(page);
    faults << lastingLayoutFaults(window);
    if (!folder.isEmpty()) window.grab().save(QStringLiteral("%1/page%2.png").arg(folder).arg(number++));
  }
  return faults;
}

}  // namespace

class MeasuresTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTableHasTheMeasuresOfTheShownSurface();
  void anotherSurfaceIsMeasuredAnew();
  void measuringIsCancelled();
  void aRulerIsAsFineAsTheVoxels();
  void aRulerIsPlacedByClicksListedAndDeleted();
  void theBrushAndTheRulerDoNotHaveTheMouseBoth();
  void aCentreLineIsPlottedAndPointedAtInTheViews();
  void aCentreLineLeavesTheViewsWithItsSurface();
  void aReferenceIsComparedAndItsDistancesAreInColour();
  void twoPagesDoNotTakeTheColoursOfOneAnotherAway();
  void aLabelOfAReferenceIsChosenByItsName();
  void labelsThatCannotBeListedSayWhy();
  void anotherObjectIsTheReference();
  void distancesAreSavedAsTheCommandLineWritesThem();
  void formatsThatCannotBeMadeSayWhy();
  void nothingIsCutOffInThePanel();
  void nothingIsCutOffInAnyLanguage();
};

void MeasuresTest::theTableHasTheMeasuresOfTheShownSurface() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  QVERIFY(window->measures().objects().isVisible());
  QVERIFY(isMeasured(*window));
  const Measured& m = *window->measures().objects().shown();
  QCOMPARE(m.objects.size(), std::size_t(1));
  const ShapeMeasures& shape = m.objects[0].measures.shape;
  const double volume = window->document().snapshot()->certificate.volume;
  QVERIFY(std::abs(shape.volume - volume) < 1e-5 * volume);
  // Near what it is of, and the length of the bar.
  QVERIFY(std::abs(shape.largest.distance - (24 + 2 * kRadius)) < 1.5);
  QTableWidget* table = tableNamed(*window, "Measures of the objects");
  QVERIFY(table && table->rowCount() == 1);
  QCOMPARE(table->item(0, 1)->text(), ui::number(shape.volume / 1000));
  QVERIFY(table->horizontalHeaderItem(1)->text().contains("(ml)"));
  QVERIFY(shownText(*window, "More about the chosen object").contains("mm"));
  // The writers are the command line's.
  QObject::disconnect(&window->measures(), nullptr, &window->files(),
                      nullptr);  // a dialog would wait for a name
  QSignalSpy saved(&window->measures(), &MeasuresPanel::saveRequested);
  buttonOf(window->measures().objects(), "Save as CSV…")->click();
  QCOMPARE(saved.size(), 1);
  QCOMPARE(saved[0][3].value<std::string>(), measuredCsv(m));
  QVERIFY(window->measures().objects().copyText().contains("volume_mm3\tarea_mm2"));
  QVERIFY(window->measures().objects().json().find("bar.nii.gz") != std::string::npos);
  // Rulers stand in it as they do in what the command line writes of a session.
  QVERIFY(window->measures().objects().csv().find("ruler 1") == std::string::npos);
  window->document().measurements().startWith({{MeasurementKind::ruler, {Vec3(1, 2, 3), Vec3(1, 2, 8)}}});
  QVERIFY(window->measures().objects().csv().find("ruler 1") != std::string::npos);
  window->measures().objects().setAnonymous(true);
  QVERIFY(window->measures().objects().json().find("bar.nii.gz") == std::string::npos);
}

void MeasuresTest::anotherSurfaceIsMeasuredAnew() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  QVERIFY(isMeasured(*window));
  const double before = window->measures().objects().shown()->objects[0].measures.shape.volume;
  window->document().goTo(3);
  const auto hasSmaller = [&] {
    const Measured* m = window->measures().objects().shown();
    return m && m->objects[0].measures.shape.volume < 0.9 * before;
  };
  QVERIFY(QTest::qWaitFor(hasSmaller, kPatience));
}

void MeasuresTest::measuringIsCancelled() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  window->measures().show(MeasuresPanel::Page::objects);
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  auto& page = window->measures().objects();
  QVERIFY(QTest::qWaitFor([&] { return page.isMeasuring() || page.shown(); }, kPatience));
  if (!page.isMeasuring()) buttonOf(page, "Measure")->click();
  QVERIFY(page.isMeasuring());
  buttonOf(page, "Cancel")->click();
  QVERIFY(!page.isMeasuring());
  QTest::qWait(600);
  QVERIFY(!page.isMeasuring());  // not begun again by itself
}

void MeasuresTest::aRulerIsAsFineAsTheVoxels() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("fine.nii.gz");
  Grid grid = testing::cubicGrid(20);
  grid.spacing = Vec3::Constant(0.002);
  writeVolume(testing::volumeByIndex(grid, [](int i, int j, int k) { return i + j + k; }),
              path.toStdString());
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  window->document().measurements().add({MeasurementKind::ruler, {{0, 0, 0}, {0.0061, 0, 0}}});
  window->measures().show(MeasuresPanel::Page::rulers);
  QTableWidget* table = tableNamed(*window, "Rulers and angles");
  QVERIFY(table && table->rowCount() == 1);
  QCOMPARE(table->item(0, 1)->text(), QString("0.0061 mm"));
}

void MeasuresTest::aRulerIsPlacedByClicksListedAndDeleted() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBar(folder)));
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  ui::SliceView& slice = window->views().slice(ui::Plane::axial);
  const Vec3 crosshair = window->viewState().crosshair();
  QTest::keyClick(window.get(), Qt::Key_R);
  QVERIFY(window->viewState().measure().isOn());
  const QPoint from(slice.width() / 2 - 40, slice.height() / 2),
      to(slice.width() / 2 + 30, slice.height() / 2 + 20);
  QTest::mouseClick(&slice, Qt::LeftButton, {}, from);
  QTest::mouseClick(&slice, Qt::LeftButton, {}, to);
  const auto& list = window->document().measurements();
  QCOMPARE(list.all().size(), std::size_t(1));
  QVERIFY(!window->commands()[Command::ruler]->isChecked());
  QVERIFY(window->viewState().crosshair() == crosshair);
  QTableWidget* table = tableNamed(*window, "Rulers and angles");
  QVERIFY(table && table->isVisible() && table->rowCount() == 1);
  QCOMPARE(table->item(0, 1)->text(), ui::measuredValue(list.all()[0]));
  QVERIFY(table->item(0, 1)->text().endsWith(" mm"));
  table->setFocus();
  QTest::keyClick(table, Qt::Key_Delete);
  QVERIFY(list.all().empty());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(list.all().size(), std::size_t(1));
  QCOMPARE(table->rowCount(), 1);
  QTest::keyClick(window.get(), Qt::Key_A);
  for (const QPoint& at : {from, to, QPoint(to.x(), from.y() - 40)})
    QTest::mouseClick(&slice, Qt::LeftButton, {}, at);
  QCOMPARE(table->rowCount(), 2);
  QVERIFY(table->item(1, 1)->text().endsWith("°"));
  QObject::disconnect(&window->measures(), nullptr, &window->files(), nullptr);  // a dialog would wait
  QSignalSpy saved(&window->measures(), &MeasuresPanel::saveRequested);
  for (const char* text : {"Save as CSV…", "Save as JSON…"})
    buttonOf(*window->measures().findChild<ui::RulersPage*>(), text)->click();
  QCOMPARE(saved.size(), 2);
  QCOMPARE(saved[0][3].value<std::string>(), measurementsCsv(list.all()));
  QCOMPARE(saved[1][3].value<std::string>(), measurementsJson(list.all()));
}

void MeasuresTest::theBrushAndTheRulerDoNotHaveTheMouseBoth() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBar(folder)));
  QTest::keyClick(window.get(), Qt::Key_B);
  QVERIFY(window->viewState().brush().isOn());
  QTest::keyClick(window.get(), Qt::Key_R);
  QVERIFY(!window->viewState().brush().isOn() && window->viewState().measure().isOn());
  QTest::keyClick(window.get(), Qt::Key_B);
  QVERIFY(window->viewState().brush().isOn() && !window->viewState().measure().isOn());
}

void MeasuresTest::aCentreLineIsPlottedAndPointedAtInTheViews() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  ui::MeasureTool& tool = window->viewState().measure();
  QTest::keyClick(window.get(), Qt::Key_C);
  QVERIFY(tool.mode() == ui::MeasureTool::Mode::centreLine);
  // By keys: the crosshair's places.
  ui::SliceView& slice = window->views().slice(ui::Plane::axial);
  slice.setFocus();
  for (const Vec3& end : {kOneEnd, kOtherEnd}) {
    window->viewState().setCrosshair(end);
    QTest::keyClick(&slice, Qt::Key_Return);
  }
  auto& page = window->measures().centreLine();
  QVERIFY(page.isVisible());  // the plot comes up by itself
  QVERIFY(QTest::qWaitFor([&] { return page.shown() && !page.isSearching(); }, kPatience));
  const CentreLine& line = page.shown()->line;
  QVERIFY(line.points.size() > 10);
  QVERIFY(std::abs(line.length - 24) < 3);
  const CentreLinePoint& middle = line.points[line.points.size() / 2];
  QVERIFY(std::abs(middle.equivalentDiameter() - 2 * kRadius) < 1);
  QCOMPARE(tool.line().size(), line.points.size());
  QObject::disconnect(&window->measures(), nullptr, &window->files(), nullptr);  // a dialog would wait
  QSignalSpy saved(&window->measures(), &MeasuresPanel::saveRequested);
  for (const char* text : {"Save as CSV…", "Save as JSON…"}) buttonOf(page, text)->click();
  QCOMPARE(saved.size(), 2);
  QCOMPARE(saved[0][3].value<std::string>(), sectionsCsv(line));
  const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(saved[1][3].value<std::string>()));
  QCOMPARE(json["centre_line"]["length_mm"].toDouble(), line.length);
  QCOMPARE(json["centre_line"]["sections"].toArray().size(), static_cast<qsizetype>(line.points.size()));
  // The plot points at a place, which the views mark, and a click takes the crosshair there.
  auto* plot = window->measures().findChild<ui::SectionPlot*>();
  QTest::mouseMove(plot, plot->rect().center());
  QVERIFY(QTest::qWaitFor([&] { return tool.marker().has_value(); }));
  QVERIFY((tool.marker()->place - line.points[plot->pointed()].place).norm() < 1e-12);
  QVERIFY(std::abs(tool.marker()->radius - kRadius) < 1);
  QTest::mouseClick(plot, Qt::LeftButton, {}, plot->rect().center());
  QVERIFY((window->viewState().crosshair() - tool.marker()->place).norm() < 1e-12);
  QTest::keyClick(plot, Qt::Key_Home);
  QVERIFY((tool.marker()->place - line.points.front().place).norm() < 1e-12);
  QTest::keyClick(plot, Qt::Key_Right);
  QCOMPARE(plot->pointed(), 1);
  page.find(kOneEnd, Vec3(0, 0, 0));  // not in the object
  QVERIFY(QTest::qWaitFor([&] { return !page.isSearching(); }, kPatience));
  QVERIFY(!page.shown() && tool.line().empty());
  QVERIFY(!shownText(*window, "The centre line").isEmpty());
}

void MeasuresTest::aCentreLineLeavesTheViewsWithItsSurface() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  ui::Document& document = window->document();
  const ui::MeasureTool& tool = window->viewState().measure();
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  window->measures().show(MeasuresPanel::Page::centreLine);
  auto& page = window->measures().centreLine();
  page.find(kOneEnd, kOtherEnd);
  QVERIFY(QTest::qWaitFor([&] { return page.shown() && !page.isSearching(); }, kPatience));
  const std::size_t points = page.shown()->line.points.size();
  QCOMPARE(tool.line().size(), points);
  ObjectLabel label = document.objectInfo(0).label;
  label.name = "Bar";
  document.setObjectLabel(0, label, "Name");
  QCOMPARE(tool.line().size(), points);  // it is the same surface
  auto* plot = window->measures().findChild<ui::SectionPlot*>();
  QTest::keyClick(plot, Qt::Key_Home);
  QVERIFY(tool.marker());
  document.goTo(document.lastIteration() - 1);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == document.lastIteration() - 1; }, kPatience));
  QVERIFY(tool.line().empty() && !tool.marker());
  QTest::keyClick(plot, Qt::Key_Right);
  QVERIFY(!tool.marker());
  QVERIFY(page.shown());
  QVERIFY(shownText(*window, "The centre line").contains("an earlier surface"));
}

void MeasuresTest::aReferenceIsComparedAndItsDistancesAreInColour() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  const QString path = folder.filePath("reference.ply");
  writeMesh(icosphere(Vec3(28, 16, 16), 9, 0.8), path.toStdString());
  auto& page = window->measures().compare();
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  window->measures().show(MeasuresPanel::Page::compare);
  page.compareWith(path);
  QVERIFY(page.isComparing());
  QVERIFY(QTest::qWaitFor([&] { return !page.isComparing(); }, kPatience));
  QVERIFY(page.shown() && page.shown()->found.dice);
  QTableWidget* table = tableNamed(*window, "The object beside the reference");
  QVERIFY(table->rowCount() > 8);
  QCOMPARE(table->item(0, 0)->text(), QString("Dice"));
  QCOMPARE(table->item(0, 1)->text(), ui::number(*page.shown()->found.dice, 3));
  const auto colours = window->viewState().distances();
  QVERIFY(colours && colours->isSigned);
  // The ends of the bar stick out, its flanks lie within.
  const auto [least, most] = std::minmax_element(colours->ofFace.begin(), colours->ofFace.end());
  QVERIFY(*least < -2 && *most > 5);
  auto* check = page.findChild<QCheckBox*>();
  check->click();
  QVERIFY(!window->viewState().distances());
  check->click();
  QVERIFY(window->viewState().distances());
  page.compareWith(folder.filePath("bar.nii.gz"));  // an image, not a label map
  QVERIFY(QTest::qWaitFor([&] { return !page.isComparing(); }, kPatience));
  QVERIFY(!page.shown() && !window->viewState().distances());
  QVERIFY(shownText(*window, "State of the comparison").contains("bar.nii.gz"));
}

//! Distances from a reference have a sign, those of the sensitivity have none.
void MeasuresTest::twoPagesDoNotTakeTheColoursOfOneAnotherAway() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  const QString path = folder.filePath("reference.ply");
  writeMesh(icosphere(Vec3(28, 16, 16), 9, 0.8), path.toStdString());
  const auto colours = [&] { return window->viewState().distances(); };
  ui::ComparePage& compared = shownComparePage(*window);
  compared.compareWith(path);
  QVERIFY(isCompared(compared));
  QVERIFY(colours() && colours()->isSigned);
  window->measures().show(MeasuresPanel::Page::sensitivity);
  ui::SensitivityPage& sensed = window->measures().sensitivity();
  sensed.findChild<QSpinBox*>()->setValue(2);
  sensed.start();
  QVERIFY(sensed.isAsking());
  QVERIFY(QTest::qWaitFor([&] { return !sensed.isAsking(); }, kPatience));
  QVERIFY(sensed.shown() && sensed.shown()->grown > 0);
  QVERIFY(colours() && !colours()->isSigned);

  auto *ofCompared = compared.findChild<QCheckBox*>(), *ofSensed = sensed.findChild<QCheckBox*>();
  ofCompared->click();
  QVERIFY(colours() && !colours()->isSigned);
  ofCompared->click();
  QVERIFY(colours() && colours()->isSigned);
  ofSensed->click();
  QVERIFY(colours() && colours()->isSigned);
  ofSensed->click();
  QVERIFY(colours() && !colours()->isSigned);
  ofSensed->click();  // what is ticked still is seen again
  QVERIFY(colours() && colours()->isSigned);

  ofCompared->click();
  ofSensed->click();
  QVERIFY(colours() && !colours()->isSigned);
  sensed.start();  // they go with the figures
  QVERIFY(sensed.isAsking() && !sensed.shown() && !colours());
  buttonOf(sensed, "Cancel")->click();
  QVERIFY(!sensed.isAsking() && !colours());
}

void MeasuresTest::aLabelOfAReferenceIsChosenByItsName() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  ui::ComparePage& page = shownComparePage(*window);
  auto* box = page.findChild<QComboBox*>();
  QCOMPARE(box->accessibleName(), QString("Label of the reference"));
  QVERIFY(!box->isVisible());
  for (const char* name : {"balls.seg.nrrd", "balls.seg.dcm", "IM0001.dcm", "balls.nii.gz"}) {
    page.compareWith(writeBalls(folder, window->document().volume().grid, name));
    QVERIFY(isCompared(page));
    QVERIFY(!page.shown()->b.label);  // all of them at first
    const double both = page.shown()->b.solid.volume();
    const QStringList numbers{"all but 0", "1", "2"},
        names{"all but 0", "1 – Left internal carotid artery, lumen", "2 – Cyst é"};
    QVERIFY(box->isVisible());
    QCOMPARE(textsOf(*box), QByteArray(name).endsWith(".nii.gz") ? numbers : names);
    const QString faults = lastingLayoutFaults(*window).join(QLatin1Char('\n'));
    QVERIFY2(faults.isEmpty(), qPrintable(faults));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_End);
    QVERIFY(page.isComparing());  // at once
    QVERIFY(isCompared(page));
    QVERIFY(page.shown()->b.label == 2);
    QVERIFY(page.shown()->b.solid.volume() < 0.4 * both);  // 64 of 189 parts
    QCOMPARE(box->currentIndex(), 2);
    QCOMPARE(box->count(), 3);
  }
  // A mesh has none.
  const TriangleSoup ball = icosphere(Vec3(28, 16, 16), 9, 0.8);
  const QString mesh = folder.filePath("reference.ply"), dicom = folder.filePath("IM0002");
  writeMesh(ball, mesh.toStdString());
  writeDicomStl({{{}, ball}}, {}, {}, dicom.toStdString());
  for (const QString& path : {mesh, dicom}) {
    page.compareWith(path);
    QVERIFY(!box->isVisible());
    QVERIFY(isCompared(page));
    QVERIFY(!page.shown()->b.label);
    QVERIFY(!page.shown()->b.solid.mask);
  }
}

void MeasuresTest::labelsThatCannotBeListedSayWhy() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  const QString path = folder.filePath("many.nii.gz");
  const auto label = [](int i, int j, int k) {
    return (Vec3(i, j, k) - Vec3(28, 16, 16)).norm() < 9 ? 1 + (i + 57 * (j + 33 * k)) % 1000 : 0;
  };
  writeVolume(testing::volumeByIndex(window->document().volume().grid, label), path.toStdString());
  ui::ComparePage& page = shownComparePage(*window);
  page.compareWith(path);
  QVERIFY(isCompared(page));  // as a whole
  QVERIFY(shownText(*window, "Why no labels are listed").contains("many.nii.gz"));
  QVERIFY(!page.findChild<QComboBox*>()->isEnabled());
  page.compareWith(folder.filePath("none.nii.gz"));
  QVERIFY(!isCompared(page));
  QVERIFY(!shownLabel(*window, "Why no labels are listed"));  // told once
  QVERIFY(shownText(*window, "State of the comparison").contains("none.nii.gz"));
}

void MeasuresTest::anotherObjectIsTheReference() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window && openBall(*window, folder.filePath("R&B.ply")));
  ui::Document& document = window->document();
  QCOMPARE(document.activeObject(), 0);
  ui::ComparePage& page = shownComparePage(*window);
  buttonOf(page, "Choose reference…")->click();
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  QVERIFY(menu);
  QStringList offered;
  const auto actions = menu->actions();
  for (const QAction* action : actions)
    if (!action->isSeparator()) offered << action->text();
  QCOMPARE(offered, QStringList({"From a file…", "R&&B"}));
  QTest::keyClick(menu, Qt::Key_Up);  // the last
  QTest::keyClick(menu, Qt::Key_Return);
  QVERIFY(page.isComparing());
  QVERIFY(isCompared(page));
  QCOMPARE(page.shown()->b.path, std::string("R&B"));
  QVERIFY(!page.shown()->b.solid.mask && window->viewState().distances());
  QVERIFY(*page.shown()->found.dice == 0);
  const double farthest = page.shown()->found.distances->hausdorff();
  const auto told = [&] { return shownText(*window, "State of the comparison"); };
  const auto isEarlier = [&] { return told().contains("earlier surface"); };
  QVERIFY(!isEarlier());
  ObjectLabel label = document.objectInfo(1).label;
  label.name = "Expert";
  document.setObjectLabel(1, label, QStringLiteral("Change object"));
  QCOMPARE(shownText(*window, "The reference"), QString("Expert"));
  QVERIFY(!isEarlier());
  // It does not compare with itself.
  document.setActiveObject(1);
  QVERIFY(isEarlier());
  QVERIFY(!buttonOf(page, "Compare")->isEnabled());
  document.setActiveObject(0);
  QVERIFY(!isEarlier() && buttonOf(page, "Compare")->isEnabled());
  // It is deleted, and comes back.
  document.setObjectLocked(1, false);
  document.removeObject(1);
  QCOMPARE(document.objectCount(), 1);
  QVERIFY(isEarlier());
  QVERIFY(!buttonOf(page, "Compare")->isEnabled());
  document.undoStack()->undo();
  QVERIFY(!isEarlier() && buttonOf(page, "Compare")->isEnabled());
  // As with its file.
  page.compareWith(folder.filePath("R&B.ply"));
  QVERIFY(isCompared(page));
  QVERIFY(std::abs(page.shown()->found.distances->hausdorff() - farthest) < 1e-4);
  // Another surface of it.
  page.compareWithObject(1);
  QVERIFY(isCompared(page) && !isEarlier());
  document.setActiveObject(1);
  page.compareWithObject(0);
  QVERIFY(isCompared(page) && !isEarlier());
  document.setActiveObject(0);
  document.goTo(3);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == 3; }, kPatience));
  document.setActiveObject(1);
  QVERIFY(isEarlier());
}

void MeasuresTest::distancesAreSavedAsTheCommandLineWritesThem() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  ui::Document& document = window->document();
  document.setPolishes(false);  // what is compared is the surface that is shown
  const QString surface = folder.filePath("surface.ply"), reference = folder.filePath("reference.ply"),
                told = folder.filePath("told.vtp"), saved = folder.filePath("saved.vtp");
  writeMesh(icosphere(Vec3(28, 16, 16), 9, 0.8), reference.toStdString());
  QSignalSpy exported(&document, &ui::Document::exported);
  document.exportResult(surface, CoordinateSpace::lps);
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QCOMPARE(QProcess::execute(HANDLEBODY_CLI, {"compare", surface, reference, "-o", told}), 0);

  ui::ComparePage& page = shownComparePage(*window);
  QAbstractButton* save = buttonOf(page, "Save distances…");
  QVERIFY(save && !save->isEnabled());
  page.compareWith(reference);
  QVERIFY(isCompared(page));
  QVERIFY(save->isEnabled());
  ui::FileWriter write;
  QObject::connect(
      &window->measures(), &MeasuresPanel::saveFileRequested, window.get(),
      [&](const QString&, const QString& what, const QString& extension, const ui::FileWriter& writer) {
        QCOMPARE(what + extension, QString("distances.vtp"));
        write = writer;
      });
  QObject::disconnect(&window->measures(), nullptr, &window->files(), nullptr);  // a dialog would wait
  for (const bool isAnonymous : {false, true}) {
    page.setAnonymous(isAnonymous);
    save->click();
    QVERIFY(write);
    write(saved.toStdString());
    QVERIFY(!contentOf(told).isEmpty());
    QCOMPARE(contentOf(saved), contentOf(told));
    QVERIFY(QFile::remove(saved));
  }
  QVERIFY_THROWS_EXCEPTION(OutputError, write(folder.filePath("no/such/folder/x.vtp").toStdString()));
}

void MeasuresTest::formatsThatCannotBeMadeSayWhy() {
  const QTemporaryDir folder;
  auto window = grownWindow(folder);
  QVERIFY(window);
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  QComboBox* format = nullptr;
  for (QComboBox* box : panel->findChildren<QComboBox*>())
    if (box->accessibleName() == "Format") format = box;
  QVERIFY(format);
  for (const char* ending : {".stl", ".vtp", ".ply", ".obj", ".3mf", ".nii.gz", ".nrrd", ".mha", ".seg.nrrd",
                             ".seg.dcm", ".stl.dcm", ".msh", ".vtu", ".inp"}) {
    const int index = format->findData(QString::fromLatin1(ending));
    QVERIFY2(index >= 0, ending);
    format->setCurrentIndex(index);
    const QLabel* fault = shownLabel(*window, "Why nothing is written");
    QCOMPARE(fault ? fault->text() : QString(), window->document().exportFault(QString::fromLatin1(ending)));
    QCOMPARE(fault != nullptr, !window->document().exportFault(QString::fromLatin1(ending)).isEmpty());
    QVERIFY(!QString::fromLatin1(ending).endsWith(".dcm") || fault);  // the volume is no DICOM
    const QString faults = lastingLayoutFaults(*window).join(QLatin1Char('\n'));
    QVERIFY2(faults.isEmpty(), qPrintable(faults));
  }
  // Who made it is asked where DICOM has a place for it, and told as it was typed.
  const auto field = [&](const char* name) {
    for (QLineEdit* edit : panel->findChildren<QLineEdit*>())
      if (edit->accessibleName() == QLatin1String(name) && edit->isVisible()) return edit;
    return static_cast<QLineEdit*>(nullptr);
  };
  QVERIFY(!field("Creator") && !field("Description"));
  for (const char* ending : {".stl.dcm", ".seg.dcm"}) {
    format->setCurrentIndex(format->findData(QString::fromLatin1(ending)));
    QVERIFY(field("Description"));
    QCOMPARE(field("Creator") != nullptr, QString::fromLatin1(ending) == QLatin1String(".seg.dcm"));
  }
  QTest::keyClicks(field("Creator"), "Doe^Jane\\ ");  // no backslash in DICOM
  QTest::keyClicks(field("Description"), "left ventricle");
  QCOMPARE(panel->content().creator, std::string("Doe^Jane"));
  QCOMPARE(panel->content().description, std::string("left ventricle"));
  // While a file is written that is shown, with a way out; a failure is told at its place.
  format->setCurrentIndex(format->findData(".stl"));
  window->document().exportResult(folder.filePath("no/such/folder/x.stl"), panel->space());
  const auto bars = panel->findChildren<QProgressBar*>();
  QVERIFY(std::any_of(bars.begin(), bars.end(), [](const QProgressBar* bar) { return bar->isVisible(); }));
  QVERIFY(
      QTest::qWaitFor([&] { return shownLabel(*window, "Why nothing is written") != nullptr; }, kPatience));
  QVERIFY(std::none_of(bars.begin(), bars.end(), [](const QProgressBar* bar) { return bar->isVisible(); }));
}

//! A window in which every page of the panel has something to show.
std::unique_ptr<ui::MainWindow> fullWindow(const QTemporaryDir& folder) {
  auto window = grownWindow(folder);
  if (!window) return nullptr;
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  ui::Document& document = window->document();
  ObjectLabel label = document.objectInfo(0).label;
  label.name = "Left internal carotid artery, lumen";
  document.setObjectLabel(0, label, QStringLiteral("Change object"));
  document.measurements().add({MeasurementKind::ruler, {Vec3(1, 2, 3), Vec3(40, 30, 20)}});
  document.measurements().add({MeasurementKind::angle, {Vec3(1, 2, 3), Vec3(9, 9, 9), Vec3(40, 30, 20)}});
  document.measurements().select(0);
  window->measures().centreLine().find(kOneEnd, kOtherEnd);
  // Of all kinds of references the one that says most.
  window->measures().compare().compareWith(writeBalls(folder, document.volume().grid, "balls.seg.nrrd"));
  const auto isReady = [&] {
    return !window->measures().centreLine().isSearching() && !window->measures().compare().isComparing();
  };
  if (!isMeasured(*window) || !QTest::qWaitFor(isReady, kPatience)) return nullptr;
  window->measures().findChild<ui::SectionPlot*>()->point(8);
  return window;
}

void MeasuresTest::nothingIsCutOffInThePanel() {
  const QTemporaryDir folder;
  auto window = fullWindow(folder);
  QVERIFY(window);
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    window->setAppearance(appearance);
    for (const QSize& size : {QSize(1280, 800), QSize(1600, 1000)}) {
      window->resize(size);
      const QString faults = faultsOfPages(*window).join(QLatin1Char('\n'));
      QVERIFY2(faults.isEmpty(), qPrintable(faults));
    }
  }
}

void MeasuresTest::nothingIsCutOffInAnyLanguage() {
  for (const ui::Language& language : ui::languages()) {
    const QTemporaryDir folder;
    ui::useLanguage(language.code);
    auto window = fullWindow(folder);
    QVERIFY(window);
    window->resize(1280, 800);
    QStringList faults = faultsOfPages(*window);
    if (window->width() > 1280 || window->height() > 800) faults << "larger than 1280 x 800";
    QVERIFY2(faults.isEmpty(), qPrintable(language.code + ":\n" + faults.join(QLatin1Char('\n'))));
  }
  ui::useLanguage(QStringLiteral("en"));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  MeasuresTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "measures_test.moc"
