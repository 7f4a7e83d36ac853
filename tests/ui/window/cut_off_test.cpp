// In every language, at 1280 x 800: no text is cut off in the list of objects, in dialogs and questions, in
// the menus, nor in what the window shows only now and then.

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabWidget>
#include <QTextBrowser>
#include <QTimer>
#include <algorithm>
#include <functional>

#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/io/overlapping_segments.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/help/help_window.h"
#include "ui/window/objects/object_dialog.h"
#include "ui/window/objects/objects_panel.h"
#include "ui/window/open/open_objects_dialog.h"
#include "ui/window/views/status_fields.h"
#include "ui/window/widgets/language.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

const Vec3 kMiddle(77, 49, 85);
constexpr QSize kScreen(1280, 800);

void settle() { QTest::qWait(15); }

//! With HANDLEBODY_KEEP_PICTURES what is looked at is kept there.
void keepPicture(QWidget& widget, const QString& name) {
  const QString pictures = qEnvironmentVariable("HANDLEBODY_KEEP_PICTURES");
  if (!pictures.isEmpty())
    widget.grab().save(pictures + '/' + name + '_' + ui::languageInUse() + QStringLiteral(".png"));
}

//! What is found, with the places where.
class Faults {
 public:
  void add(const QString& place, const QStringList& faults) {
    for (const QString& fault : faults) found_ << place + QStringLiteral(": ") + fault;
  }
  //! All of a window, which must not be larger than the screen. On a busy machine the layout takes a while.
  void look(const QString& place, QWidget& window) {
    add(place, lastingLayoutFaults(window));
    if (window.width() > kScreen.width() || window.height() > kScreen.height())
      add(place, {QStringLiteral("larger than 1280 x 800")});
    keepPicture(window, place);
  }
  void lookAtSteps(const QString& place, ui::MainWindow& window) {
    for (const Command step : kSteps) {
      window.showStep(step);
      look(place + QStringLiteral(" step %1").arg(static_cast<int>(step) - static_cast<int>(kSteps[0]) + 1),
           window);
    }
  }
  QString text() const { return found_.join(QLatin1Char('\n')); }

 private:
  QStringList found_;
};

//! What a message box says and offers; its parts are Qt's own, which layoutFaults() leaves out.
QStringList faultsOfQuestion(const QMessageBox& box) {
  QStringList faults;
  const auto labels = box.findChildren<QLabel*>();
  for (const QLabel* label : labels)
    if (label->isVisible()) faults << faultOfLabel(*label);
  const auto buttons = box.buttons();
  for (const QAbstractButton* button : buttons) faults << faultOfText(*button);
  faults.removeAll(QString());
  return faults;
}

//! Looks at the question that is asked next, and cancels it.
void lookAtNext(Faults& faults, const QString& place, bool& isAsked) {
  QTimer::singleShot(0, qApp, [&faults, place, &isAsked] {
    QVERIFY(QTest::qWaitFor([] { return QApplication::activeModalWidget() != nullptr; }));
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(box && QTest::qWaitForWindowExposed(box));
    settle();
    isAsked = true;
    faults.add(place, faultsOfQuestion(*box));
    keepPicture(*box, place);
    box->reject();
  });
}

//! Looks at what is asked of a file with objects, when its labels are read, and cancels it.
void lookAtOpening(Faults& faults, const QString& place, ui::MainWindow& window, const QString& path) {
  window.files().openObjects(path);
  QPointer<ui::OpenObjectsDialog> dialog = window.findChild<ui::OpenObjectsDialog*>();
  QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
  if (auto* list = dialog->findChild<QListWidget*>()) {
    faults.look(place + QStringLiteral(" that are read"), *dialog);
    QVERIFY(QTest::qWaitFor([&] { return list->count() > 0; }, kPatience));
  }
  faults.look(place, *dialog);
  dialog->reject();
  QVERIFY(QTest::qWaitFor([&] { return dialog.isNull(); }));
}

