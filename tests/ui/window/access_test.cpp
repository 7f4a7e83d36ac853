// The window without a mouse and without sight: Tab reaches every control, each has a name that is read
// aloud, and every key is written where one looks for it.

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTableWidget>
#include <QToolButton>
#include <QUndoStack>

#include "tests/ui/window/window_support.h"
#include "ui/window/commands.h"
#include "ui/window/help/help_pages.h"
#include "ui/window/help/help_window.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/timeline/timeline_slider.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

bool isControl(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const ui::SliceView*>(&widget) ||
         qobject_cast<const ui::SurfaceView*>(&widget);
}

//! Parts of another control, and the buttons of Qt's docks and tables, whose work a menu does as well.
bool isPartOfAnother(const QWidget& widget) {
  return widget.objectName().startsWith(QLatin1String("qt_")) || widget.inherits("QHeaderView") ||
         widget.inherits("QTableCornerButton") || widget.inherits("QScrollBar") ||
         widget.inherits("QDockWidgetTitleButton");
}

QList<QWidget*> shownControls(ui::MainWindow& window) {
  QList<QWidget*> controls;
  const auto widgets = window.findChildren<QWidget*>();
  for (QWidget* widget : widgets)
    if (widget->isVisible() && widget->window() == &window && isControl(*widget) && !isPartOfAnother(*widget))
      controls << widget;
  return controls;
}

bool hasShortcut(const QWidget& widget) {
  const auto* button = qobject_cast<const QToolButton*>(&widget);
  return button && button->defaultAction() && !button->defaultAction()->shortcut().isEmpty();
}

QString described(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return QStringLiteral("%1 \"%2\" %3")
      .arg(QString::fromLatin1(widget.metaObject()->className()), widget.accessibleName(),
           button ? button->text() : QString());
}

//! All that the Tab key comes to, once round.
QSet<QWidget*> reachedByTab(ui::MainWindow& window) {
  QSet<QWidget*> reached;
  window.activateWindow();
  ui::SliceView& view = window.views().slice(ui::Plane::axial);
  QWidget* first = &view;
  const auto controls = shownControls(window);
  if (!view.isVisible())
    first = *std::find_if(controls.begin(), controls.end(),
                          [](const QWidget* w) { return w->isEnabled() && w->focusPolicy() & Qt::TabFocus; });
  first->setFocus(Qt::TabFocusReason);
  for (int i = 0; i < 300; ++i) {
    QWidget* focus = QApplication::focusWidget();
    if (!focus) break;
    reached << focus;
    QTest::keyClick(focus, Qt::Key_Tab);
    if (QApplication::focusWidget() == first) break;
  }
  return reached;
}

//! Of choices that exclude each other Tab comes to the one that holds, and the arrows to the others.
bool arrowsReach(const QWidget& widget, const QSet<QWidget*>& reached) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const QButtonGroup* group = button ? button->group() : nullptr;
  return group && group->exclusive() && reached.contains(group->checkedButton());
}

QStringList notReached(ui::MainWindow& window) {
  const QSet<QWidget*> reached = reachedByTab(window);
  QStringList faults;
  const auto controls = shownControls(window);
  for (const QWidget* control : controls)
    if (control->isEnabled() && !hasShortcut(*control) && !reached.contains(const_cast<QWidget*>(control)) &&
        !arrowsReach(*control, reached))
      faults << described(*control);
  return faults;
}

QStringList withoutName(ui::MainWindow& window) {
  QStringList faults;
  const auto controls = shownControls(window);
  for (QWidget* control : controls) {
    const QAccessibleInterface* face = QAccessible::queryAccessibleInterface(control);
    if (!face || face->text(QAccessible::Name).trimmed().isEmpty()) faults << described(*control);
  }
  return faults;
}

