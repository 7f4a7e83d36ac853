// Time in the window by mouse and keys: the bar under the views, the surface carried on, the volume over
// time, a frame corrected; and the sensitivity at one button.

#include <QCheckBox>
#include <QMessageBox>
#include <QPushButton>
#include <QSemaphore>
#include <QTableWidget>
#include <QThreadPool>
#include <QTimer>

#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/time_window_support.h"
#include "ui/model/time_series.h"
#include "ui/view/distance_colours.h"
#include "ui/window/measures/measures_panel.h"
#include "ui/window/measures/sensitivity_page.h"
#include "ui/window/time/frame_slider.h"
#include "ui/window/time/over_time_panel.h"
#include "ui/window/time/volume_plot.h"
#include "ui/window/timeline/timeline_axis.h"
#include "ui/window/tune/histogram_view.h"
#include "ui/window/widgets/language.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

ui::FrameSlider* slider(ui::MainWindow& window) { return window.findChild<ui::FrameSlider*>(); }

bool shows(ui::MainWindow& window, int frame) {
  return QTest::qWaitFor([&] { return window.document().time().shownFrame() == frame; }, kPatience);
}

//! A window in which the heart has grown in frame 0.
std::unique_ptr<ui::MainWindow> grownWindow(const BeatingSample& sample) {
  auto window = shownWindow();
  if (!window || !open(*window, sample.session)) return nullptr;
  window->document().run();
  return waitFor(*window, GrowthState::finished) ? std::move(window) : nullptr;
}

//! Nothing that inBackground() is given begins while it lives.
class BusyPool {
 public:
  BusyPool() : threads_(pool_.maxThreadCount()) {
    pool_.setMaxThreadCount(1);
    pool_.start([this] { end_.acquire(); });
  }
  ~BusyPool() {
    end_.release();
    pool_.waitForDone();
    pool_.setMaxThreadCount(threads_);
  }
  BusyPool(const BusyPool&) = delete;
  BusyPool& operator=(const BusyPool&) = delete;

 private:
  QThreadPool& pool_ = *QThreadPool::globalInstance();
  const int threads_;
  QSemaphore end_;
};

bool carry(ui::MainWindow& window) {
  window.commands()[Command::carryOverTime]->trigger();
  return QTest::qWaitFor([&] { return !window.document().time().isCarrying(); }, kPatience) &&
         window.document().time().isComplete();
}

}  // namespace

class TimeWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(sample_.make()); }
  void theBarIsForVolumesWithTimeOnly();
  void mouseAndKeysGoThroughTime();
  void theTintIsOfTheFrameThatIsGrownInAlone();
  void theHistogramIsOfTheVolumeThatWasOpenedLast();
  void aClickInThePlotGoesToTheFrame();
  void aPartOfTheFramesIsNotExported();
  void whatWasCarriedFromAnEarlierStateIsToldToBeSo();
  void aFrameIsCorrectedAndTheRestIsCarriedAgain();
  void oneButtonTellsTheSensitivity();
  void growingHereAsksWhereAnotherObjectLosesItsSurface();
  void nothingTakesThePlaceOfWhatIsAskedAbout();
  void aFrameThatFailsIsToldInTheLanguageOfTheWindow();
  void nothingIsCutOffInAnyLanguage();

 private:
  BeatingSample sample_;
};

void TimeWindowTest::theBarIsForVolumesWithTimeOnly() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QVERIFY(!slider(*window)->isVisible());
  QVERIFY(!window->commands()[Command::playFrames]->isEnabled());
  QVERIFY(open(*window, sample_.volume));
  QVERIFY(slider(*window)->isVisible());
  QVERIFY(window->commands()[Command::playFrames]->isEnabled());
}

