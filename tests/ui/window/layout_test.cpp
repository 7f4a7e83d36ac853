// Nothing in the window is cut off, squeezed, overlapped or invisible: at the usual sizes, in light and dark,
// in every step of the work.

#include <QCheckBox>
#include <QDir>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QTextBrowser>
#include <cmath>

#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/help/help_window.h"
#include "ui/window/open/open_panel.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/toggle_button.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

//! Faults in every step of the work, with the step's name.
QStringList faultsInEveryStep(ui::MainWindow& window) {
  QStringList faults;
  for (Command step : kSteps) {
    window.showStep(step);
    for (const QString& fault : lastingLayoutFaults(window))
      faults << window.commands()[step]->text() + QStringLiteral(": ") + fault;
  }
  return faults;
}

QString resized(ui::MainWindow& window, const QSize& size) {
  window.resize(size);
  return faultsInEveryStep(window).join(QLatin1Char('\n'));
}

//! Relative luminance and contrast as the Web Content Accessibility Guidelines define them.
double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

//! The largest contrast of a pixel of the picture to a colour.
double largestContrast(const QImage& picture, const QColor& ground) {
  double largest = 1;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      largest = std::max(largest, contrast(picture.pixelColor(x, y), ground));
  return largest;
}

void switchAppearances(ui::Appearance last) {
  const bool dark = last == ui::Appearance::dark;
  ui::applyAppearance(dark ? ui::Appearance::light : ui::Appearance::dark);  // as when the user switches
  ui::applyAppearance(last);
}

QRect placeOf(const QWidget& widget, const ui::MainWindow& window) {
  return {widget.mapTo(&window, QPoint()), widget.size()};
}

QList<QRect> placesOfViews(const ui::MainWindow& window) {
  const ui::ViewGrid& views = const_cast<ui::MainWindow&>(window).views();
  QList<QRect> places{placeOf(views.surface(), window)};
  for (auto plane : {ui::Plane::axial, ui::Plane::coronal, ui::Plane::sagittal})
    places << placeOf(views.slice(plane), window);
  return places;
}

struct Message {
  ui::MessageBar::Kind kind;
  QString sentence;
  std::vector<ui::MessageBar::Answer> answers;
};

//! A short one, one with answers, and one of several lines.
std::vector<Message> messages() {
  using Kind = ui::MessageBar::Kind;
  return {{Kind::information, QStringLiteral("It is written."), {}},
          {Kind::warning,
           QStringLiteral("The program ended unexpectedly last time. Its seeds and parameters were kept."),
           {{QStringLiteral("Restore"), [] {}}, {QStringLiteral("Discard"), [] {}}}},
          {Kind::error,
           QStringLiteral("/a/folder/somewhere/") + QString(150, u'x') + ": it is not a volume.",
           {}}};
}

}  // namespace

class LayoutTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingIsCutOffBeforeAVolumeIsOpen();
  void nothingIsCutOffBeforeAndAfterASeed();
  void nothingIsCutOffWhenAnEventIsInspected();
  void nothingIsCutOffWhenSeriesAreOffered();
  void nothingIsCutOffWithALongFileName();
  void nothingIsCutOffWithWallsAndWhatIsHeld();
  void filesOpenedBeforeAreNamedInTheRoomThereIs();
  void nothingIsCutOffWhenMessagesHoldLongWords();
  void theViewsKeepTheirPlaceWhenAMessageComesAndGoes();
  void aMessageLiesWholeOverTheViewsAndHidesNoneOfTheirNamesAndButtons();
  void theDockKeepsItsWidthWhenAnEventIsChosen();
  void theDockKeepsItsWidthWhenSeriesAreOffered();
  void theWindowIsNoWiderForALongState();
  void theHelpPagesDoNotScrollSideways();
  void togglesAndTheirTextAreToldApartInBothAppearances();
  void theStepThatIsShownIsToldFromTheOneUnderTheMouse();
  void theIconOfTheChosenRowOfAMenuIsSeen();
  void checkBoxesAreSeenInBothAppearances();
  void textIsReadableInBothAppearances();
  void theSymbolsOfMessagesAreSeenInBothAppearances();
  void disabledEntriesOfAMenuHaveNoShadow();
  void theButtonsOfThePanelsAreSharpOnAFineScreen();
};