//! Three objects as they are added, the first of which has grown a little, so that the others are told what
//! they wait for.
std::unique_ptr<ui::MainWindow> windowWithObjects() {
  auto window = shownWindow();
  if (!window || !open(*window, sample("cyst.nii.gz"))) return nullptr;
  ui::Document& document = window->document();
  document.addSeed({kMiddle, {}});
  if (!QTest::qWaitFor([&] { return document.resolved().has_value(); }, kPatience)) return nullptr;
  window->commands()[Command::stepForward]->trigger();
  if (!QTest::qWaitFor([&] { return document.snapshot() && document.iteration() == 1; }, kPatience))
    return nullptr;
  if (!waitFor(*window, GrowthState::paused)) return nullptr;
  window->commands()[Command::addObject]->trigger();
  window->commands()[Command::addObject]->trigger();
  return window;
}

//! The longest name that the dialog gives an object by itself.
std::string longestTerm() {
  std::string longest;
  for (const Term& term : terms())
    if (term.type.meaning.size() > longest.size()) longest = term.type.meaning;
  return longest;
}

void rename(ui::Document& document, int object, const std::string& name) {
  ObjectLabel label = document.objectInfo(object).label;
  label.name = name;
  document.setObjectLabel(object, label, QStringLiteral("Change object"));
}

template <typename Widget>
Widget* named(QWidget& parent, const char* context, const char* english) {
  const QString name = QCoreApplication::translate(context, english);
  const auto all = parent.findChildren<Widget*>();
  for (Widget* widget : all)
    if (widget->accessibleName() == name) return widget;
  return nullptr;
}

constexpr char kPanel[] = "handlebody::ui::ExportPanel";

void lookAtFormats(Faults& faults, ui::MainWindow& window, const char* place) {
  auto* formats = named<QComboBox>(window, kPanel, "Format");
  QVERIFY(formats);
  for (int i = 0; i < formats->count(); ++i) {
    if (formats->itemData(i).toString().isEmpty()) continue;  // a line between groups
    formats->setCurrentIndex(i);
    faults.look(QLatin1String(place) + formats->itemData(i).toString(), window);
  }
}

//! A volume whose file does not say how large its voxels are.
QString writeUncalibrated(const QTemporaryDir& folder) {
  const QString path = folder.filePath("nowhere.nrrd");
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n");
  for (int i = 0; i < 512; ++i) file.putChar(static_cast<char>(i % 100));
  return path;
}

std::vector<SeriesInfo> someSeries() {
  std::vector<SeriesInfo> series(3);
  for (SeriesInfo& s : series) {
    s.uid = "1.2.840.113619.2.55.3.2831868886.118.1243515843.634.3";
    s.description = "CT THORAX ABDOMEN WITH CONTRAST 1.5 B30f";
    s.modality = "CT";
    s.size = {512, 512, 300};
    s.slices = s.files = 300;
    s.spacing = Vec3(0.703125, 0.703125, 1.5);
  }
  series[1].note = Finding(FindingKind::noVolume, {}, Finding(FindingKind::singleSlice));
  return series;
}

Constraints someConstraints() {
  Constraints some;
  for (int i = 0; i < 20; ++i) some.walls.balls.push_back({Vec3(110, 40 + i, 60), 4});
  some.walls.discs = {{Vec3(112.25, 41.75, 86.5), Vec3(1, 0, 0), 12.5}};
  some.vetoes = {{12, Vec3(110.5, 40.5, 101.5)}, {1234, Vec3(115.25, 40.75, 91.5)}};
  some.topology = {12, 10, {Vec3(118.25, 40.5, 86.5)}};
  some.pins = {{Vec3(112.25, 41.75, 86.5), 12.25, 1234}};
  return some;
}

//! The state is shortened where the bar is too short for it; those that last must not be.
QStringList shortenedIn(ui::MainWindow& window) {
  const QLabel* state =
      shownLabel(window, QCoreApplication::translate("handlebody::ui::StatusFields", "State of the growth"));
  if (!state) return {QStringLiteral("no state is shown")};
  const int needed = state->fontMetrics().horizontalAdvance(state->text());
  return needed > state->width() ? QStringList{QStringLiteral("shortened: ") + state->text()} : QStringList();
}

}  // namespace

class CutOffTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase_data();
  void init();
  void cleanup() { ui::useLanguage(QStringLiteral("en")); }
  void nothingBeforeAVolumeIsOpen();
  void nothingInTheMenus();
  void nothingInTheListOfObjects();
  void nothingInTheExportOfSeveralObjects();
  void nothingInThePropertiesOfAnObject();
  void nothingInQuestions();
  void nothingInWhatIsAskedOfAVolume();
  void nothingInMessagesWithAnswers();
  void nothingInTheStatusBar();
  void nothingInWallsAndWhatIsHeld();
  void nothingInTheHelp();
};

