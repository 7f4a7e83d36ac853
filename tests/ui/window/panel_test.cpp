// What the panels say in the states that are seldom seen: warnings, a surface that is gone, nothing known
// yet.

#include <QProgressBar>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QTableWidget>
#include <QUndoStack>

#include "core/io/formats/volume_io.h"
#include "tests/ui/dumbbell.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/seed/object_choice.h"
#include "ui/window/steps_panel.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/timeline/timeline_plot.h"
#include "ui/window/widgets/numbers.h"

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

//! Dark, of a radius of 8 voxels.
QString writeBall(const QTemporaryDir& folder, const Grid& grid) {
  const QString path = folder.filePath("ball.nii.gz");
  const auto intensity = [](int i, int j, int k) { return (Vec3(i, j, k) - kMiddle).norm() < 8 ? 0 : 100; };
  writeVolume(testing::volumeByIndex(grid, intensity), path.toStdString());
  return path;
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

}  // namespace

class PanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void warningsAreShownOfASurfaceAtRestAndOnlyThen();
  void theSampleHasNoWarnings();
  void aSurfaceThatIsGoneIsSaidToBeGone();
  void whatCannotGrowIsNotSaidToBeReady();
  void itIsSeenThatTheImageIsPrepared();
  void aNumberThatIsNotKnownIsADash();
  void lengthsOfTinyAndOfHugeVoxelsAreShownAndCanBeEntered();
  void anEventIsNotInspectedWhileTheSurfaceGrows();
  void whatAnEventDidCanBeForbiddenAndAllowedAgain();
  void onlyChangesOfTopologyAreListedUntilMoreIsAsked();
  void aClickOutsideIsListedAsOneAndIsNoSeedToGrowFrom();
  void aRangeOfSmallIntensitiesIsShownAndEntered();
  void smallVolumesAndDistancesKeepTheirDigits();
  void theObjectThatIsTakenAndTheWaysFromItAreSaidWithTheirVolumes();
  void withoutAChoiceNothingJumps();
  void bracketsStepThroughTheObjectsBySize();
  void thePlotsLegendIsNotWrittenOverItself();
};

void PanelTest::warningsAreShownOfASurfaceAtRestAndOnlyThen() {
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
  QVERIFY(!window->document().snapshot()->warnings.empty());
  const QString shown = shownText(*window, "Doubts about the surface");
  QVERIFY2(shown.contains("Worth a look") && shown.contains("no edge"), qPrintable(shown));
  QVERIFY(!shown.contains("--"));  // no options of the command line

  QTest::keyClick(window.get(), Qt::Key_Comma);  // on the way there are no warnings
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() < window->document().lastIteration(); },
                          kPatience));
  QVERIFY(shownText(*window, "Doubts about the surface").isEmpty());
}

void PanelTest::theSampleHasNoWarnings() {
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

void PanelTest::whatCannotGrowIsNotSaidToBeReady() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  window->showStep(Command::stepGrow);
  QCOMPARE(shownText(*window, "State of the growth"), QString("Ready to grow"));
  QCOMPARE(shownText(*window, "Why it did not grow"), QString());
  window->document().moveSeed(0, Vec3(1000, 0, 0));
  window->document().run();
  QVERIFY(waitFor(*window, GrowthState::none));
  QCOMPARE(shownText(*window, "State of the growth"), QString("Nothing grew"));
  QVERIFY(shownText(*window, "Why it did not grow").contains("outside the volume"));
  window->document().undoStack()->undo();
  QTRY_COMPARE(shownText(*window, "State of the growth"), QString("Ready to grow"));
}

void PanelTest::itIsSeenThatTheImageIsPrepared() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  const auto* progress = window->statusBar()->findChild<QProgressBar*>();
  QVERIFY(progress && !progress->isVisible());
  window->document().run();
  QVERIFY(window->document().state() == GrowthState::preparing);
  QVERIFY(progress->isVisible() && progress->maximum() == 0);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(!progress->isVisible());
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

