// Surfaces and label maps that become objects: what is asked about them, and what is told.

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProgressDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QUndoStack>

#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/io/overlapping_segments.h"
#include "tests/ui/window/two_balls.h"
#include "ui/window/open/open_objects_dialog.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

//! What is asked of a file with objects just now; null if nothing is.
ui::OpenObjectsDialog* askedOf(ui::MainWindow& window) {
  const auto all = window.findChildren<ui::OpenObjectsDialog*>();
  for (ui::OpenObjectsDialog* dialog : all)
    if (dialog->isVisible()) return dialog;
  return nullptr;
}

//! False if nothing is asked, or it has no such answer.
bool answer(ui::MainWindow& window, const char* text) {
  ui::OpenObjectsDialog* dialog = askedOf(window);
  if (!dialog) return false;
  auto* button = saying<QPushButton>(*dialog, text);
  if (!button || !QTest::qWaitFor([&] { return button->isEnabled() || askedOf(window) != dialog; }))
    return false;
  QTest::mouseClick(button, Qt::LeftButton);
  return true;
}

//! The list of the labels of a file, when they are read.
QListWidget* askedLabels(ui::MainWindow& window, const QString& path) {
  window.files().openObjects(path);
  ui::OpenObjectsDialog* dialog = askedOf(window);
  if (!dialog) return nullptr;
  auto* list = dialog->findChild<QListWidget*>();
  return list && QTest::qWaitFor([&] { return list->count() > 0; }, kPatience) ? list : nullptr;
}

//! Segments 1 and 2 of the volume of writeBalls(), the smaller of which reaches into the other one.
QString writeSegments(const QTemporaryDir& folder) {
  const QString path = folder.filePath("organs.seg.nrrd");
  test::writeLayers({{"Liver", "0 1 0", test::inBall(kLeft, 7)},
                     {"Lesion", "1 0 0", test::inBall(kLeft + Vec3(6, 0, 0), 4)}},
                    testing::cubicGrid(41), path.toStdString());
  return path;
}

void drop(ui::MainWindow& window, const QStringList& paths) {
  QMimeData mime;
  QList<QUrl> urls;
  for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
  mime.setUrls(urls);
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);  // without it Qt drops the drop
  QDropEvent event(QPointF(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &event);
}

void drop(ui::MainWindow& window, const QString& path) { drop(window, QStringList(path)); }

//! The segments of writeSegments() within DICOM, under a name as media of a PACS have it.
QString writeDicomSegments(const QTemporaryDir& folder, const char* name) {
  const QString path = folder.filePath(QString::fromLatin1(name));
  test::writeOverlappingDicom(
      {{"Liver", {}, test::inBall(kLeft, 7)}, {"Lesion", {}, test::inBall(kLeft + Vec3(6, 0, 0), 4)}},
      testing::cubicGrid(41), path.toStdString());
  return path;
}

}  // namespace

class OpenedObjectsWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aDroppedMeshIsAskedAboutAndBecomesAnObject();
  void droppedDicomIsKnownByWhatIsInIt();
  void anotherLayerOfAnOpenSegmentationIsNoObjectOfIt();
  void ofALabelMapWhatIsCheckedIsOpened();
  void howLabelsBecomeSurfacesIsChosen();
  void thatSegmentsOverlapIsTold();
  void thatOneMeetsAnotherIsTold();
  void whatIsCancelledOpensNothing();
  void whatIsNoLabelMapIsToldAndAsksNothing();
  void ofSeveralDroppedMeshesItIsToldAtOnceThatOneIsOpened();
};

void OpenedObjectsWindowTest::aDroppedMeshIsAskedAboutAndBecomesAnObject() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  const QString path = folder.filePath("old lesion.stl");
  writeMesh(icosphere(kRight, 4, 1.2), path.toStdString());
  QSignalSpy opened(&window->document(), &ui::Document::objectsOpened);
  drop(*window, path);
  QVERIFY(askedOf(*window));
  QVERIFY(!askedOf(*window)->findChild<QListWidget*>());
  QVERIFY(answer(*window, "Done"));
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().objectCount(), 2);
  QVERIFY(panelOf(*window)->isVisible());
  QCOMPARE(tableOf(*window)->item(0, 0)->text(), QString("old lesion"));
  QVERIFY(QTest::qWaitFor([&] { return window->document().objectInfo(0).snapshot != nullptr; }, kPatience));
  QVERIFY(window->document().objectInfo(0).locked);
  QVERIFY(window->findChild<ui::MessageBar*>()->isVisible());
  QCOMPARE(window->document().undoStack()->undoText(), QString("Open object"));
  window->files().openObjects(path);
  QVERIFY(answer(*window, "grow from"));
  QVERIFY(QTest::qWaitFor([&] { return opened.size() == 2; }, kPatience));
  QCOMPARE(window->document().objectCount(), 3);
  QCOMPARE(window->document().activeObject(), 2);
  window->files().openObjects(path);
  QVERIFY(answer(*window, "Cancel"));
  QVERIFY(!askedOf(*window));
  QCOMPARE(window->document().objectCount(), 3);
}

