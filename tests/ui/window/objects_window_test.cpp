// The list of objects in the window: by mouse and keys, drawn, and out of the way with one object.

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>

#include "core/collision/body_contact.h"
#include "tests/ui/dumbbell.h"
#include "tests/ui/window/two_balls.h"
#include "ui/window/objects/object_dialog.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/timeline/event_table.h"
#include "ui/window/widgets/numbers.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

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

//! Of the active object, after its first step; the number of the event that is inspected then, -1 if none is.
int cutBall(ui::MainWindow& window, const Vec3& middle) {
  ui::Document& document = window.document();
  document.addSeed({middle, 4.0});
  document.stepForward();
  const auto isAt = [&](int iteration) {
    return QTest::qWaitFor(
        [&] {
          const bool rests =
              document.state() == GrowthState::paused || document.state() == GrowthState::finished;
          return document.iteration() == iteration && rests;
        },
        kPatience);
  };
  if (!isAt(1)) return -1;
  MeshEdit cut{0, MeshEditKind::cut, middle + Vec3(0.3, 0.2, 0.7)};
  cut.vector = Vec3(1, 2, 9);
  cut.keep = KeptSide::negative;
  document.editMesh(cut);
  return isAt(2) ? window.inspector().event() : -1;
}

}  // namespace

class ObjectsWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void withOneObjectTheListIsOutOfTheWay();
  void twoObjectsGrowOneAfterTheOther();
  void theListIsDrivenByMouseAndKeys();
  void aLockedObjectStaysSoWhenTheBrushIsAnotherOne();
  void theTableOfEventsIsThatOfTheActiveObject();
  void theInspectedEventIsThatOfTheActiveObject();
  void propertiesAreChangedInADialog();
  void theChosenColourOfASingleObjectIsThatOfItsOutline();
  void aTermOfAFileStandsFirstUntilAnotherIsChosen();
  void propertiesFollowTheirObjectInTheList();
  void propertiesOfAnObjectThatIsGoneAreClosed();
  void whatIsAnsweredToALeakIsForItsObject();
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

void ObjectsWindowTest::aLockedObjectStaysSoWhenTheBrushIsAnotherOne() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QAction *paint = window->commands()[Command::paintWalls],
          *atCrosshair = window->commands()[Command::wallAtCrosshair];
  QVERIFY(paint->isEnabled() && atCrosshair->isEnabled());
  window->document().setObjectLocked(0, true);
  QVERIFY(!paint->isEnabled() && !atCrosshair->isEnabled());
  const double radius = window->viewState().brush().radius();
  window->commands()[Command::largerBrush]->trigger();
  QVERIFY(window->viewState().brush().radius() > radius);
  QVERIFY(!paint->isEnabled() && !atCrosshair->isEnabled());
  window->document().setObjectLocked(0, false);
  QVERIFY(paint->isEnabled() && atCrosshair->isEnabled());
}

//! Also where the two have equally many.
void ObjectsWindowTest::theTableOfEventsIsThatOfTheActiveObject() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  auto* events = window->findChild<ui::EventTable*>();
  QVERIFY(events);
  const QSignalSpy reset(events, &QAbstractItemModel::modelReset);
  window->document().setActiveObject(0);
  QVERIFY(!reset.isEmpty());
  QCOMPARE(events->rowCount(), 0);
}

//! Also where that of the other one has the same number and iteration.
void ObjectsWindowTest::theInspectedEventIsThatOfTheActiveObject() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  const int first = cutBall(*window, kLeft);
  QVERIFY(first >= 0);
  document.addObject();
  QCOMPARE(cutBall(*window, kRight), first);
  window->showStep(Command::stepGrow);
  const auto isTold = [&] {
    const Event& event = document.events().at(static_cast<std::size_t>(first));
    return shownText(*window, "Event").contains(ui::place(event.location, document.volume().grid));
  };
  QVERIFY(isTold());
  document.setActiveObject(0);
  QCOMPARE(document.iteration(), 2);
  QCOMPARE(window->inspector().event(), first);
  QVERIFY(isTold());
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
  const QLabel* fault = called<QLabel>(*dialog, "What is wrong");
  QVERIFY(fault && fault->isVisible() && fault->textFormat() == Qt::PlainText);
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

void ObjectsWindowTest::theChosenColourOfASingleObjectIsThatOfItsOutline() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  window->viewState().setCrosshair(kLeft);
  QTest::keyClick(window.get(), Qt::Key_Return);
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  const QColor chosen(204, 0, 204);  // nothing else is
  ui::SliceView& slice = window->views().slice(ui::Plane::axial);
  QVERIFY(!hasColour(slice.picture(), chosen));
  ObjectLabel label = document.objectInfo(0).label;
  label.colour = {204, 0, 204};
  document.setObjectLabel(0, label, QStringLiteral("Change object"));
  QVERIFY(hasColour(slice.picture(), chosen));
}

