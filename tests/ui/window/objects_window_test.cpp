// The list of objects in the window: by mouse and keys, drawn, exported, and out of the way with one object.

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
#include <QTableWidget>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <set>

#include "core/collision/body_contact.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/io/overlapping_segments.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/objects/object_dialog.h"
#include "ui/window/objects/objects_panel.h"
#include "ui/window/open/open_objects_dialog.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

const Vec3 kLeft(12, 20, 20), kRight(28, 20, 20);

//! Two dark balls that run into one another.
QString writeBalls(const QTemporaryDir& folder) {
  const QString path = folder.filePath("balls.nii.gz");
  const auto intensity = [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const double distance = std::min((p - kLeft).norm(), (p - kRight).norm()) - 8.5;
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 110 + 90 * std::clamp(distance, -1.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41), intensity), path.toStdString());
  return path;
}

ui::ObjectsPanel* panelOf(ui::MainWindow& window) { return window.findChild<ui::ObjectsPanel*>(); }
QTableWidget* tableOf(ui::MainWindow& window) { return panelOf(window)->findChild<QTableWidget*>(); }

QToolButton* buttonNamed(ui::MainWindow& window, const QString& name) {
  const auto buttons = panelOf(window)->findChildren<QToolButton*>();
  for (QToolButton* button : buttons)
    if (button->accessibleName() == name) return button;
  return nullptr;
}

bool hasColour(const QImage& picture, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      count += std::abs(c.red() - colour.red()) < 30 && std::abs(c.green() - colour.green()) < 30 &&
               std::abs(c.blue() - colour.blue()) < 30;
    }
  return count > 20;
}

bool addSecond(ui::MainWindow& window) {
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  window.viewState().setCrosshair(kRight);
  QTest::keyClick(&window, Qt::Key_Return);
  return window.document().objectCount() == 2 && window.document().seeds().size() == 1;
}

//! The first object is stopped on its way, the second grows to its end.
bool growTwo(ui::MainWindow& window) {
  window.viewState().setCrosshair(kLeft);
  QTest::keyClick(&window, Qt::Key_Return);
  for (int i = 1; i <= 8; ++i) {
    QTest::keyClick(&window, Qt::Key_Period);
    if (!QTest::qWaitFor([&] { return window.document().iteration() == i; }, kPatience)) return false;
  }
  if (!waitFor(window, GrowthState::paused) || !addSecond(window)) return false;
  QTest::keyClick(&window, Qt::Key_Space);
  return waitFor(window, GrowthState::finished);
}

}  // namespace

class ObjectsWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void withOneObjectTheListIsOutOfTheWay();
  void twoObjectsGrowOneAfterTheOther();
  void theListIsDrivenByMouseAndKeys();
  void propertiesAreChangedInADialog();
  void aTermOfAFileStandsFirstUntilAnotherIsChosen();
  void allAreExportedTogether();
  void aDroppedMeshIsAskedAboutAndBecomesAnObject();
  void droppedDicomIsKnownByWhatIsInIt();
  void anotherLayerOfAnOpenSegmentationIsNoObjectOfIt();
  void ofALabelMapWhatIsCheckedIsOpened();
  void howLabelsBecomeSurfacesIsChosen();
  void thatSegmentsOverlapIsTold();
  void whatIsCancelledOpensNothing();
  void whatIsNoLabelMapIsToldAndAsksNothing();
  void whatIsBetteredIsChosenAndTold();
};

void ObjectsWindowTest::withOneObjectTheListIsOutOfTheWay() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(!panelOf(*window)->isVisible());
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QVERIFY(panelOf(*window)->isVisible());
  QCOMPARE(tableOf(*window)->rowCount(), 2);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!panelOf(*window)->isVisible());
}