void OpenedObjectsWindowTest::droppedDicomIsKnownByWhatIsInIt() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window);
  const QString surface = folder.filePath("IM0003");
  writeDicomStl({{{}, icosphere(kRight, 4, 1.2)}}, {}, {}, surface.toStdString());
  drop(*window, surface);
  QVERIFY(window->messages().text().contains("is a surface"));
  QVERIFY(open(*window, writeBalls(folder)));
  const QString volume = window->document().path();
  for (const char* name : {"IM0001.dcm", "IM0002"}) {
    drop(*window, writeDicomSegments(folder, name));
    QVERIFY2(askedOf(*window), name);
    auto* list = askedOf(*window)->findChild<QListWidget*>();
    QVERIFY(list);
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 2, kPatience);
    QCOMPARE(list->item(0)->text(), QString("1: Liver"));
    QVERIFY(answer(*window, "Cancel"));
  }
  QSignalSpy opened(&window->document(), &ui::Document::objectsOpened);
  drop(*window, surface);
  QVERIFY(askedOf(*window) && !askedOf(*window)->findChild<QListWidget*>());
  QVERIFY(answer(*window, "Done"));
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().objectCount(), 2);
  QCOMPARE(window->document().path(), volume);
}

void OpenedObjectsWindowTest::anotherLayerOfAnOpenSegmentationIsNoObjectOfIt() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  const QString path = writeDicomSegments(folder, "IM0001");
  QVERIFY(window && open(*window, path));
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  window->files().open(path, {.frame = 1});  // as the step Open does
  QVERIFY(!askedOf(*window));
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().selection().frame.value_or(0), 1);
}

void OpenedObjectsWindowTest::ofALabelMapWhatIsCheckedIsOpened() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QSignalSpy opened(&window->document(), &ui::Document::objectsOpened);
  window->files().openObjects(writeSegments(folder));
  ui::OpenObjectsDialog* dialog = askedOf(*window);
  QVERIFY(dialog);
  auto* done = saying<QPushButton>(*dialog, "Done");
  QVERIFY(done && !done->isEnabled());  // they are still read
  auto* list = dialog->findChild<QListWidget*>();
  QVERIFY(list);
  QTRY_COMPARE_WITH_TIMEOUT(list->count(), 2, kPatience);
  QCOMPARE(list->item(0)->text(), QString("1: Liver"));
  QCOMPARE(list->item(1)->text(), QString("2: Lesion"));
  for (int row = 0; row < 2; ++row) QCOMPARE(list->item(row)->checkState(), Qt::Checked);
  QCOMPARE(list->item(1)->icon().pixmap(12).toImage().pixelColor(6, 6), QColor(255, 0, 0));
  QVERIFY(done->isEnabled() && done->isDefault());
  QVERIFY(dialog->width() <= 1280 && dialog->height() <= 800);
  QTest::mouseClick(saying<QPushButton>(*dialog, "None"), Qt::LeftButton);
  QVERIFY(!done->isEnabled());
  QTest::mouseClick(saying<QPushButton>(*dialog, "All"), Qt::LeftButton);
  QVERIFY(done->isEnabled());
  QTest::keyClick(list, Qt::Key_Space);  // the first, which is current
  QCOMPARE(list->item(0)->checkState(), Qt::Unchecked);
  QTest::keyClick(list, Qt::Key_Return);
  QVERIFY(!askedOf(*window));
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(opened.at(0).at(1).toStringList(), QStringList{"Lesion"});
  QCOMPARE(window->document().objectCount(), 2);
  QVERIFY(window->document().objectInfo(0).locked);
}

void OpenedObjectsWindowTest::howLabelsBecomeSurfacesIsChosen() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  QSignalSpy opened(&document, &ui::Document::objectsOpened);
  const QString path = writeSegments(folder);
  const auto shapeOf = [&](const auto& choose) {
    const QListWidget* list = askedLabels(*window, path);
    if (!list) return LabelShape{.smoothing = -1};
    choose(*askedOf(*window));
    opened.clear();
    if (!answer(*window, "grow from") || (opened.isEmpty() && !opened.wait(kPatience)))
      return LabelShape{.smoothing = -1};
    const LabelShape shape = document.constraints().start->shape;
    document.undoStack()->undo();
    return shape;
  };
  QCOMPARE(shapeOf([](QWidget&) {}), LabelShape());
  const LabelShape none = shapeOf([](QWidget& asked) {
    auto* smoothing = called<QComboBox>(asked, "Smoothing");
    smoothing->setCurrentIndex(smoothing->findText("None"));
    saying<QCheckBox>(asked, "largest")->setChecked(true);
  });
  QCOMPARE(none, (LabelShape{.smoothing = 0, .keepsLargest = true}));
  const LabelShape some = shapeOf([](QWidget& asked) {
    auto* smoothing = called<QComboBox>(asked, "Smoothing");
    smoothing->setCurrentIndex(smoothing->findText("A length"));
    auto* length = called<QDoubleSpinBox>(asked, "Length of the smoothing");
    QVERIFY(length->isEnabled() && length->suffix() == " mm");
    length->setValue(0.75);
    auto* tunnels = called<QSpinBox>(asked, "Tunnels at most");
    QVERIFY(!tunnels->isEnabled());
    saying<QCheckBox>(asked, "tunnels")->setChecked(true);
    tunnels->setValue(2);
  });
  QCOMPARE(some, (LabelShape{.smoothing = 0.75, .genus = 2}));
}