void CutOffTest::initTestCase_data() {
  QTest::addColumn<QString>("code");
  for (const ui::Language& language : ui::languages())
    QTest::newRow(qPrintable(language.code)) << language.code;
}

void CutOffTest::init() {
  QFETCH_GLOBAL(QString, code);
  ui::useLanguage(code);
}

#define NO_FAULTS(faults)                         \
  do {                                            \
    const QString found = (faults).text();        \
    QVERIFY2(found.isEmpty(), qPrintable(found)); \
  } while (false)

void CutOffTest::nothingBeforeAVolumeIsOpen() {
  auto window = shownWindow();
  QVERIFY(window);
  Faults faults;
  faults.lookAtSteps("start", *window);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInTheMenus() {
  auto window = windowWithObjects();
  QVERIFY(window);
  Faults faults;
  const auto menus = window->findChildren<QMenu*>();
  QVERIFY(menus.size() > 5);
  for (QMenu* menu : menus) {
    menu->popup(window->mapToGlobal(QPoint(0, 30)));
    settle();
    const QSize size = menu->size(), room(kScreen.width(), kScreen.height() - 30);
    if (size.width() > room.width() || size.height() > room.height())
      faults.add("menu", {menu->title() + QStringLiteral(" is larger than the screen")});
    const auto entries = menu->actions();
    for (QAction* entry : entries)
      if (entry->isVisible() && !menu->rect().contains(menu->actionGeometry(entry)))
        faults.add("menu", {menu->title() + QStringLiteral(" hides ") + entry->text()});
    menu->close();
  }
  NO_FAULTS(faults);
}

void CutOffTest::nothingInTheListOfObjects() {
  auto window = windowWithObjects();
  QVERIFY(window);
  ui::Document& document = window->document();
  Faults faults;
  QVERIFY(window->findChild<ui::ObjectsPanel*>()->isVisible());
  faults.look("objects", *window);
  for (int i = 3; i < 12; ++i) document.addObject();  // more than are shown without scrolling
  faults.look("objects scrolled", *window);
  document.setActiveObject(1);
  document.addSeed({kMiddle + Vec3(20, 0, 0), {}});
  rename(document, 0, longestTerm());
  document.setObjectLocked(2, true);
  document.setObjectVisible(2, false);
  faults.lookAtSteps("objects named", *window);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInTheExportOfSeveralObjects() {
  auto window = windowWithObjects();
  QVERIFY(window);
  rename(window->document(), 1, longestTerm());
  window->showStep(Command::stepExport);
  auto* objects = named<QComboBox>(*window, kPanel, "Objects");
  QVERIFY(objects && objects->isVisible());
  Faults faults;
  lookAtFormats(faults, *window, "all");
  window->document().setActiveObject(0);
  for (int i = 0; i < objects->count(); ++i) {
    objects->setCurrentIndex(i);
    faults.look("objects to export", *window);
  }

  NO_FAULTS(faults);
}

void CutOffTest::nothingInThePropertiesOfAnObject() {
  auto window = windowWithObjects();
  QVERIFY(window);
  window->commands()[Command::editObject]->trigger();
  auto* dialog = window->findChild<ui::ObjectDialog*>();
  QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
  Faults faults;
  faults.look("dialog", *dialog);
  auto* name = dialog->findChild<QLineEdit*>();
  auto* value = dialog->findChild<QSpinBox*>();
  auto* term = dialog->findChild<QComboBox*>();
  for (const char* wrong : {"", "Object", "a\"b", "a|b"}) {
    name->setText(QLatin1String(wrong));
    faults.look("dialog with a wrong name", *dialog);
  }
  name->setText(QString(40, u'|'));
  faults.look("dialog with a long name", *dialog);
  rename(window->document(), 0, std::string(20, 'W') + ' ' + longestTerm());
  name->setText(QStringLiteral("x"));
  value->setValue(1);
  faults.look("dialog with a wrong value", *dialog);
  value->setValue(65535);
  term->setCurrentIndex(term->findText(QString::fromStdString(longestTerm())));
  Q_EMIT term->activated(term->currentIndex());
  faults.look("dialog with a term", *dialog);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInQuestions() {
  const QTemporaryDir folder;
  auto window = windowWithObjects();
  QVERIFY(window);
  Faults faults;
  bool isAsked = false;
  const QString path = folder.filePath("sub-0123456789_ses-20240229_left lesion.stl");
  writeMesh(icosphere(kMiddle, 4, 1.2), path.toStdString());
  lookAtOpening(faults, "what a mesh is", *window, path);
  const QString segments = folder.filePath("organs.seg.nrrd");
  test::writeLayers({{"Left kidney", "0 1 0", test::inBall(Vec3(8, 8, 8), 4)},
                     {"Lesion of the left kidney", "1 0 0", test::inBall(Vec3(11, 8, 8), 3)}},
                    testing::cubicGrid(20), segments.toStdString());
  lookAtOpening(faults, "labels of a map", *window, segments);
  lookAtNext(faults, "unsaved work", isAsked);
  window->close();
  QVERIFY(std::exchange(isAsked, false) && window->isVisible());
  lookAtNext(faults, "the purpose", isAsked);
  window->greet();
  QVERIFY(QTest::qWaitFor([&] { return isAsked; }));
  NO_FAULTS(faults);
}

void CutOffTest::nothingInWhatIsAskedOfAVolume() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeUncalibrated(folder)));
  Faults faults;
  faults.lookAtSteps("uncalibrated", *window);
  window->showStep(Command::stepOpen);
  Q_EMIT window->files().spacingNeeded(folder.filePath("other.tif"), {});
  faults.look("spacing", *window);
  Q_EMIT window->document().seriesChoiceNeeded(folder.path(), someSeries());
  faults.look("series", *window);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInMessagesWithAnswers() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  Faults faults;
  Q_EMIT window->document().openFailed(QStringLiteral("/a/folder/somewhere/") + QString(150, u'x'), true);
  QVERIFY(window->messages().isVisible());
  faults.look("spacing offered", *window);
  const auto said = [](const char* english) {
    return QCoreApplication::translate("handlebody::ui::FileWork", english);
  };
  const QString recovery =
      said("The program ended unexpectedly last time. Its seeds and parameters were kept.");
  window->messages().show(ui::MessageBar::Kind::warning, recovery,
                          {{said("Restore"), [] {}}, {said("Discard"), [] {}}});
  faults.look("recovery offered", *window);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInTheStatusBar() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeUncalibrated(folder)));
  Faults faults;
  const auto look = [&](const char* place) {
    auto* status = window->findChild<ui::StatusFields*>();
    QVERIFY(status);
    status->showCursor(Vec3(-123.4, -234.5, -345.6), Vec3(511, 511, 300), -1023.4);
    faults.look(place, *window);
    faults.add(place, shortenedIn(*window));
  };
  look("no seed");
  window->document().addSeed({Vec3(4, 4, 4), 1});
  QTest::qWait(200);
  look("seeded");
  window = shownWindow();  // another, or it would ask whether the seed may be lost
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QVERIFY(QTest::qWaitFor([&] { return window->document().resolved().has_value(); }, kPatience));
  look("ready");
  window->document().run();
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() > 2; }, kPatience));
  look("running");
  window->document().pause();
  QVERIFY(waitFor(*window, GrowthState::paused));
  look("paused");
  NO_FAULTS(faults);
}

void CutOffTest::nothingInWallsAndWhatIsHeld() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  window->document().setConstraints(someConstraints(), QStringLiteral("Some"));
  Faults faults;
  faults.lookAtSteps("walls", *window);
  NO_FAULTS(faults);
}

void CutOffTest::nothingInTheHelp() {
  Faults faults;
  ui::HelpWindow help;
  for (auto page :
       {ui::HelpWindow::Page::guide, ui::HelpWindow::Page::shortcuts, ui::HelpWindow::Page::about}) {
    help.show(page);
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    faults.look(QStringLiteral("help %1").arg(static_cast<int>(page)), help);
    const auto browsers = help.findChildren<QTextBrowser*>();
    for (const QTextBrowser* browser : browsers)
      if (browser->isVisible() && browser->horizontalScrollBar()->maximum() > 0)
        faults.add(browser->accessibleName(), {QStringLiteral("wider than the window")});
  }
  NO_FAULTS(faults);
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  CutOffTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "cut_off_test.moc"