constexpr QSize kSmall(1280, 800), kLarge(1600, 1000);

#define NO_FAULTS(found)                        \
  do {                                          \
    const QString text = found;                 \
    QVERIFY2(text.isEmpty(), qPrintable(text)); \
  } while (false)

void LayoutTest::nothingIsCutOffBeforeAVolumeIsOpen() {
  auto window = shownWindow();
  QVERIFY(window);
  NO_FAULTS(resized(*window, kSmall));
  NO_FAULTS(resized(*window, kLarge));
}

void LayoutTest::nothingIsCutOffBeforeAndAfterASeed() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  NO_FAULTS(resized(*window, kSmall));
  window->document().addSeed({Vec3(77, 49, 85), {}});
  QVERIFY(QTest::qWaitFor([&] { return window->document().resolved().has_value(); }, kPatience));
  NO_FAULTS(resized(*window, kSmall));
  NO_FAULTS(resized(*window, kLarge));
}

void LayoutTest::nothingIsCutOffWhenAnEventIsInspected() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  window->document().run();
  QVERIFY(waitFor(*window, GrowthState::finished));
  window->goToEvent(firstHandle(window->document()));
  QVERIFY(
      QTest::qWaitFor([&] { return window->inspector().isVisible() || window->inspector().event() >= 0; }));
  window->inspector().showStage(ui::EventStage::closed);
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    window->setAppearance(appearance);
    NO_FAULTS(resized(*window, kSmall));
    NO_FAULTS(resized(*window, kLarge));
  }
}

void LayoutTest::nothingIsCutOffWhenSeriesAreOffered() {
  auto window = shownWindow();
  QVERIFY(window);
  std::vector<SeriesInfo> series(3);
  for (SeriesInfo& s : series) {
    s.uid = "1.2.840.113619.2.55.3.2831868886.118.1243515843.634.3";
    s.description = "CT THORAX ABDOMEN WITH CONTRAST 1.5 B30f";
    s.modality = "CT";
    s.size = {512, 512, 300};
    s.slices = s.files = 300;
    s.spacing = Vec3(0.703125, 0.703125, 1.5);
  }
  series[1].note = Finding(FindingKind::noVolume, {}, FindingKind::singleSlice);
  Q_EMIT window->document().seriesChoiceNeeded(QStringLiteral("/somewhere/scans"), series);
  NO_FAULTS(resized(*window, kSmall));
}

void LayoutTest::nothingIsCutOffWithWallsAndWhatIsHeld() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  Constraints some;
  for (int i = 0; i < 20; ++i) some.walls.balls.push_back({Vec3(110, 40 + i, 60), 4});
  some.walls.discs = {{Vec3(112.25, 41.75, 86.5), Vec3(1, 0, 0), 12.5}};
  some.vetoes = {{12, Vec3(110.5, 40.5, 101.5)}, {1234, Vec3(115.25, 40.75, 91.5)}};
  some.topology = {12, 10, {Vec3(118.25, 40.5, 86.5)}};
  some.pins = {{Vec3(112.25, 41.75, 86.5), 12.25, 1234}};
  window->document().setConstraints(some, QStringLiteral("Some"));
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    window->setAppearance(appearance);
    NO_FAULTS(resized(*window, kSmall));
    NO_FAULTS(resized(*window, kLarge));
  }
}

void LayoutTest::nothingIsCutOffWithALongFileName() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(
      "sub-0123456789_ses-20240229_acq-highresolution_rec-motioncorrected_run-01_T2w_denoised_biascorrected."
      "nii.gz");
  QVERIFY(QFile::copy(sample("cyst.nii.gz"), path));
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  NO_FAULTS(resized(*window, kSmall));
  QVERIFY(window->views().width() > window->width() / 2);  // and the name pushed nothing away
}