void OpenedObjectsWindowTest::thatSegmentsOverlapIsTold() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  QSignalSpy opened(&document, &ui::Document::objectsOpened);
  QVERIFY(askedLabels(*window, writeSegments(folder)));
  const auto* overlap = called<QLabel>(*askedOf(*window), "Segments that overlap");
  QVERIFY(overlap && overlap->isVisible());
  auto* progress = window->findChild<QProgressDialog*>();
  QVERIFY(progress);
  progress->setMinimumDuration(0);  // as if it took long
  QVERIFY(answer(*window, "Done"));
  QVERIFY(QTest::qWaitFor([&] { return progress->isVisible() || !opened.isEmpty(); }, kPatience));
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QVERIFY(window->messages().text().contains("overlap"));
  QVERIFY(!progress->isVisible());
  QVERIFY(QTest::qWaitFor([&] { return document.objectInfo(0).snapshot != nullptr; }, kPatience));
  window->showStep(Command::stepGrow);
  document.setActiveObject(0);  // the liver, which is the larger one
  QTRY_VERIFY(shownText(*window, "Doubts about the surface").contains("overlap"));
  document.setActiveObject(1);
  QVERIFY(!shownText(*window, "Doubts about the surface").contains("overlap"));
}

void OpenedObjectsWindowTest::thatOneMeetsAnotherIsTold() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  const QString path = folder.filePath("lesion.stl");
  writeMesh(icosphere(kRight, 4, 1.2), path.toStdString());
  window->files().openObjects(path);
  QVERIFY(answer(*window, "Done"));
  QVERIFY(QTest::qWaitFor([&] { return window->document().objectInfo(0).snapshot != nullptr; }, kPatience));
  QVERIFY(!window->messages().text().contains("meets"));
  window->files().openObjects(path);
  QVERIFY(answer(*window, "Done"));
  QTRY_VERIFY_WITH_TIMEOUT(window->messages().text().contains("meets"), kPatience);
  QVERIFY(window->messages().isVisible());
}

void OpenedObjectsWindowTest::whatIsCancelledOpensNothing() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QSignalSpy opening(&window->document(), &ui::Document::openingObjects);
  const QString path = writeSegments(folder);
  window->files().openObjects(path);
  QVERIFY(askedOf(*window));
  QTest::keyClick(askedOf(*window), Qt::Key_Escape);  // while the labels are read
  QVERIFY(!askedOf(*window));
  const QListWidget* list = askedLabels(*window, path);
  QVERIFY(list);
  QTest::keyClick(askedOf(*window), Qt::Key_Escape);
  QVERIFY(!askedOf(*window));
  QTest::qWait(100);
  QVERIFY(opening.isEmpty());
  QVERIFY(!window->messages().isVisible());
  QCOMPARE(window->document().objectCount(), 1);
}

void OpenedObjectsWindowTest::whatIsNoLabelMapIsToldAndAsksNothing() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  const QString volume = writeBalls(folder);
  QVERIFY(window && open(*window, volume));
  window->files().openObjects(volume);
  QVERIFY(askedOf(*window));
  QTRY_VERIFY_WITH_TIMEOUT(!askedOf(*window), kPatience);
  QVERIFY(window->messages().text().contains("whole numbers"));
  QCOMPARE(window->document().objectCount(), 1);
}

void OpenedObjectsWindowTest::ofSeveralDroppedMeshesItIsToldAtOnceThatOneIsOpened() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  const QString first = folder.filePath("first.stl"), second = folder.filePath("second.stl");
  writeMesh(icosphere(kLeft, 4, 1.2), first.toStdString());
  writeMesh(icosphere(kRight, 4, 1.2), second.toStdString());
  drop(*window, QStringList{first, second});
  QVERIFY(window->messages().isVisible() && window->messages().text().startsWith("Several files"));
  QVERIFY(answer(*window, "Cancel"));
  QVERIFY(open(*window, sample("cyst.nii.gz")));  // has nothing to do with it
  QVERIFY2(!window->messages().text().contains("Several files") || !window->messages().isVisible(),
           qPrintable(window->messages().text()));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  OpenedObjectsWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "opened_objects_window_test.moc"
