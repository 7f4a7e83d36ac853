// The list of objects in the window: by mouse and keys, drawn, exported, and out of the way with one object.

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <set>

#include "core/collision/body_contact.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/objects/object_dialog.h"
#include "ui/window/objects/objects_panel.h"

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
  void allAreExportedTogether();
  void aDroppedMeshIsAskedAboutAndBecomesAnObject();
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

//! Answers the question that is asked next by the button of this text.
void answerNext(const char* text) {
  QTimer::singleShot(0, [text] {
    QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(question != nullptr);
    const auto buttons = question->buttons();
    for (QAbstractButton* button : buttons)
      if (button->text().contains(QLatin1String(text))) return QTest::mouseClick(button, Qt::LeftButton);
    question->reject();
  });
}

void ObjectsWindowTest::aDroppedMeshIsAskedAboutAndBecomesAnObject() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  const QString path = folder.filePath("old lesion.stl");
  writeMesh(icosphere(kRight, 4, 1.2), path.toStdString());
  QSignalSpy opened(&window->document(), &ui::Document::objectsOpened);
  answerNext("Done");
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);  // without it Qt drops the drop
  QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &drop);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().objectCount(), 2);
  QVERIFY(panelOf(*window)->isVisible());
  QCOMPARE(tableOf(*window)->item(0, 0)->text(), QString("old lesion"));
  QVERIFY(QTest::qWaitFor([&] { return window->document().objectInfo(0).snapshot != nullptr; }, kPatience));
  QVERIFY(window->document().objectInfo(0).locked);
  QVERIFY(window->findChild<ui::MessageBar*>()->isVisible());
  QCOMPARE(window->document().undoStack()->undoText(), QString("Open object"));
  answerNext("grow from");
  window->files().openObjects(path);
  QVERIFY(QTest::qWaitFor([&] { return opened.size() == 2; }, kPatience));
  QCOMPARE(window->document().objectCount(), 3);
  QCOMPARE(window->document().activeObject(), 2);
  answerNext("Cancel");
  window->files().openObjects(path);
  QCOMPARE(window->document().objectCount(), 3);
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