void TimeWindowTest::mouseAndKeysGoThroughTime() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample_.volume) && activate(*window));
  const QImage before = window->views().slice(ui::Plane::axial).picture();
  ui::FrameSlider* bar = slider(*window);
  const ui::TimelineAxis axis{bar->width(), bar->maximum()};
  QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(static_cast<int>(axis.toX(2)), bar->height() / 2));
  QVERIFY(shows(*window, 2));
  QVERIFY(window->views().slice(ui::Plane::axial).picture() != before);  // other voxels
  QVERIFY(shownText(*window, "Shown frame").contains("Frame 2"));
  QVERIFY(shownText(*window, "Shown frame").contains("ms"));
  QWidget& view = window->views().slice(ui::Plane::axial);
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Right, Qt::AltModifier);
  QVERIFY(shows(*window, 3));
  QTest::keyClick(&view, Qt::Key_T);
  QVERIFY(window->document().time().isPlaying());
  QVERIFY(shows(*window, 1));
  QTest::keyClick(&view, Qt::Key_T);
  QVERIFY(!window->document().time().isPlaying());
}

//! In another frame the object has moved.
void TimeWindowTest::theTintIsOfTheFrameThatIsGrownInAlone() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample_.session));
  QVERIFY(QTest::qWaitFor([&] { return window->document().resolved().has_value(); }, kPatience));
  const auto boxes = window->findChildren<QCheckBox*>();
  for (QCheckBox* box : boxes)
    if (box->text() == "Tint the object in the slices") box->setChecked(true);
  QVERIFY(window->viewState().tint());
  window->document().time().show(2);
  QVERIFY(shows(*window, 2));
  QVERIFY(!window->viewState().tint());
  window->document().time().show(0);
  QVERIFY(shows(*window, 0));
  QVERIFY(window->viewState().tint());
}

//! Also where another frame is shown when its intensities have been counted.
void TimeWindowTest::theHistogramIsOfTheVolumeThatWasOpenedLast() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  const auto* view = window->findChild<ui::HistogramView*>();
  QVERIFY(view);
  QTRY_VERIFY(!view->histogram().counts.empty());
  std::vector<double> counts;
  window->hide();  // Qt paints with the help of that pool, too
  {
    const BusyPool busy;
    QVERIFY(open(*window, sample_.volume));
    QVERIFY(view->histogram().counts.empty());
    counts = ui::histogramOf(window->document().volume()).counts;
    window->document().time().show(2);
    QVERIFY(shows(*window, 2));
  }
  QTRY_VERIFY(view->histogram().counts == counts);
}

void TimeWindowTest::aClickInThePlotGoesToTheFrame() {
  auto window = grownWindow(sample_);
  QVERIFY(window && carry(*window));
  ui::VolumePlot& plot = window->overTime().plot();
  QVERIFY(plot.isVisible());
  int x = 0;
  while (x < plot.width() && plot.frameAt(QPointF(x, 10)) != 3) ++x;
  QTest::mouseClick(&plot, Qt::LeftButton, {}, QPoint(x + 2, plot.height() / 2));
  QVERIFY(shows(*window, 3));
  QVERIFY(window->document().snapshot());
  QVERIFY(shownText(*window, "Figures over time").contains("ejection fraction"));
  const auto* table = window->overTime().findChild<QTableWidget*>();
  QCOMPARE(table->rowCount(), BeatingSample::kFrames);
  QVERIFY(table->item(3, 3)->text().contains("carried"));
}

void TimeWindowTest::aPartOfTheFramesIsNotExported() {
  auto window = grownWindow(sample_);
  QVERIFY(window);
  ui::TimeSeries& time = window->document().time();
  const auto cancelling = connect(&time, &ui::TimeSeries::carriedChanged, window.get(), [&time] {
    if (time.isCarrying() && time.carried().size() == 2) time.cancel();
  });
  const auto canExport = [&] {
    QList<bool> can{window->commands()[Command::exportFrameMeshes]->isEnabled(),
                    window->commands()[Command::exportFrameLabels]->isEnabled()};
    const auto buttons = window->overTime().findChildren<QPushButton*>();
    for (const QPushButton* button : buttons)
      if (button->text().startsWith("CSV") || button->text().startsWith("Plot")) can << button->isEnabled();
    return can;
  };
  QVERIFY(!carry(*window));
  QVERIFY(!time.isCarrying());
  QCOMPARE(time.carried().size(), std::size_t(2));
  QCOMPARE(canExport(), QList<bool>(4, false));
  QCOMPARE(shownText(*window, "State of what is carried"), window->document().framesFault());
  disconnect(cancelling);
  QVERIFY(carry(*window));
  QCOMPARE(canExport(), QList<bool>(4, true));
}