void LayoutTest::filesOpenedBeforeAreNamedInTheRoomThereIs() {
  const QTemporaryDir folder;
  const QString deep = folder.filePath(QString(120, u'd')), odd = folder.filePath("one & two.nii.gz");
  const QString path = deep + '/' + QString(150, u'x') + ".nii.gz";
  QVERIFY(QDir().mkpath(deep));
  for (const QString& there : {path, odd}) QVERIFY(QFile::copy(sample("cyst.nii.gz"), there));
  QSettings().clear();
  QSettings().setValue("recent", QStringList{path, odd});
  ui::MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  NO_FAULTS(resized(window, kSmall));
  bool found = false;
  const auto menus = window.findChildren<QMenu*>();
  for (const QMenu* menu : menus) {
    if (!menu->title().contains("recent")) continue;
    QVERIFY(menu->sizeHint().width() < 800);
    found = menu->actions()[1]->text().startsWith("one && two.nii.gz");
  }
  QVERIFY(found);
}

// Paths have words that are wider than a panel, and so have UIDs.
void LayoutTest::nothingIsCutOffWhenMessagesHoldLongWords() {
  const QString uid = "1.2.826.0.1.3680043.9.4245.3115138630835728997848661150714813892";
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->resize(kSmall);
  QTest::qWait(50);
  const int before = window->views().width();
  auto* panel = window->findChild<ui::OpenPanel*>();
  QVERIFY(panel);
  window->showStep(ui::Command::stepOpen);
  panel->showWarnings({Finding(FindingKind::fileNotDicom, {{"names", uid.toStdString()}})});
  const QString path = '/' + QString(200, 'x') + ".nii.gz";
  auto* messages = window->findChild<ui::MessageBar*>();
  messages->show(ui::MessageBar::Kind::error, path + ": it is not a volume.");
  NO_FAULTS(resized(*window, kSmall));
  QCOMPARE(window->views().width(), before);
  QVERIFY(messages->text().startsWith(path));
}

void LayoutTest::theViewsKeepTheirPlaceWhenAMessageComesAndGoes() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  QTest::qWait(50);
  const QList<QRect> before = placesOfViews(*window);
  for (const Message& message : messages()) {
    window->messages().show(message.kind, message.sentence, message.answers);
    QTest::qWait(50);
    QVERIFY(window->messages().isVisible());
    QCOMPARE(placesOfViews(*window), before);
    QTest::keyClick(&window->views().slice(ui::Plane::axial), Qt::Key_Escape);
    QTest::qWait(50);
    QVERIFY(!window->messages().isVisible());
    QCOMPARE(placesOfViews(*window), before);
  }
}

void LayoutTest::aMessageLiesWholeOverTheViewsAndHidesNoneOfTheirNamesAndButtons() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  ui::MessageBar& bar = window->messages();
  for (const QSize& size : {kLarge, kSmall})  // it follows the window
    for (const Message& message : messages()) {
      bar.show(message.kind, message.sentence, message.answers);
      NO_FAULTS(resized(*window, size));
      const QRect here(bar.mapTo(window.get(), QPoint()), bar.size());
      QVERIFY(placeOf(window->views(), *window).contains(here));
      QVERIFY(bar.isAncestorOf(window->childAt(here.center())) || window->childAt(here.center()) == &bar);
      const QColor ground = window->grab().toImage().pixelColor(here.topLeft() + QPoint(6, 6));
      QCOMPARE(ground, bar.palette().color(QPalette::ToolTipBase));  // and nothing shines through
      for (QRect view : placesOfViews(*window)) {
        view.setHeight(48);  // name, number of the slice, button
        QVERIFY2(!view.intersects(here), qPrintable(message.sentence));
      }
    }
}

void LayoutTest::theDockKeepsItsWidthWhenAnEventIsChosen() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  const int before = window->views().width();
  window->document().run();
  QVERIFY(waitFor(*window, GrowthState::finished));
  window->goToEvent(firstHandle(window->document()));
  QTRY_VERIFY(window->inspector().isVisible());
  QCOMPARE(window->views().width(), before);
}