void ObjectsWindowTest::twoObjectsGrowOneAfterTheOther() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  ui::Document& document = window->document();
  QVERIFY(bodyContact(document.objectInfo(0).snapshot->mesh, document.snapshot()->mesh) == BodyContact::none);
  QVERIFY(tableOf(*window)->item(0, 1)->text().endsWith("ml"));
  QVERIFY(tableOf(*window)->item(1, 1)->text().endsWith("ml"));

  // Both outlines are drawn in their colours; a hidden one is not.
  window->viewState().setCrosshair({20, 20, 20});
  ObjectLabel label = document.objectInfo(0).label;
  label.colour = {204, 0, 204};  // nothing else is
  document.setObjectLabel(0, label, QStringLiteral("Change object"));
  const QColor first(204, 0, 204), second(230, 159, 0);
  ui::SliceView& slice = window->views().slice(ui::Plane::axial);
  QVERIFY(hasColour(slice.picture(), first));
  QVERIFY(hasColour(slice.picture(), second));
  QTest::mouseClick(buttonNamed(*window, "Hide Object"), Qt::LeftButton);
  QCOMPARE(document.activeObject(), 1);
  QVERIFY(!hasColour(slice.picture(), first));
  QVERIFY(hasColour(slice.picture(), second));
  QTest::keyClick(window.get(), Qt::Key_H, Qt::ControlModifier);
  QVERIFY(!hasColour(slice.picture(), second));

  // The first one grows on: the second is made with an earlier one.
  QTest::keyClick(window.get(), Qt::Key_PageUp, Qt::ControlModifier);
  QCOMPARE(document.activeObject(), 0);
  QTest::keyClick(window.get(), Qt::Key_Period);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == 9; }, kPatience));
  QVERIFY(waitFor(*window, GrowthState::paused));
  QTest::keyClick(window.get(), Qt::Key_PageDown, Qt::ControlModifier);
  const QLabel* notice = shownLabel(*window, "What the active object is made with");
  QVERIFY(notice && notice->text().contains("earlier"));
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(!shownLabel(*window, "What the active object is made with"));
}

void ObjectsWindowTest::theListIsDrivenByMouseAndKeys() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QTest::mouseClick(buttonNamed(*window, "Add object"), Qt::LeftButton);
  QCOMPARE(document.objectCount(), 3);
  QTableWidget* table = tableOf(*window);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->item(1, 0)).center());
  QCOMPARE(document.activeObject(), 1);
  QTest::keyClick(table, Qt::Key_Down);
  QCOMPARE(document.activeObject(), 2);
  QTest::keyClick(window.get(), Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(document.activeObject(), 1);
  QCOMPARE(table->item(1, 0)->text(), QString("Object 3"));
  QCOMPARE(table->currentRow(), 1);
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  QVERIFY(document.objectInfo(1).locked);
  QVERIFY(!window->commands()[Command::addSeed]->isEnabled());
  QVERIFY(!window->commands()[Command::deleteObject]->isEnabled());
  QTest::mouseClick(buttonNamed(*window, "Unlock Object 3"), Qt::LeftButton);
  QVERIFY(window->commands()[Command::addSeed]->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_Backspace, Qt::ControlModifier);
  QCOMPARE(document.objectCount(), 2);
  QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(document.objectCount(), 3);
}

void ObjectsWindowTest::propertiesAreChangedInADialog() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QTest::keyClick(window.get(), Qt::Key_F2);
  auto* dialog = window->findChild<ui::ObjectDialog*>();
  QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
  auto* name = dialog->findChild<QLineEdit*>();
  QVERIFY(name->accessibleName() == "Name");
  name->setText("Object");  // the other one's
  QTest::keyClick(name, Qt::Key_Return);
  QVERIFY(dialog->isVisible());
  auto* term = dialog->findChild<QComboBox*>();
  term->setCurrentIndex(term->findData("liver"));
  QVERIFY(term->currentIndex() >= 0);
  Q_EMIT term->activated(term->currentIndex());
  QCOMPARE(name->text(), QString("Liver"));
  dialog->accept();
  const ObjectLabel label = window->document().objectInfo(1).label;
  QCOMPARE(label.name, std::string("Liver"));
  QCOMPARE(label.term, std::string("liver"));
  QCOMPARE(label.value, 2);
  QCOMPARE(tableOf(*window)->item(1, 0)->text(), QString("Liver"));
  QCOMPARE(window->document().undoStack()->undoText(), QString("Change object"));
}

void ObjectsWindowTest::aTermOfAFileStandsFirstUntilAnotherIsChosen() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  ObjectLabel label = document.objectInfo(0).label;
  label.source.terminology = Terminology{
      {"T-D0050", "SRT", "Tissue"}, {{"T-71000", "SRT", "Kidney"}, {{"G-A101", "SRT", "Left"}}}, {}};
  label.source.algorithm = SegmentAlgorithm{AlgorithmType::automatic, "Net"};
  document.setObjectLabel(0, label, QStringLiteral("Change object"));
  const auto choose = [&](int index) {
    window->activateWindow();  // a dialog that closes leaves none active without a window manager
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_F2);
    auto* dialog = window->findChild<ui::ObjectDialog*>();
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
    auto* term = dialog->findChild<QComboBox*>();
    QCOMPARE(term->currentText(), QString("Kidney, Left"));
    QCOMPARE(term->count(), static_cast<int>(terms().size()) + 1);
    if (index < 0) index = term->findData("liver");
    term->setCurrentIndex(index);
    Q_EMIT term->activated(index);
    dialog->accept();
    QTRY_VERIFY(!window->findChild<ui::ObjectDialog*>());
  };
  choose(0);
  QVERIFY(document.objectInfo(0).label == label);
  choose(-1);
  QCOMPARE(document.objectInfo(0).label.term, std::string("liver"));
  QVERIFY(!document.objectInfo(0).label.source.terminology);
  QVERIFY(document.objectInfo(0).label.source.algorithm == label.source.algorithm);
}