void TimeWindowTest::whatWasCarriedFromAnEarlierStateIsToldToBeSo() {
  auto window = grownWindow(sample_);
  QVERIFY(window && carry(*window));
  ui::Document& document = window->document();
  window->showStep(Command::stepGrow);
  document.time().show(3);
  QVERIFY(shows(*window, 3));
  const QString bar = "What is wrong with the shown frame", said = "carried from an earlier state of frame 0";
  QVERIFY(!shownText(*window, "Certificate").contains(said));
  QVERIFY(shownText(*window, "Volume").contains("ml"));  // ml
  document.time().show(0);
  QVERIFY(shows(*window, 0));
  document.goTo(document.lastIteration() - 1);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == document.lastIteration() - 1; }, kPatience));
  document.time().show(3);
  QVERIFY(shows(*window, 3));
  QVERIFY(shownText(*window, "Certificate").contains(said));
  QVERIFY(!shownText(*window, "Volume").contains("ml"));
  QVERIFY(shownLabel(*window, bar)->toolTip().contains(said));  // the text itself may be elided
}

void TimeWindowTest::aFrameIsCorrectedAndTheRestIsCarriedAgain() {
  auto window = grownWindow(sample_);
  QVERIFY(window && carry(*window));
  ui::Document& document = window->document();
  const double before = document.time().resultOf(1)->volume, beyond = document.time().resultOf(2)->volume;
  const double other = document.time().resultOf(4)->volume;
  document.time().show(2);
  QVERIFY(shows(*window, 2));
  window->commands()[Command::correctFrame]->trigger();
  QCOMPARE(document.correctedFrame().value_or(-1), 2);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QVERIFY(std::abs(document.snapshot()->certificate.volume / beyond - 1) < 1e-3);  // as it was carried
  // A wall over its tip takes a part of it away: it is pushed out of that.
  QVERIFY(document.paintWalls({{sample_.seed + Vec3(0, 0, 36), 10}}));
  QVERIFY(QTest::qWaitFor([&] { return document.wallConflict().has_value(); }, 10'000));
  window->commands()[Command::run]->trigger();
  QVERIFY(waitFor(*window, GrowthState::finished));
  window->commands()[Command::endCorrection]->trigger();
  QVERIFY(!document.correctedFrame());
  QVERIFY(QTest::qWaitFor([&] { return !document.time().isCarrying(); }, kPatience));
  QVERIFY(document.time().resultOf(2)->volume < beyond);
  QCOMPARE(document.time().resultOf(1)->volume, before);
  QVERIFY(document.time().resultOf(4)->volume != other);  // it has the wall, too
  QCOMPARE(document.time().request().corrections.size(), std::size_t(1));
}

void TimeWindowTest::oneButtonTellsTheSensitivity() {
  auto window = grownWindow(sample_);
  QVERIFY(window);
  window->commands()[Command::sensitivity]->trigger();
  ui::SensitivityPage& page = window->measures().sensitivity();
  QVERIFY(page.isVisible() && page.isAsking());
  QVERIFY(QTest::qWaitFor([&] { return !page.isAsking(); }, kPatience));
  QVERIFY(page.shown() && page.shown()->grown > 0);
  QVERIFY(shownText(*window, "Volume with its spread").contains(QChar(0xB1)));
  QVERIFY(window->viewState().distances() != nullptr);
  QVERIFY(!window->viewState().distances()->isSigned);
}

void TimeWindowTest::growingHereAsksWhereAnotherObjectLosesItsSurface() {
  auto window = grownWindow(sample_);
  QVERIFY(window);
  ui::Document& document = window->document();
  document.addObject();
  document.time().show(2);
  QVERIFY(shows(*window, 2));
  const auto answer = [&](QMessageBox::StandardButton button) {
    QString asked;
    QTimer::singleShot(200, window.get(), [&asked, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      asked = box->text();
      box->button(button)->click();
    });
    window->commands()[Command::growHere]->trigger();
    return asked;
  };
  const QString name = QString::fromStdString(document.objectInfo(0).label.name);
  QVERIFY(answer(QMessageBox::No).contains(name));
  QCOMPARE(document.time().grownFrame(), 0);
  QVERIFY(answer(QMessageBox::Yes).contains(name));
  QCOMPARE(document.time().grownFrame(), 2);
}

void TimeWindowTest::nothingTakesThePlaceOfWhatIsAskedAbout() {
  auto window = grownWindow(sample_);
  QVERIFY(window);
  ui::Document& document = window->document();
  document.addObject();
  document.time().show(2);
  QVERIFY(shows(*window, 2));
  QSignalSpy opened(&document, &ui::Document::opened);
  document.open(sample("cyst.nii.gz"));
  QTimer timer;
  connect(&timer, &QTimer::timeout, window.get(), [&document] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    if (auto* discard = box->button(QMessageBox::Discard))
      discard->click();  // of what is changed then
    else if (!document.isOpening() || document.isOpeningWaiting())
      box->button(QMessageBox::Yes)->click();
  });
  timer.start(100);
  window->commands()[Command::growHere]->trigger();
  QVERIFY(opened.isEmpty());
  QCOMPARE(document.time().grownFrame(), 2);
  QVERIFY(opened.wait(kPatience));
  QVERIFY(!document.time().hasTime());
}

void TimeWindowTest::aFrameThatFailsIsToldInTheLanguageOfTheWindow() {
  BeatingSample lost;
  QVERIFY(lost.make());
  ui::useLanguage(QStringLiteral("de"));
  auto window = grownWindow(lost);
  QVERIFY(window);
  window->document().time().store().setBound(1);  // byte: nothing is kept
  QVERIFY(QFile::remove(lost.volume));
  QVERIFY(carry(*window));
  const auto* table = window->overTime().findChild<QTableWidget*>();
  QVERIFY(table);
  const QString said = table->item(3, 3)->text();
  QVERIFY2(said.contains(QStringLiteral("seine Voxel können nicht gelesen werden")), qPrintable(said));
  QVERIFY2(said.contains(QStringLiteral("es gibt keine solche Datei")), qPrintable(said));
  ui::useLanguage(QStringLiteral("en"));
}

void TimeWindowTest::nothingIsCutOffInAnyLanguage() {
  for (const ui::Language& language : ui::languages()) {
    ui::useLanguage(language.code);
    QStringList faults;
    auto window = grownWindow(sample_);
    QVERIFY(window && carry(*window));
    const auto look = [&] {
      window->resize(1280, 800);
      faults << lastingLayoutFaults(*window);
      if (window->width() > 1280 || window->height() > 800) faults << "larger than 1280 x 800";
    };
    look();
    window->document().time().show(2);
    QVERIFY(shows(*window, 2));
    window->commands()[Command::correctFrame]->trigger();
    QVERIFY(waitFor(*window, GrowthState::finished));
    look();
    window->commands()[Command::leaveCorrection]->trigger();
    window->commands()[Command::sensitivity]->trigger();
    look();
    QVERIFY2(faults.isEmpty(), qPrintable(language.code + ":\n" + faults.join(QLatin1Char('\n'))));
  }
  ui::useLanguage(QStringLiteral("en"));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  TimeWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "time_window_test.moc"