void ObjectsWindowTest::aTermOfAFileStandsFirstUntilAnotherIsChosen() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  ObjectLabel label = document.objectInfo(0).label;
  label.source.terminology = Terminology{
      {"T-D0050", "SRT", "Tissue"}, {{"T-71000", "SRT", "Kidney"}, {{"G-A101", "SRT", "Left"}}}, {}};
  label.source.algorithm = SegmentAlgorithm{AlgorithmType::automatic, "Net"};
  document.setObjectLabel(0, label, QStringLiteral("Change object"));
  const auto choose = [&](int index) {
    window->activateWindow();  // a dialog that closes leaves none active without a window manager
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_F2);
    auto* dialog = window->findChild<ui::ObjectDialog*>();
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
    auto* term = dialog->findChild<QComboBox*>();
    QCOMPARE(term->currentText(), QString("Kidney, Left"));
    QCOMPARE(term->count(), static_cast<int>(terms().size()) + 1);
    if (index < 0) index = term->findData("liver");
    term->setCurrentIndex(index);
    Q_EMIT term->activated(index);
    dialog->accept();
    QTRY_VERIFY(!window->findChild<ui::ObjectDialog*>());
  };
  choose(0);
  QVERIFY(document.objectInfo(0).label == label);
  choose(-1);
  QCOMPARE(document.objectInfo(0).label.term, std::string("liver"));
  QVERIFY(!document.objectInfo(0).label.source.terminology);
  QVERIFY(document.objectInfo(0).label.source.algorithm == label.source.algorithm);
}

void ObjectsWindowTest::propertiesFollowTheirObjectInTheList() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QTest::keyClick(window.get(), Qt::Key_F2);
  auto* dialog = window->findChild<ui::ObjectDialog*>();
  QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
  document.moveObject(1, 0);  // as what is opened in the background moves it
  dialog->findChild<QLineEdit*>()->setText("Cyst");
  dialog->accept();
  QCOMPARE(document.objectInfo(0).label.name, std::string("Cyst"));
  QCOMPARE(document.objectInfo(1).label.name, std::string("Object"));
}

void ObjectsWindowTest::propertiesOfAnObjectThatIsGoneAreClosed() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  ui::Document& document = window->document();
  const auto openDialog = [&]() -> ui::ObjectDialog* {
    window->activateWindow();
    if (!QTest::qWaitForWindowActive(window.get())) return nullptr;
    QTest::keyClick(window.get(), Qt::Key_F2);
    auto* dialog = window->findChild<ui::ObjectDialog*>();
    return dialog && QTest::qWaitForWindowExposed(dialog) ? dialog : nullptr;
  };
  QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
  QVERIFY(openDialog());
  document.undoStack()->undo();
  QTRY_VERIFY(!window->findChild<ui::ObjectDialog*>());
  QVERIFY(openDialog());
  QVERIFY(open(*window, sample("cyst.nii.gz")));
  QTRY_VERIFY(!window->findChild<ui::ObjectDialog*>());
}

void ObjectsWindowTest::whatIsAnsweredToALeakIsForItsObject() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("dumbbell.mha");
  writeVolume(testing::dumbbellVolume(), path.toStdString());
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  ui::Document& document = window->document();
  document.addSeed({testing::kLeftBall, 3.0});
  Parameters parameters = document.parameters();
  parameters.range = IntensityRange{-1000, 100};
  document.setParameters(parameters, QStringLiteral("Range"));
  document.setPausesAtLeaks(true);
  document.run();
  QVERIFY(QTest::qWaitFor(
      [&] { return !document.leaks().empty() && document.state() == GrowthState::paused; }, kPatience));
  const int before = document.leaks()[0].before;
  QTRY_VERIFY(saying<QPushButton>(window->messages(), "Go back"));
  document.addObject();
  saying<QPushButton>(window->messages(), "Go back")->click();
  QCOMPARE(document.activeObject(), 0);
  QTRY_COMPARE(document.iteration(), before);

  document.goTo(document.lastIteration());
  QTRY_COMPARE(document.iteration(), document.lastIteration());
  Q_EMIT document.leaked(0);
  document.setActiveObject(1);
  saying<QPushButton>(window->messages(), "Go on")->click();
  QCOMPARE(document.activeObject(), 0);
  QVERIFY(waitFor(*window, GrowthState::finished));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  ObjectsWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "objects_window_test.moc"
