// What step 6 writes of several objects.

#include <QCheckBox>
#include <QComboBox>
#include <algorithm>
#include <set>

#include "tests/ui/window/two_balls.h"
#include "ui/window/export/export_panel.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

std::vector<int> valuesOf(const QString& path) {
  const Volume map = readVolume(path.toStdString());
  std::vector<int> values;
  visitVoxels(map, [&](const auto* voxels) {
    for (std::size_t i = 0; i < map.grid.voxelCount(); ++i) values.push_back(static_cast<int>(voxels[i]));
  });
  return values;
}

}  // namespace

class ExportedObjectsWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void allAreExportedTogether();
  void eachIsExportedAlone();
  void whatIsBetteredIsChosenAndTold();
};

void ExportedObjectsWindowTest::allAreExportedTogether() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  QVERIFY(panel->which() == ui::ExportPanel::Objects::together);
  const QLabel* numbers = shownLabel(*window, "What is written");
  QVERIFY(numbers && numbers->text().contains("2"));
  QSignalSpy exported(&window->document(), &ui::Document::exported);
  const QString path = folder.filePath("all.nrrd");
  window->document().exportObjects(path, panel->space());
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  const std::vector<int> values = valuesOf(path);
  QCOMPARE(std::set<int>(values.begin(), values.end()), (std::set<int>{0, 1, 2}));
}

//! What each file of its own holds together is what the file of all of them does.
void ExportedObjectsWindowTest::eachIsExportedAlone() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  auto* choice = called<QComboBox>(*panel, "Objects");
  QVERIFY(choice && choice->isVisible());
  choice->setCurrentText("Each object in a file of its own");
  QVERIFY(panel->which() == ui::ExportPanel::Objects::each);
  QVERIFY(shownLabel(*window, "What is written")->text().contains("2"));
  ui::Document& document = window->document();
  const QStringList paths = document.objectPaths(folder.filePath("alone.nrrd"), ".nrrd", false);
  QCOMPARE(paths.size(), 2);
  QSignalSpy exported(&document, &ui::Document::exported);
  document.exportEachObject(folder.filePath("alone.nrrd"), ".nrrd", panel->space());
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QCOMPARE(exported.first().first().toString(), folder.filePath("alone_*.nrrd"));
  document.exportObjects(folder.filePath("all.nrrd"), panel->space());
  QVERIFY(exported.count() == 2 || exported.wait(kPatience));
  const std::vector<int> all = valuesOf(folder.filePath("all.nrrd")), first = valuesOf(paths[0]),
                         second = valuesOf(paths[1]);
  QVERIFY(std::count(first.begin(), first.end(), 1) > 0 && std::count(second.begin(), second.end(), 2) > 0);
  for (std::size_t i = 0; i < all.size(); ++i) QCOMPARE(all[i], first[i] + second[i]);
}

void ExportedObjectsWindowTest::whatIsBetteredIsChosenAndTold() {
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
  ExportedObjectsWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "exported_objects_window_test.moc"