void PanelTest::lengthsOfTinyAndOfHugeVoxelsAreShownAndCanBeEntered() {
  for (const double voxel : {0.002, 2000.0}) {  // mm
    const QTemporaryDir folder;
    Grid grid = testing::cubicGrid(41);
    grid.spacing = Vec3::Constant(voxel);
    auto window = shownWindow();
    QVERIFY(window && open(*window, writeBall(folder, grid)));
    window->document().addSeed({voxel * kMiddle, {}});
    window->document().selectSeed(0);
    QVERIFY(QTest::qWaitFor([&] { return window->document().resolved().has_value(); }, kPatience));
    const auto shows = [&](const char* name, double mm) {
      return std::abs(numberField(*window, name)->value() - mm) < 0.05 * mm;
    };
    const double edge = window->document().resolved()->edgeLength;
    QVERIFY(shows("Edge length", edge));
    QVERIFY(shows("Radius", window->document().shownRadius(0)));
    numberField(*window, "Edge length")->setValue(1.5 * edge);
    QVERIFY(shows("Edge length", 1.5 * edge));
    QVERIFY(window->document().parameters().edgeLength.has_value());
    QVERIFY(ui::place(voxel * kMiddle, grid) != ui::place(voxel * (kMiddle + Vec3(1, 0, 0)), grid));
  }
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

void PanelTest::whatAnEventDidCanBeForbiddenAndAllowedAgain() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  ui::Document& document = window->document();
  const auto genus = [&] { return document.snapshot()->certificate.genus.at(0); };
  const auto isShown = [&](int iteration) {
    return QTest::qWaitFor([&] { return document.iteration() == iteration; }, kPatience);
  };
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QCOMPARE(genus(), 1);
  window->showStep(Command::stepGrow);
  const int iteration = document.events().at(static_cast<std::size_t>(firstHandle(document))).iteration;
  document.goTo(iteration);
  QVERIFY(isShown(iteration));
  QAbstractButton* forbid = buttonSaying(*window, "Keep apart here");
  QVERIFY(forbid && forbid->isVisible());
  forbid->click();
  QVERIFY(isShown(iteration - 1));
  QVERIFY(!forbid->isVisible());
  document.run();
  QVERIFY(waitFor(*window, GrowthState::finished));
  QCOMPARE(genus(), 0);

  document.goTo(iteration);
  QVERIFY(isShown(iteration));
  QVERIFY(QTest::qWaitFor([&] { return buttonSaying(*window, "Let it happen")->isVisible(); }, kPatience));
  QAbstractButton* allow = buttonSaying(*window, "Let it happen");
  QVERIFY(allow->isVisible());
  allow->click();
  QVERIFY(document.constraints().empty());
  document.run();
  QVERIFY(waitFor(*window, GrowthState::finished));
  QCOMPARE(genus(), 1);
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
  QAbstractButton* repairs = buttonSaying(*window, "repairs");
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

void PanelTest::aClickOutsideIsListedAsOneAndIsNoSeedToGrowFrom() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  const auto& commands = window->commands();
  QVERIFY(commands[Command::addOutside]->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_Return, Qt::ShiftModifier);
  QCOMPARE(window->document().seeds().size(), std::size_t{1});
  QVERIFY(window->document().seeds()[0].background);
  for (Command id : {Command::run, Command::stepForward, Command::nextEvent})
    QVERIFY(!commands[id]->isEnabled());
  for (Command id : {Command::deleteSeed, Command::growSeed, Command::nextSeed})
    QVERIFY(commands[id]->isEnabled());
  window->showStep(Command::stepGrow);
  QCOMPARE(shownText(*window, "State of the growth"), QString("No seed yet"));

  window->showStep(Command::stepSeed);
  QCOMPARE(shownText(*window, "Which object is taken"), QString("None yet: it takes a seed inside."));
  QTest::keyClick(window.get(), Qt::Key_Return);
  QCOMPARE(window->document().seeds().size(), std::size_t{1});  // it would contradict the first
  window->viewState().setCrosshair(window->viewState().crosshair() + Vec3(0, 0, 5));
  QTest::keyClick(window.get(), Qt::Key_Return);
  const QTableWidget* table = nullptr;
  const auto tables = window->findChildren<QTableWidget*>();
  for (const QTableWidget* t : tables)
    if (t->accessibleName() == QString("Seeds")) table = t;
  QVERIFY(table && table->isVisible() && table->rowCount() == 2);
  QCOMPARE(table->item(0, 2)->text(), QString("outside"));
  QCOMPARE(table->item(1, 2)->text(), QString("inside"));
  QVERIFY(commands[Command::run]->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!commands[Command::run]->isEnabled());
  QVERIFY2(commands[Command::undo]->text().contains("Add click outside"),
           qPrintable(commands[Command::undo]->text()));
}