//! With a volume, grown, with an event inspected: everything there is, is shown in one of the steps.
std::unique_ptr<ui::MainWindow> busyWindow() {
  auto window = shownWindow();
  if (!window || !open(*window, sample("cyst_session.json"))) return nullptr;
  window->document().run();
  if (!waitFor(*window, GrowthState::finished)) return nullptr;
  window->goToEvent(firstHandle(window->document()));
  const bool there = QTest::qWaitFor([&] { return window->inspector().event() >= 0; }, kPatience);
  window->messages().show(ui::MessageBar::Kind::warning, QStringLiteral("Look."),
                          {{QStringLiteral("Answer"), [] {}}});
  return there ? std::move(window) : nullptr;
}

//! Of the events of a growth.
QTableView* eventTable(ui::MainWindow& window) {
  const auto tables = window.findChildren<QTableView*>();
  for (QTableView* table : tables)
    if (table->accessibleName() == "Events") return table;
  return nullptr;
}

std::vector<SeriesInfo> twoSeries() {
  std::vector<SeriesInfo> series(2);
  series[0].uid = "1.2.3";
  series[1].uid = "1.2.4";
  for (SeriesInfo& s : series) s.slices = s.files = 20;
  return series;
}

}  // namespace

class AccessTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tabReachesEveryControl();
  void arrowsChooseAmongChoicesThatExcludeEachOther();
  void everyControlIsReadAloudByAName();
  void labelsAreReadAloudWithTheirValues();
  void aMessageIsReadAloud();
  void everyLetterOpensOneEntryOfItsMenu();
  void whatIsAskedWhileNothingIsOpenIsReachedAndNamed();
  void anEventAndAnIterationAreChosenByKeys();
  void keysChooseInAListThatDropsDown();
  void aWordIsDeletedInAFieldAndNoObject();
  void lettersInAComboBoxRunNoCommand();
  void deleteInAListDeletesWhatItLists();
  void aKeyThatIsHeldRepeatsWhatGoesOnByALittleOnly();
  void windowAndLevelAreDraggedWhileTheKeyIsHeld();
  void itIsSeenThatTheTimelineHasTheFocus();
  void keysScrollTheGuideAtOnceAndEscapeClosesIt();
  void everyKeyIsOnThePageOfKeysAndInTheTip();
  void everyMenuEntryIsACommandOfTheTable();
};

void AccessTest::tabReachesEveryControl() {
  auto window = busyWindow();
  QVERIFY(window);
  for (Command step : kSteps) {
    window->showStep(step);
    QTest::qWait(50);
    const QString missed = notReached(*window).join(QLatin1Char('\n'));
    QVERIFY2(missed.isEmpty(), qPrintable(window->commands()[step]->text() + QLatin1Char('\n') + missed));
  }
}

void AccessTest::arrowsChooseAmongChoicesThatExcludeEachOther() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  window->showStep(Command::stepTune);
  QAbstractButton* outward = nullptr;
  const auto buttons = window->findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons)
    if (button->accessibleName() == "Direction: Outward") outward = button;
  QVERIFY(outward && outward->isChecked());
  outward->setFocus();
  QTest::keyClick(outward, Qt::Key_Right);
  QVERIFY(window->document().parameters().direction == Direction::both);
}

void AccessTest::everyControlIsReadAloudByAName() {
  auto window = busyWindow();
  QVERIFY(window);
  for (Command step : kSteps) {
    window->showStep(step);
    QTest::qWait(50);
    const QString nameless = withoutName(*window).join(QLatin1Char('\n'));
    QVERIFY2(nameless.isEmpty(), qPrintable(window->commands()[step]->text() + QLatin1Char('\n') + nameless));
  }
}

void AccessTest::labelsAreReadAloudWithTheirValues() {
  auto window = busyWindow();
  QVERIFY(window);
  window->showStep(Command::stepGrow);
  int read = 0;
  const auto labels = window->findChildren<QLabel*>();
  for (QLabel* label : labels) {
    if (!label->isVisible() || label->accessibleName().isEmpty()) continue;
    const QString said = QAccessible::queryAccessibleInterface(label)->text(QAccessible::Name);
    QVERIFY2(said.startsWith(label->accessibleName()), qPrintable(said));
    if (label->accessibleName() == "Genus") QCOMPARE(said, "Genus: " + label->text());
    if (label->accessibleName() == "Certificate") QVERIFY2(said.contains("manifold"), qPrintable(said));
    read += label->accessibleName() == "Genus" || label->accessibleName() == "Certificate";
  }
  QCOMPARE(read, 2);
}