void ObjectsWindowTest::allAreExportedTogether() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  QVERIFY(panel->takesAll());
  const QLabel* numbers = shownLabel(*window, "What is written");
  QVERIFY(numbers && numbers->text().contains("2"));
  QSignalSpy exported(&window->document(), &ui::Document::exported);
  const QString path = folder.filePath("all.nrrd");
  window->document().exportObjects(path, panel->space());
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  const Volume map = readVolume(path.toStdString());
  std::set<int> values;
  visitVoxels(map, [&](const auto* voxels) {
    for (std::size_t i = 0; i < map.grid.voxelCount(); ++i) values.insert(static_cast<int>(voxels[i]));
  });
  QCOMPARE(values, (std::set<int>{0, 1, 2}));
}

//! What is asked of a file with objects just now; null if nothing is.
ui::OpenObjectsDialog* askedOf(ui::MainWindow& window) {
  const auto all = window.findChildren<ui::OpenObjectsDialog*>();
  for (ui::OpenObjectsDialog* dialog : all)
    if (dialog->isVisible()) return dialog;
  return nullptr;
}

template <typename Widget>
Widget* saying(QWidget& parent, const char* text) {
  const auto all = parent.findChildren<Widget*>();
  for (Widget* widget : all)
    if (widget->text().remove('&').contains(QLatin1String(text))) return widget;
  return nullptr;
}

template <typename Widget>
Widget* called(QWidget& parent, const char* name) {
  const auto all = parent.findChildren<Widget*>();
  for (Widget* widget : all)
    if (widget->accessibleName() == QLatin1String(name)) return widget;
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

void drop(ui::MainWindow& window, const QString& path) {
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);  // without it Qt drops the drop
  QDropEvent event(QPointF(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &event);
}

//! The segments of writeSegments() within DICOM, under a name as media of a PACS have it.
QString writeDicomSegments(const QTemporaryDir& folder, const char* name) {
  const QString path = folder.filePath(QString::fromLatin1(name));
  test::writeOverlappingDicom(
      {{"Liver", {}, test::inBall(kLeft, 7)}, {"Lesion", {}, test::inBall(kLeft + Vec3(6, 0, 0), 4)}},
      testing::cubicGrid(41), path.toStdString());
  return path;
}

void ObjectsWindowTest::aDroppedMeshIsAskedAboutAndBecomesAnObject() {
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

void ObjectsWindowTest::droppedDicomIsKnownByWhatIsInIt() {
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

void ObjectsWindowTest::anotherLayerOfAnOpenSegmentationIsNoObjectOfIt() {
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

void ObjectsWindowTest::ofALabelMapWhatIsCheckedIsOpened() {
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

void ObjectsWindowTest::howLabelsBecomeSurfacesIsChosen() {
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

void ObjectsWindowTest::thatSegmentsOverlapIsTold() {
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

void ObjectsWindowTest::whatIsCancelledOpensNothing() {
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

void ObjectsWindowTest::whatIsNoLabelMapIsToldAndAsksNothing() {
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

void ObjectsWindowTest::whatIsBetteredIsChosenAndTold() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  window->viewState().setCrosshair(kLeft);
  QTest::keyClick(window.get(), Qt::Key_Return);
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  window->showStep(Command::stepExport);
  auto* choice = qobject_cast<QCheckBox*>(buttonSaying(*window, "Better thin triangles"));
  QVERIFY(choice && choice->isVisible() && choice->isChecked());
  ui::Document& document = window->document();
  QTest::mouseClick(choice, Qt::LeftButton, {}, QPoint(8, choice->height() / 2));
  QVERIFY(!document.polishes());
  document.setPolishes(true);
  QVERIFY(choice->isChecked());
  // A cut leaves thin triangles at its rim.
  QSignalSpy edited(&document, &ui::Document::meshEdited);
  MeshEdit cut{0, MeshEditKind::cut, kLeft + Vec3(0.3, 0.2, 1.7)};
  cut.vector = Vec3(1, 2, 9);
  cut.keep = KeptSide::negative;
  document.editMesh(cut);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QSignalSpy exported(&document, &ui::Document::exported), polished(&document, &ui::Document::polished);
  document.exportResult(folder.filePath("cut.stl"), CoordinateSpace::lps);
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QCOMPARE(polished.size(), 1);
  QVERIFY(shownText(*window, "What was bettered").contains("Polished"));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  ObjectsWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "objects_window_test.moc"
