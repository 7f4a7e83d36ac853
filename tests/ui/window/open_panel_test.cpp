// What the step Open says of volumes that lack something, and of series.

#include <QFile>

#include "tests/ui/window/window_support.h"
#include "ui/window/sentences.h"
#include "ui/window/series_list.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;

class OpenPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anUncalibratedVolumeIsOpenedAgainWithTheSpacingThatIsEntered();
  void aCalibratedVolumeAsksForNoSpacing();
  void aSeriesSaysWhatItHoldsAndOnlyVolumesCanBeChosen();
  void aSeriesWithoutAUidCanBeChosen();
  void sentencesNameFieldsInTheirPlaceOfOptions();
  void sentencesNameStacksAsTheListDoes();
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

void OpenPanelTest::aSeriesSaysWhatItHoldsAndOnlyVolumesCanBeChosen() {
  const std::string ct("CT");
  SeriesInfo scout, thorax;
  scout.uid = "1.2.3";
  scout.modality = ct;
  thorax.modality = ct;
  scout.description = "Scout";
  scout.note = "a single image is no volume";
  scout.slices = 1;
  thorax.uid = "1.2.4";
  thorax.description = "CT Thorax";
  thorax.size = {512, 512, 300};
  thorax.slices = 600;
  thorax.frames = 2;
  thorax.spacing = Vec3(0.7, 0.7, 1.5);
  QCOMPARE(ui::linesOf(scout),
           QStringList({"CT Scout", "No volume: a single image is no volume", "Slices: 1"}));
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

void OpenPanelTest::sentencesNameFieldsInTheirPlaceOfOptions() {
  const QString cine("this is a cine; if its frames are slices in space, give --spacing X,Y,Z");
  for (const QString& text : {cine, QString("lengths mean nothing until --spacing gives it."),
                              QString("or give --range, which holds nothing back")}) {
    QVERIFY2(!ui::inWordsOfWindow(text).contains("--"), qPrintable(text));
    QVERIFY(ui::inWordsOfWindow(text).contains("step"));
  }
}

void OpenPanelTest::sentencesNameStacksAsTheListDoes() {
  QCOMPARE(ui::inWordsOfWindow("to be had alone: 1.2.840.99#1 (14 slices), 1.2.840.99#12 (3 slices)."),
           QString("to be had alone: stack 1 (14 slices), stack 12 (3 slices)."));
  QCOMPARE(ui::inWordsOfWindow("/a/scan#2.nii: no volume, 1.5 mm"),
           QString("/a/scan#2.nii: no volume, 1.5 mm"));
}

void OpenPanelTest::thatLengthsMeanNothingIsSaidFirst() {
  VolumeInfo info;
  info.warnings = {"One file is left out.", "The volume is uncalibrated: 1 mm is assumed."};
  QVERIFY(ui::mainWarning(info).startsWith("One file"));
  info.calibrated = false;
  QVERIFY(ui::mainWarning(info).startsWith("The volume is uncalibrated"));
  QVERIFY(ui::mainWarning(info).contains("More"));
  info.warnings = {"The volume is uncalibrated."};
  QCOMPARE(ui::mainWarning(info), QString("The volume is uncalibrated."));
  // The bar of time shows it.
  info.warnings = {"There are 3 time points; frame 0 is used (--frame chooses another)."};
  QVERIFY(ui::mainWarning(info).isEmpty());
  info.warnings.push_back("One file is left out.");
  QCOMPARE(ui::mainWarning(info), QString("One file is left out."));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  OpenPanelTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "open_panel_test.moc"