void PanelTest::aRangeOfSmallIntensitiesIsShownAndEntered() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("small.nii.gz");
  const auto intensity = [](int i, int j, int k) { return 1e-5 * (i + 0.1 * j + 0.01 * k); };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(24), intensity), path.toStdString());
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  ui::Document& document = window->document();
  Parameters parameters = document.parameters();
  parameters.range = IntensityRange{2e-5, 6e-5};
  document.setParameters(parameters, QStringLiteral("Change range"));
  QDoubleSpinBox* high = numberField(*window, "Highest intensity of the object");
  QVERIFY(high);
  QTRY_COMPARE(high->value(), 6e-5);                 // the intensities are counted on a thread of their own
  QCOMPARE(document.parameters().range->low, 2e-5);  // nothing was rounded by that
  high->setValue(7e-5);
  QCOMPARE(document.parameters().range->high, 7e-5);
  high->stepUp();
  QVERIFY(document.parameters().range->high > 7e-5 && document.parameters().range->high < 8e-5);
}

void PanelTest::smallVolumesAndDistancesKeepTheirDigits() {
  QCOMPARE(ui::fineNumber(12.346), QString("12.35"));
  QCOMPARE(ui::fineNumber(0.00012346), QString("0.0001235"));
  QCOMPARE(ui::fineNumber(0.0012346, 2), QString("0.0012"));  // a deviation
  QCOMPARE(ui::fineNumber(1.26e-7), QString("0.0000001"));
  QCOMPARE(ui::fineNumber(1e-12), QString("0.0000"));  // no row of noughts
  QCOMPARE(ui::fineNumber(0), ui::number(0));
  QCOMPARE(ui::millimetres(0.0012346), QString("0.00123 mm"));
  QCOMPARE(ui::millilitres(0.000012346), QString("0.0000123 mm³"));
}

