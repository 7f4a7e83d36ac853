// What the panels say in the states that are seldom seen: doubts, a surface that is gone, nothing known yet.

#include <QSpinBox>
#include <QTableView>

#include "core/io/volume_io.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/event_inspector.h"
#include "ui/window/steps_panel.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

const Vec3 kMiddle(20, 20, 20);

//! Gets brighter from its middle, slowly: no intensity in it is an edge.
QString writeRamp(const QTemporaryDir& folder) {
  const QString path = folder.filePath("ramp.nii.gz");
  const Volume volume = testing::volumeByIndex(
      testing::cubicGrid(41), [](int i, int j, int k) { return 4 * (Vec3(i, j, k) - kMiddle).norm(); });
  writeVolume(volume, path.toStdString());
  return path;
}

QString shownText(ui::MainWindow& window, const char* name) {
  const QLabel* label = shownLabel(window, QString::fromLatin1(name));
  return label ? label->text() : QString();
}

//! The seed ball shrinks to a point.
bool shrinkAway(ui::MainWindow& window) {
  Parameters p = window.document().parameters();
  p.direction = Direction::both;
  p.balloon = 0.01;
  p.curvature = 1;  // hardly anything but curvature
  window.document().setParameters(p, QStringLiteral("Shrink"));
  QTest::keyClick(&window, Qt::Key_Space);
  return waitFor(window, GrowthState::finished);
}

const QDoubleSpinBox* numberField(ui::MainWindow& window, const QString& name) {
  const auto fields = window.findChildren<QDoubleSpinBox*>();
  for (const QDoubleSpinBox* field : fields)
    if (field->accessibleName() == name) return field;
  return nullptr;
}

}  // namespace

class PanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void doubtsAreShownOfASurfaceAtRestAndOnlyThen();
  void nothingIsDoubtedOfTheSample();
  void aSurfaceThatIsGoneIsSaidToBeGone();
  void aNumberThatIsNotKnownIsADash();
  void anEventIsNotInspectedWhileTheSurfaceGrows();
  void onlyChangesOfTopologyAreListedUntilMoreIsAsked();
};

void PanelTest::doubtsAreShownOfASurfaceAtRestAndOnlyThen() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeRamp(folder)));
  window->document().addSeed({kMiddle, 4});
  Parameters p;
  p.object = ObjectKind::dark;
  p.range = IntensityRange{-std::numeric_limits<double>::infinity(), 60};  // a ball of 15 mm
  window->document().setParameters(p, QStringLiteral("Change range"));
  QTest::keyClick(window.get(), Qt::Key_Period);
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() == 1; }, kPatience));
  window->showStep(Command::stepGrow);
  QVERIFY(shownText(*window, "Doubts about the surface").isEmpty());

  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(!window->document().snapshot()->doubts.empty());
  const QString shown = shownText(*window, "Doubts about the surface");
  QVERIFY2(shown.contains("Worth a look") && shown.contains("no edge"), qPrintable(shown));
  QVERIFY(!shown.contains("--"));  // no options of the command line

  QTest::keyClick(window.get(), Qt::Key_Comma);  // on the way nothing is doubted
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() < window->document().lastIteration(); },
                          kPatience));
  QVERIFY(shownText(*window, "Doubts about the surface").isEmpty());
}

void PanelTest::nothingIsDoubtedOfTheSample() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(shownText(*window, "Doubts about the surface").isEmpty());
}

void PanelTest::aSurfaceThatIsGoneIsSaidToBeGone() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QVERIFY(shrinkAway(*window));
  QVERIFY(window->document().snapshot()->mesh.triangles.empty());
  QCOMPARE(shownText(*window, "Certificate"), QString("Nothing is left of the surface"));
  QCOMPARE(shownText(*window, "Volume"), QString("–"));
  QCOMPARE(shownText(*window, "Genus"), QString("–"));
  QVERIFY(shownText(*window, "State of the growth").contains("nothing is left"));
  QVERIFY(!window->commands()[Command::exportResult]->isEnabled());
  window->showStep(Command::stepExport);
  QVERIFY(shownText(*window, "What is written").contains("Nothing is left"));

  QTest::keyClick(window.get(), Qt::Key_Home, Qt::ControlModifier);  // and the way back is open
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() == 0; }, kPatience));
  window->showStep(Command::stepGrow);
  QVERIFY(shownText(*window, "Certificate").startsWith(QString("✓")));
  QVERIFY(window->commands()[Command::exportResult]->isEnabled());
}

void PanelTest::aNumberThatIsNotKnownIsADash() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  for (const char* name : {"Radius", "Smoothing", "Edge length"}) {
    const QDoubleSpinBox* field = numberField(*window, name);
    QVERIFY2(field && field->text() == QString("–"), name);
  }
  window->document().addSeed({Vec3(77, 49, 85), {}});
  window->document().selectSeed(0);
  QVERIFY(QTest::qWaitFor([&] { return window->document().resolved().has_value(); }, kPatience));
  for (const char* name : {"Radius", "Smoothing", "Edge length"})
    QVERIFY2(numberField(*window, name)->text().endsWith(" mm"), name);
  window->document().removeSeed(0);
  QCOMPARE(numberField(*window, "Radius")->text(), QString("–"));
}

void PanelTest::anEventIsNotInspectedWhileTheSurfaceGrows() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  bool seen = false;
  connect(&window->document(), &ui::Document::snapshotChanged, window.get(), [&] {
    seen = seen || (window->document().state() == GrowthState::running && window->inspector().isVisible());
  });
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(!seen);
  QTest::keyClick(window.get(), Qt::Key_P);  // but it is when one goes there
  QTRY_VERIFY(window->inspector().isVisible());
}

void PanelTest::onlyChangesOfTopologyAreListedUntilMoreIsAsked() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  const QTableView* table = nullptr;
  const auto tables = window->findChildren<QTableView*>();
  for (const QTableView* t : tables)
    if (t->accessibleName() == "Events") table = t;
  QVERIFY(table && table->isVisible());
  QAbstractButton* repairs = nullptr;
  const auto buttons = window->findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons)
    if (button->text().contains("repairs")) repairs = button;
  QVERIFY(repairs && repairs->isVisible());
  int marks = 0, changes = 0;
  for (const auto& summary : window->document().summaries()) marks += summary.events;
  for (const Event& event : window->document().events())
    changes += event.kind != EventKind::smoothed && event.kind != EventKind::rolledBack;
  QCOMPARE(table->model()->rowCount(), changes);
  QCOMPARE(marks, changes);
  QTest::mouseClick(repairs, Qt::LeftButton, {}, QPoint(8, repairs->height() / 2));
  QCOMPARE(table->model()->rowCount(), static_cast<int>(window->document().events().size()));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  PanelTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "panel_test.moc"