void LayoutTest::theDockKeepsItsWidthWhenSeriesAreOffered() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->showStep(Command::stepOpen);
  QTest::qWait(50);
  const int before = window->views().width();
  std::vector<SeriesInfo> series(12);
  for (SeriesInfo& s : series) s.description = "CT THORAX ABDOMEN WITH CONTRAST 1.5 B30f";
  Q_EMIT window->document().seriesChoiceNeeded(QStringLiteral("/somewhere/scans"), series);
  QTest::qWait(50);
  QCOMPARE(window->views().width(), before);
  window->resize(kLarge);
  Q_EMIT window->document().seriesChoiceNeeded(QStringLiteral("/somewhere/scans"), {series[0], series[1]});
  QTest::qWait(50);
  const auto lists = window->findChildren<QListWidget*>();
  QCOMPARE(lists.size(), 1);
  const QWidget* choice = lists[0]->parentWidget();
  QTRY_COMPARE(choice->height(), choice->sizeHint().height());  // with no gaps between its parts
}

void LayoutTest::theWindowIsNoWiderForALongState() {
  auto window = shownWindow();
  QVERIFY(window);
  const int before = window->minimumSizeHint().width();
  const QString name = QString(300, u'x') + ".nii.gz";
  Q_EMIT window->document().opening("/a/" + name, 0.5);
  QTest::qWait(50);
  QCOMPARE(window->minimumSizeHint().width(), before);
  QVERIFY(shownLabel(*window, "State of the growth")->toolTip().contains(name));
}

void LayoutTest::theHelpPagesDoNotScrollSideways() {
  ui::HelpWindow help;
  for (auto page :
       {ui::HelpWindow::Page::guide, ui::HelpWindow::Page::shortcuts, ui::HelpWindow::Page::about}) {
    help.show(page);
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    QTest::qWait(50);
    const auto browsers = help.findChildren<QTextBrowser*>();
    for (const QTextBrowser* browser : browsers)
      if (browser->isVisible()) QCOMPARE(browser->horizontalScrollBar()->maximum(), 0);
  }
}

void LayoutTest::togglesAndTheirTextAreToldApartInBothAppearances() {
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    ui::ToggleButton off(QStringLiteral("Auto")), on(QStringLiteral("Auto"));
    on.setChecked(true);
    switchAppearances(appearance);
    const QPoint corner(4, 4);  // beside the text
    const QColor offGround = off.grab().toImage().pixelColor(corner),
                 onGround = on.grab().toImage().pixelColor(corner);
    QVERIFY(contrast(offGround, off.palette().color(QPalette::Window)) < 1.6);  // no lamp in a dark room
    QVERIFY(contrast(offGround, onGround) > 2);
    QVERIFY(largestContrast(off.grab().toImage(), offGround) > 4.5);
    QVERIFY(largestContrast(on.grab().toImage(), onGround) > 4.5);
  }
}

void LayoutTest::theStepThatIsShownIsToldFromTheOneUnderTheMouse() {
  auto window = shownWindow();
  QVERIFY(window);
  QAbstractButton *shown = nullptr, *other = nullptr;
  const auto buttons = window->findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons) {
    if (button->accessibleName().startsWith("Step 1")) shown = button;
    if (button->accessibleName().startsWith("Step 3")) other = button;
  }
  QVERIFY(shown && other && shown->isChecked() && !other->isChecked());
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    window->setAppearance(appearance);
    other->setAttribute(Qt::WA_UnderMouse);
    const QPoint below(shown->width() / 2, shown->height() - 2);
    const QColor marked = shown->grab().toImage().pixelColor(below),
                 hovered = other->grab().toImage().pixelColor(below);
    QVERIFY(contrast(marked, hovered) > 1.8);
    QVERIFY(marked.saturation() > hovered.saturation() + 60);
  }
}