void PanelTest::theObjectThatIsTakenAndTheWaysFromItAreSaidWithTheirVolumes() {
  QUndoStack undo;
  ui::Commands commands(&undo, nullptr);
  ui::ObjectChoice panel(commands);
  panel.show();
  ui::CandidateChoice choice;
  choice.candidates.resize(3);
  const double volumes[] = {12'340, 41'000, 3'100};  // mm³
  for (std::size_t i = 0; i < 3; ++i) choice.candidates[i].volume = volumes[i];
  choice.chosen = 1;
  panel.showChoice(choice, QString());
  const auto texts = [&] {
    QStringList all;
    const auto labels = panel.findChildren<QLabel*>();
    for (const QLabel* label : labels)
      if (!label->accessibleName().isEmpty() && label->isVisible()) all << label->text();
    const auto buttons = panel.findChildren<QAbstractButton*>();
    for (const QAbstractButton* button : buttons) all << button->text();
    return all;
  };
  QCOMPARE(texts(),
           QStringList({"2 of 3 by size: 12.3 ml (likeliest)", "Smaller: 3.10 ml", "Larger: 41.0 ml"}));
  choice.isClose = true;
  choice.chosen = 2;
  panel.showChoice(choice, QString());
  QCOMPARE(texts(), QStringList({"3 of 3 by size: 41.0 ml", "A close choice: look at the others, too.",
                                 "Smaller: 12.3 ml", "Larger"}));
  choice.candidates.resize(1);
  choice.chosen = 1;
  panel.showChoice(choice, QString());  // of one there is none close to it
  QCOMPARE(texts(), QStringList({"The only one: 12.3 ml", "Smaller", "Larger"}));
  panel.showChoice({}, QString("Looking."));
  QCOMPARE(texts(), QStringList({"Looking.", "Smaller", "Larger"}));
}

void PanelTest::withoutAChoiceNothingJumps() {
  constexpr int kPanelWidth = 290;  // pixels, without the panel's margins
  QUndoStack undo;
  ui::Commands commands(&undo, nullptr);
  ui::ObjectChoice panel(commands);
  panel.showChoice({}, QString("Looking."));
  const int height = panel.heightForWidth(kPanelWidth);
  ui::CandidateChoice choice;
  choice.candidates.resize(2);
  choice.chosen = 1;
  choice.isClose = true;
  for (ObjectCandidate& candidate : choice.candidates) candidate.volume = 1'234'000;
  panel.showChoice(choice, QString());
  QCOMPARE(panel.heightForWidth(kPanelWidth), height);

  auto window = shownWindow();  // nothing is open: the commands are there, and cannot be given
  QVERIFY(window);
  for (Command id : {Command::smallerObject, Command::largerObject, Command::addOutside})
    QVERIFY(!window->commands()[id]->isEnabled());
}

void PanelTest::bracketsStepThroughTheObjectsBySize() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("dumbbell.nii.gz");
  writeVolume(testing::dumbbellVolume(), path.toStdString());
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  ui::Document& document = window->document();
  document.addSeed({testing::kLeftBall, {}});
  QVERIFY(QTest::qWaitFor([&] { return document.resolved().has_value(); }, kPatience));
  const int count = static_cast<int>(document.candidateChoice().candidates.size());
  QAction *smaller = window->commands()[Command::smallerObject],
          *larger = window->commands()[Command::largerObject];
  const auto place = [&] { return ui::placeBySize(document.candidateChoice()); };
  for (int at = place(); at < count; ++at) {
    QVERIFY(larger->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_BracketRight);
    QCOMPARE(place(), at + 1);
  }
  QVERIFY(!larger->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_BracketRight);
  QCOMPARE(place(), count);
  for (int at = count; at > 1; --at) {
    QVERIFY(smaller->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_BracketLeft);
    QCOMPARE(place(), at - 1);
  }
  QVERIFY(!smaller->isEnabled() && larger->isEnabled());
  QVERIFY(window->commands()[Command::undo]->text().contains("Smaller object"));
  window->showStep(Command::stepSeed);
  const QString shown = shownText(*window, "Which object is taken");
  QVERIFY2(shown.startsWith(QString("1 of %1 by size").arg(count)), qPrintable(shown));
  QVERIFY(QTest::qWaitFor([&] { return document.resolved().has_value(); }, kPatience));
  QCOMPARE(place(), 1);
  QVERIFY(!smaller->isEnabled() && larger->isEnabled());
}

void PanelTest::thePlotsLegendIsNotWrittenOverItself() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QTest::keyClick(window.get(), Qt::Key_Period);
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() == 1; }, kPatience));
  double most = 0;
  for (const ui::IterationSummary& s : window->document().summaries()) most = std::max(most, s.volume);
  ui::TimelinePlot plot(window->document());
  const QString first = ui::TimelinePlot::tr("Volume, up to %1").arg(ui::millilitres(most));
  const int end = ui::TimelineAxis::kMargin + 18 + plot.fontMetrics().horizontalAdvance(first);
  //! Where the colour of the second entry begins; the width if it is left out.
  const auto second = [&](int width) {
    plot.resize(width, 110);
    const QImage image = plot.grab().toImage();
    int x = 0;
    while (x < image.width() && image.pixelColor(x, 9) != QColor(0xE0, 0x8A, 0x1E)) ++x;
    return x;
  };
  QVERIFY(second(800) > 400 && second(800) < 800);
  for (int width = 160; width < 400; width += 10)
    QVERIFY2(second(width) >= std::min(width, end), qPrintable(first));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  PanelTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "panel_test.moc"