void AccessTest::aMessageIsReadAloud() {
  auto window = shownWindow();
  QVERIFY(window);
  window->messages().show(ui::MessageBar::Kind::error, QStringLiteral("scan.nii: it is <truncated>."));
  const auto* face = QAccessible::queryAccessibleInterface(&window->messages());
  QVERIFY(face);
  QCOMPARE(face->text(QAccessible::Name), QString("Error"));
  QCOMPARE(face->text(QAccessible::Description), QString("scan.nii: it is <truncated>."));
  window->messages().show(ui::MessageBar::Kind::error, QStringLiteral("<b>scan</b>.nii: it is truncated."));
  const QLabel* text = shownLabel(*window, "Message");
  QVERIFY(text && text->textFormat() == Qt::PlainText);  // nothing of a name is left out
}

void AccessTest::everyLetterOpensOneEntryOfItsMenu() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  for (bool running : {false, true}) {
    if (running) window->document().run();
    QList<QWidget*> menus{window->menuBar()};
    for (QMenu* menu : window->findChildren<QMenu*>()) menus << menu;
    for (const QWidget* menu : menus) {
      QStringList letters;
      for (const QAction* action : menu->actions()) {
        const QString letter = QKeySequence::mnemonic(action->text()).toString();
        QVERIFY2(letter.isEmpty() || !letters.contains(letter), qPrintable(action->text()));
        letters << letter;
      }
    }
  }
}

// The start page with a file opened before, the list of series, the spacing of a voxel, a message.
void AccessTest::whatIsAskedWhileNothingIsOpenIsReachedAndNamed() {
  QSettings().clear();
  QSettings().setValue("recent", QStringList{sample("cyst.nii.gz")});
  ui::MainWindow window;
  window.resize(1280, 800);
  window.show();
  QVERIFY(activate(window));
  Q_EMIT window.document().seriesChoiceNeeded(QStringLiteral("/somewhere/scans"), twoSeries());
  window.showStep(Command::stepGrow);
  Q_EMIT window.files().spacingNeeded(QStringLiteral("/somewhere/cine.dcm"), {});
  QCOMPARE(QApplication::focusWidget()->accessibleName(), QString("Spacing of columns"));
  window.messages().show(ui::MessageBar::Kind::error, QStringLiteral("No."));
  QTest::qWait(50);
  const QString missed = notReached(window).join(QLatin1Char('\n'));
  QVERIFY2(missed.isEmpty(), qPrintable(missed));
  const QString nameless = withoutName(window).join(QLatin1Char('\n'));
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless));
}

void AccessTest::anEventAndAnIterationAreChosenByKeys() {
  auto window = busyWindow();
  QVERIFY(window);
  ui::Document& document = window->document();
  const int event = document.events()[firstHandle(document)].iteration;
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == event; }, kPatience));
  QSlider* slider = nullptr;
  const auto sliders = window->findChildren<QSlider*>();
  for (QSlider* s : sliders)
    if (s->accessibleName() == "Iteration") slider = s;
  QVERIFY(slider);
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == event + 1; }, kPatience));
  QTest::keyClick(slider, Qt::Key_End);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == document.lastIteration(); }, kPatience));

  QTableView* table = eventTable(*window);
  QVERIFY(table && table->model()->rowCount() > 0);
  table->setFocus();
  table->setCurrentIndex(table->model()->index(0, 0));
  QTest::keyClick(table, Qt::Key_Return);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == event; }, kPatience));
}

