// What the step Open says of volumes that lack something, and of series.

#include <QFile>

#include "tests/ui/window/window_support.h"
#include "ui/model/finding_text.h"
#include "ui/window/open/series_list.h"
#include "ui/window/widgets/sentences.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;

class OpenPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anUncalibratedVolumeIsOpenedAgainWithTheSpacingThatIsEntered();
  void aCalibratedVolumeAsksForNoSpacing();
  void whatIsOpenIsStillToldWhileAnotherFileAsksForItsSpacing();
  void aSeriesSaysWhatItHoldsAndOnlyVolumesCanBeChosen();
  void aSeriesWithoutAUidCanBeChosen();
  void warningsNameFieldsInTheirPlaceOfOptions();
  void warningsNameStacksAsTheListDoes();
  void thatLengthsMeanNothingIsSaidFirst();
};

void OpenPanelTest::anUncalibratedVolumeIsOpenedAgainWithTheSpacingThatIsEntered() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("nowhere.nrrd");
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n");
  for (int i = 0; i < 512; ++i) file.putChar(static_cast<char>(i % 100));
  file.close();
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  QVERIFY(!window->document().info().calibrated);
  window->showStep(Command::stepOpen);
  const QString warnings = shownText(*window, "Warnings");
  QVERIFY(warnings.contains("step 1, Open") && !warnings.contains("--spacing"));
  QVERIFY(shownLabel(*window, "Uncalibrated"));
  const char* const names[] = {"Spacing of columns", "Spacing of rows", "Spacing of slices"};
  const char* const values[] = {"0.5", "0.25", "2.125"};
  for (int axis = 0; axis < 3; ++axis) {
    auto* field = const_cast<QDoubleSpinBox*>(numberField(*window, names[axis]));
    QVERIFY2(field && field->isVisible() && field->suffix() == " mm", names[axis]);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, values[axis]);
  }
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  QTest::mouseClick(buttonSaying(*window, "Open with this spacing"), Qt::LeftButton);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QVERIFY(window->document().volume().grid.spacing == Vec3(0.5, 0.25, 2.125));
  QVERIFY(window->document().info().calibrated);
  QVERIFY(!shownLabel(*window, "Uncalibrated"));
}

void OpenPanelTest::aCalibratedVolumeAsksForNoSpacing() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->showStep(Command::stepOpen);
  const QDoubleSpinBox* field = numberField(*window, "Spacing of rows");
  QVERIFY(field && !field->isVisible());
}

void OpenPanelTest::whatIsOpenIsStillToldWhileAnotherFileAsksForItsSpacing() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->showStep(Command::stepOpen);
  const QString format = shownText(*window, "Format");
  QVERIFY(!format.isEmpty());
  Q_EMIT window->files().spacingNeeded(QStringLiteral("/somewhere/cine.dcm"), {});
  QCOMPARE(shownText(*window, "File without a spacing"), QString("cine.dcm"));
  QCOMPARE(shownText(*window, "Format"), format);
}

void OpenPanelTest::aSeriesSaysWhatItHoldsAndOnlyVolumesCanBeChosen() {
  const std::string ct("CT");
  SeriesInfo scout, thorax;
  scout.uid = "1.2.3";
  scout.modality = ct;
  thorax.modality = ct;
  scout.description = "Scout";
  scout.note = Finding(FindingKind::noVolume, {}, FindingKind::singleSlice);
  scout.slices = 1;
  thorax.uid = "1.2.4";
  thorax.description = "CT Thorax";
  thorax.size = {512, 512, 300};
  thorax.slices = 600;
  thorax.frames = 2;
  thorax.spacing = Vec3(0.7, 0.7, 1.5);
  QCOMPARE(
      ui::linesOf(scout),
      QStringList({"CT Scout",
                   "No volume: this is a single slice, a 2D image; give the folder with the whole series.",
                   "Slices: 1"}));
  QCOMPARE(ui::linesOf(thorax), QStringList({"CT Thorax", "512 × 512 × 300, 0.70 × 0.70 × 1.50 mm",
                                             "Slices: 600 · time points: 2"}));
  ui::SeriesList list;
  list.offer({scout, thorax});
  QCOMPARE(list.chosen().value_or("none"), QString("1.2.4"));
  QVERIFY(list.sizeHintForRow(0) >= 3 * list.fontMetrics().lineSpacing() + 8);  // and room above and below
  list.setCurrentRow(0);
  QVERIFY(!list.chosen());
}

void OpenPanelTest::aSeriesWithoutAUidCanBeChosen() {
  SeriesInfo nameless, other;
  other.uid = "1.2.3";
  nameless.slices = other.slices = 20;
  ui::SeriesList list;
  list.offer({nameless, other});
  QCOMPARE(list.chosen().value_or("none"), QString());
  list.offer({});
  QVERIFY(!list.chosen());
}

void OpenPanelTest::warningsNameFieldsInTheirPlaceOfOptions() {
  for (int k = 0; k < kFindingKinds; ++k) {
    const auto kind = static_cast<FindingKind>(k);
    const QString text = ui::findingText(kind), english = QString::fromStdString(sentence(kind));
    QVERIFY2(!text.contains("--") || text.contains("handlebody-cli"), qPrintable(text));
    QVERIFY2(!english.contains("--spacing") || text.contains("step 1, Open"), qPrintable(text));
  }
}

void OpenPanelTest::warningsNameStacksAsTheListDoes() {
  const auto stack = [](int number, int slices) {
    return Finding(FindingKind::stackOf,
                   {{"series", std::string("1.2.840.99")}, {"stack", number}, {"slices", slices}});
  };
  const Finding alone(FindingKind::stacksAlone, {}, std::vector<Finding>{stack(1, 14), stack(12, 3)});
  QCOMPARE(ui::findingSentence(alone),
           QString("Its stacks of one pitch each are to be had alone: stack 1 (14 slices), stack 12 (3 "
                   "slices)."));
}

void OpenPanelTest::thatLengthsMeanNothingIsSaidFirst() {
  VolumeInfo info;
  info.warnings = {FindingKind::fileNotDicomUnnamed, FindingKind::uncalibrated};
  QVERIFY(ui::mainWarning(info).startsWith("The volume is uncalibrated"));
  QVERIFY(ui::mainWarning(info).contains("More"));
  info.warnings = {FindingKind::uncalibrated};
  QCOMPARE(ui::mainWarning(info), ui::findingSentence(FindingKind::uncalibrated));
  // The bar of time shows it.
  info.warnings = {{FindingKind::frameZeroUsed, {{"frames", 3}}}};
  QVERIFY(ui::mainWarning(info).isEmpty());
  info.warnings.push_back(FindingKind::fileNotDicomUnnamed);
  QCOMPARE(ui::mainWarning(info), QString("1 file in the folder is not DICOM and left out."));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  OpenPanelTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "open_panel_test.moc"
