// Limits of the topology in the step Grow by mouse and keys: free, never more than, ask each time; what is
// asked, and both answers.

#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QUndoStack>

#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/grow/held_section.h"
#include "ui/window/grow/topology_section.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

//! The sample, in which two fronts meet behind a needle, with the step Grow shown.
struct Opened {
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = window && open(*window, sample("cyst_session.json"));
  Opened() {
    if (ok) window->showStep(Command::stepGrow);
  }
  ui::Document& document() { return window->document(); }
  const TopologyLimits& limits() { return document().constraints().topology; }
  ui::TopologySection* section() { return window->findChild<ui::TopologySection*>(); }
  QSpinBox* count(const char* name) {
    const auto all = section()->findChildren<QSpinBox*>();
    for (QSpinBox* field : all)
      if (field->accessibleName() == name) return field;
    return nullptr;
  }
  //! By key, as the list is.
  void choose(Qt::Key key) { QTest::keyClick(section()->findChild<QComboBox*>(), key); }
  //! Grows until it is asked something.
  bool isAsked() {
    QTest::keyClick(window.get(), Qt::Key_Space);
    return QTest::qWaitFor(
        [&] {
          return document().state() == GrowthState::paused && document().snapshot() &&
                 !document().openQuestions().empty();
        },
        kPatience);
  }
  ui::MessageBar* message() { return window->findChild<ui::MessageBar*>(); }
  template <typename Parent>
  bool press(Parent* parent, const QString& text) {
    const auto all = parent->template findChildren<QAbstractButton*>();
    for (QAbstractButton* b : all)
      if (b->isVisible() && b->text() == text) {
        QTest::mouseClick(b, Qt::LeftButton);
        return true;
      }
    return false;
  }
  int genus() { return document().snapshot()->certificate.genus.at(0); }
  void keepPicture(const char* name) {
    const QString pictures = qEnvironmentVariable("HANDLEBODY_KEEP_PICTURES");
    if (pictures.isEmpty()) return;
    QTest::qWait(300);
    window->grab().save(pictures + '/' + name + ".png");
  }
};

}  // namespace

class QuestionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theLimitsAreChosenAndTakenBack();
  void theGrowthPausesAsksAndHolds();
  void whatIsUndoneIsAskedAgainAndMayHappen();
  void neverMoreThanListsWhatIsHeldAndDoesNotPause();
  void theAnswerIsForTheObjectThatAsked();
};

void QuestionTest::theLimitsAreChosenAndTakenBack() {
  Opened o;
  QVERIFY(o.ok);
  QVERIFY(!o.count("Genus at most")->isVisible());
  o.choose(Qt::Key_Down);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Limit the topology"));
  QVERIFY(o.limits().components == 1 && o.limits().genus == 0 && !o.limits().asks);
  QVERIFY(o.count("Genus at most")->isVisible());
  o.choose(Qt::Key_Down);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Ask about the topology"));
  QVERIFY(o.limits().asks);
  QSpinBox* genus = o.count("Genus at most");
  QTest::keyClick(genus, Qt::Key_Up);
  QVERIFY(o.limits().genus == 1);
  QTest::keyClick(o.count("Components at most"), Qt::Key_Down);
  QVERIFY(!o.limits().components && o.limits().genus == 1 && o.limits().asks);
  QCOMPARE(o.count("Components at most")->text(), QString("any"));
  QTest::keyClick(genus, Qt::Key_Down);
  QTest::keyClick(genus, Qt::Key_Down);  // neither is limited: that is free
  QVERIFY(o.limits().empty());
  QVERIFY(!genus->isVisible());
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.limits().genus == 0 && o.limits().asks && genus->isVisible());
  o.choose(Qt::Key_Home);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Free topology"));
  QVERIFY(o.limits().empty());
}

void QuestionTest::theGrowthPausesAsksAndHolds() {
  Opened o;
  QVERIFY(o.ok);
  o.choose(Qt::Key_End);
  QVERIFY(o.isAsked());
  const HeldPlace held = o.document().openQuestions().front();
  QTRY_COMPARE(o.window->viewState().crosshair(), held.place);
  QCOMPARE(o.document().iteration(), held.iteration);
  QTRY_VERIFY(o.message()->isVisible());
  const QString text = o.message()->text();
  QVERIFY2(text.startsWith(QString("Held at iteration %1: its fronts would meet at ").arg(held.iteration)) &&
               text.contains(" mm around"),
           qPrintable(text));
  QCOMPARE(shownText(*o.window, "To decide"), text);
  o.keepPicture("question");
  QTRY_VERIFY2(layoutFaults(*o.window).isEmpty(), qPrintable(layoutFaults(*o.window).join("; ")));
  QVERIFY(o.press(o.message(), "Hold it"));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Hold it"));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QCOMPARE(o.genus(), 0);
  QVERIFY(shownText(*o.window, "To decide").isEmpty());
  o.keepPicture("held");
}

void QuestionTest::whatIsUndoneIsAskedAgainAndMayHappen() {
  Opened o;
  QVERIFY(o.ok);
  o.choose(Qt::Key_End);
  QVERIFY(o.isAsked());
  QTRY_VERIFY(o.message()->isVisible());
  const int asked = o.document().iteration();
  QVERIFY(o.press(o.message(), "Hold it"));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  o.document().goTo(asked);
  QTRY_COMPARE(o.document().iteration(), asked);
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(!shownText(*o.window, "To decide").isEmpty());
  QVERIFY(o.press(o.section(), "Let it happen"));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Let it happen"));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QCOMPARE(o.genus(), 1);
  bool isMarked = false;
  for (const ui::ChangeMark& mark : o.document().changeMarks())
    isMarked = isMarked || (mark.iteration == asked && mark.what.contains("Decided: let it happen"));
  QVERIFY(isMarked);
  o.keepPicture("happened");
}

void QuestionTest::neverMoreThanListsWhatIsHeldAndDoesNotPause() {
  Opened o;
  QVERIFY(o.ok);
  QSignalSpy asked(&o.document(), &ui::Document::asked);
  o.choose(Qt::Key_Down);
  QTest::keyClick(o.window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QCOMPARE(o.genus(), 0);
  QVERIFY(asked.isEmpty());
  o.window->showStep(Command::stepCorrect);
  const auto* table = o.window->findChild<ui::HeldSection*>()->findChild<QTableWidget*>();
  bool isListed = false;
  for (int i = 0; i < table->rowCount(); ++i)
    isListed = isListed || table->item(i, 0)->text().startsWith("Held: Handle inserted, ");
  QVERIFY(isListed);
}

void QuestionTest::theAnswerIsForTheObjectThatAsked() {
  Opened o;
  QVERIFY(o.ok);
  o.choose(Qt::Key_End);
  QVERIFY(o.isAsked());
  QTRY_VERIFY(o.message()->isVisible());
  o.document().addObject();
  QCOMPARE(o.document().activeObject(), 1);
  QVERIFY(o.press(o.message(), "Hold it"));
  QCOMPARE(o.document().activeObject(), 0);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Hold it"));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  QuestionTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "question_test.moc"