//! Return adds a seed and Space grows where no list is open.
void AccessTest::keysChooseInAListThatDropsDown() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")) && activate(*window));
  window->showStep(Command::stepGrow);
  QComboBox* rule = nullptr;
  const auto boxes = window->findChildren<QComboBox*>();
  for (QComboBox* box : boxes)
    if (box->accessibleName() == "Topology") rule = box;
  QVERIFY(rule && rule->isVisible() && rule->isEnabled() && rule->count() > 1);
  const ui::Document& document = window->document();
  const std::size_t seeds = document.seeds().size();
  for (Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
    const int before = rule->currentIndex();
    rule->setFocus();
    QTest::keyClick(rule, Qt::Key_Space);
    QTRY_VERIFY(rule->view()->isVisible());
    QTest::keyClick(rule->view(), before == 0 ? Qt::Key_Down : Qt::Key_Up);
    QTest::keyClick(rule->view(), Qt::Key_Space);  // chooses nothing in this style, and starts nothing
    QVERIFY(rule->view()->isVisible());
    QTest::keyClick(rule->view(), key);
    QTRY_VERIFY(!rule->view()->isVisible());
    QCOMPARE(rule->currentIndex(), before == 0 ? 1 : before - 1);
  }
  QCOMPARE(document.seeds().size(), seeds);
  QVERIFY(document.state() == GrowthState::none || document.state() == GrowthState::finished);
}

//! Ctrl and Backspace delete the active object elsewhere.
void AccessTest::aWordIsDeletedInAFieldAndNoObject() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")) && activate(*window));
  const ui::Document& document = window->document();
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QCOMPARE(document.objectCount(), 2);
  window->showStep(Command::stepTune);
  QDoubleSpinBox* curvature = numberField(*window, "Curvature");
  QVERIFY(curvature);
  QLineEdit line(QStringLiteral("two words"), window.get());
  line.show();
  for (QWidget* field : {static_cast<QWidget*>(curvature), static_cast<QWidget*>(&line)}) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Backspace, Qt::ControlModifier);
    QCOMPARE(document.objectCount(), 2);
  }
  QCOMPARE(line.text(), QStringLiteral("two "));
  line.setReadOnly(true);  // there it means nothing, and is the window's
  QTest::keyClick(&line, Qt::Key_Backspace, Qt::ControlModifier);
  QCOMPARE(document.objectCount(), 1);
}

//! They choose among what it offers.
void AccessTest::lettersInAComboBoxRunNoCommand() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")) && activate(*window));
  QComboBox box(window.get());
  box.addItems({QStringLiteral("first"), QStringLiteral("wide")});
  box.show();
  box.setFocus();
  QTest::keyClick(&box, Qt::Key_W);
  QCOMPARE(box.currentIndex(), 1);
  QVERIFY(!window->commands()[Command::windowLevelTool]->isChecked());
  QTest::keyClick(window.get(), Qt::Key_W);  // elsewhere it does
  QVERIFY(window->commands()[Command::windowLevelTool]->isChecked());
}

void AccessTest::deleteInAListDeletesWhatItLists() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")) && activate(*window));
  ui::Document& document = window->document();
  QTableWidget other(1, 1, window.get());
  other.show();
  window->showStep(Command::stepSeed);
  QTableWidget* seeds = nullptr;
  const auto tables = window->findChildren<QTableWidget*>();
  for (QTableWidget* table : tables)
    if (table->accessibleName() == "Seeds") seeds = table;
  QVERIFY(seeds);
  for (Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
    document.selectSeed(0);
    other.setFocus();
    QTest::keyClick(&other, key);
    QCOMPARE(document.seeds().size(), std::size_t{1});
    seeds->setFocus();
    QTest::keyClick(seeds, key);
    QCOMPARE(document.seeds().size(), std::size_t{0});
    document.undoStack()->undo();
  }
}

void AccessTest::aKeyThatIsHeldRepeatsWhatGoesOnByALittleOnly() {
  auto window = shownWindow();
  QVERIFY(window);
  for (Command id : {Command::run, Command::addSeed, Command::deleteSeed, Command::paintWalls,
                     Command::windowLevelTool, Command::deleteObject, Command::playFrames})
    QVERIFY2(!window->commands()[id]->autoRepeat(), qPrintable(window->commands()[id]->text()));
  for (Command id : {Command::stepForward, Command::growSeed, Command::largerBrush, Command::nextFrame})
    QVERIFY2(window->commands()[id]->autoRepeat(), qPrintable(window->commands()[id]->text()));
}