void LayoutTest::theIconOfTheChosenRowOfAMenuIsSeen() {
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    switchAppearances(appearance);
    QMenu menu;
    QAction* start = menu.addAction(ui::icon(QStringLiteral("run")), QString());
    menu.popup({0, 0});
    menu.setActiveAction(start);
    QVERIFY(QTest::qWaitForWindowExposed(&menu));
    const QRect row = menu.actionGeometry(start);
    const QImage picture = menu.grab(row.adjusted(3, 3, -3, -3)).toImage();
    QVERIFY(largestContrast(picture, menu.palette().color(QPalette::Highlight)) > 3);
    menu.close();
  }
}

void LayoutTest::checkBoxesAreSeenInBothAppearances() {
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    QCheckBox off, on;
    on.setChecked(true);
    switchAppearances(appearance);
    const QColor ground = off.palette().color(QPalette::Window);
    const QImage empty = off.grab().toImage(), ticked = on.grab().toImage();
    QVERIFY(largestContrast(empty, ground) > 3);
    QVERIFY(largestContrast(ticked, ground) > 3);
    QVERIFY(empty != ticked);
  }
}

void LayoutTest::textIsReadableInBothAppearances() {
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    switchAppearances(appearance);
    const QPalette p = QApplication::palette();
    QVERIFY(contrast(p.color(QPalette::WindowText), p.color(QPalette::Window)) > 7);
    QVERIFY(contrast(p.color(QPalette::Text), p.color(QPalette::Base)) > 7);
    QVERIFY(contrast(p.color(QPalette::ButtonText), p.color(QPalette::Button)) > 4.5);
    QVERIFY(contrast(p.color(QPalette::PlaceholderText), p.color(QPalette::Window)) > 4.5);
    QVERIFY(contrast(p.color(QPalette::HighlightedText), p.color(QPalette::Highlight)) > 4.5);
    QVERIFY(contrast(p.color(QPalette::ToolTipText), p.color(QPalette::ToolTipBase)) > 7);
  }
}

void LayoutTest::theSymbolsOfMessagesAreSeenInBothAppearances() {
  for (auto appearance : {ui::Appearance::light, ui::Appearance::dark}) {
    switchAppearances(appearance);
    const QColor ground = QApplication::palette().color(QPalette::ToolTipBase);
    for (const char* name : {"info", "warning", "error"}) {
      QPixmap picture(40, 40);
      picture.fill(ground);
      QPainter(&picture).drawPixmap(0, 0, ui::icon(QLatin1String(name)).pixmap(40, 40));
      QVERIFY2(largestContrast(picture.toImage(), ground) > 3, name);
    }
  }
}

void LayoutTest::disabledEntriesOfAMenuHaveNoShadow() {
  switchAppearances(ui::Appearance::dark);
  QMenu menu;
  for (bool enabled : {true, false}) menu.addAction(QStringLiteral("MMMM"))->setEnabled(enabled);
  menu.popup({200, 200});
  QVERIFY(QTest::qWaitForWindowExposed(&menu));
  const auto inked = [&](int row) {  // the pixels that are not the ground's
    const QRect place = menu.actionGeometry(menu.actions()[row]).adjusted(3, 3, -3, -3);
    const QImage picture = menu.grab(place).toImage();
    QRect ink;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (picture.pixel(x, y) != picture.pixel(0, 0)) ink |= QRect(x, y, 1, 1);
    return ink;
  };
  QVERIFY(!inked(0).isEmpty());
  QCOMPARE(inked(1), inked(0));  // a shadow reaches further
}

void LayoutTest::theButtonsOfThePanelsAreSharpOnAFineScreen() {
  auto window = shownWindow();
  QVERIFY(window);
  int found = 0;
  const auto buttons = window->findChildren<QAbstractButton*>();
  for (const QAbstractButton* button : buttons) {
    if (!button->inherits("QDockWidgetTitleButton")) continue;
    QCOMPARE(button->icon().pixmap(QSize(16, 16), 3.0).size(), QSize(48, 48));  // drawn, not enlarged
    ++found;
  }
  QCOMPARE(found, 8);  // two per dock
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  LayoutTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "layout_test.moc"