//! As long as it is held; after a short press until the next.
void AccessTest::windowAndLevelAreDraggedWhileTheKeyIsHeld() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")) && activate(*window));
  ui::SliceView& view = window->views().slice(ui::Plane::axial);
  const ui::ViewState& state = window->viewState();
  view.setFocus();
  QTest::keyPress(&view, Qt::Key_W);
  QVERIFY(state.windowLevelTool() && window->commands()[Command::windowLevelTool]->isChecked());
  const QPoint middle = view.rect().center();
  QTest::mousePress(&view, Qt::LeftButton, {}, middle);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, middle);
  QTest::keyRelease(&view, Qt::Key_W);
  QVERIFY(!state.windowLevelTool() && !window->commands()[Command::windowLevelTool]->isChecked());
  QTest::keyClick(&view, Qt::Key_W);
  QVERIFY(state.windowLevelTool());
  QTest::keyClick(&view, Qt::Key_W);
  QVERIFY(!state.windowLevelTool());
}

void AccessTest::itIsSeenThatTheTimelineHasTheFocus() {
  ui::TimelineSlider slider;
  slider.setRange(0, 10);
  slider.setValue(5);
  slider.resize(300, 24);
  slider.show();
  QVERIFY(activate(slider));
  slider.clearFocus();
  const QImage without = slider.grab().toImage();
  slider.setFocus();
  const QImage with = slider.grab().toImage();
  int different = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x)
      different += std::abs(qGray(with.pixel(x, y)) - qGray(without.pixel(x, y))) > 60;
  QVERIFY2(different > 20, qPrintable(QString::number(different)));
}

void AccessTest::keysScrollTheGuideAtOnceAndEscapeClosesIt() {
  auto window = shownWindow();
  QVERIFY(window);
  QTest::keyClick(window.get(), Qt::Key_F1);
  auto* help = window->findChild<ui::HelpWindow*>();
  QVERIFY(help && activate(*help));
  QTRY_VERIFY(help->isAncestorOf(QApplication::focusWidget()));
  QWidget* focus = QApplication::focusWidget();
  QTest::keyClick(focus, Qt::Key_PageDown);
  auto* page = qobject_cast<QAbstractScrollArea*>(focus);
  QVERIFY(page && page->verticalScrollBar()->value() > 0);
  QTest::keyClick(focus, Qt::Key_Escape);
  QVERIFY(!help->isVisible());
}

void AccessTest::everyKeyIsOnThePageOfKeysAndInTheTip() {
  auto window = shownWindow();
  QVERIFY(window);
  const QString page = ui::shortcutsPage();
  QVERIFY(page.contains("<b>Esc</b>"));
  for (const ui::CommandSpec& spec : ui::Commands::table()) {
    const QAction* action = window->commands()[spec.id];
    for (const QKeySequence& key : action->shortcuts())
      QVERIFY2(page.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()), spec.text);
    if (!action->shortcut().isEmpty())
      QVERIFY2(action->toolTip().contains(ui::Commands::keysText(*action).toHtmlEscaped()), spec.text);
  }
}

void AccessTest::everyMenuEntryIsACommandOfTheTable() {
  auto window = shownWindow();
  QVERIFY(window);
  QSet<const QAction*> known;
  for (const ui::CommandSpec& spec : ui::Commands::table()) known << window->commands()[spec.id];
  const auto menus = window->menuBar()->findChildren<QMenu*>();
  for (const QMenu* menu : menus) {
    const bool own = menu->title().contains("recent") || menu->title().contains("Panels");
    for (const QAction* action : menu->actions())
      QVERIFY2(own || action->isSeparator() || action->menu() || known.contains(action),
               qPrintable(action->text()));
  }
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  AccessTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "access_test.moc"
