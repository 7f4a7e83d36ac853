// Questions about unsaved work: when they are asked, and that nothing is lost without one.

#include <QMessageBox>
#include <QTimer>

#include "tests/ui/window/window_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

const char* const kVolume = "cyst.nii.gz";

//! Answers the questions that are asked while it lives, one after the other; those after the last with
//! Cancel.
class Answers {
 public:
  explicit Answers(std::vector<QMessageBox::StandardButton> answers = {}) : answers_(std::move(answers)) {
    QObject::connect(&timer_, &QTimer::timeout, [this] { answer(); });
    timer_.start(100);
  }
  int asked() const { return asked_; }

 private:
  void answer() {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    const auto next = static_cast<std::size_t>(asked_++);
    box->button(next < answers_.size() ? answers_[next] : QMessageBox::Cancel)->click();
  }

  std::vector<QMessageBox::StandardButton> answers_;
  int asked_ = 0;
  QTimer timer_;
};

//! A seed in the sample's volume, saved in a session.
struct Saved {
  QTemporaryDir folder;
  QString session = folder.filePath("session.json");
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = window && open(*window, sample(kVolume)) && save();

  ui::Document& document() { return window->document(); }
  void setRadius(double radius) { document().setSeedRadius(0, radius); }
  bool save() {
    document().addSeed({Vec3(77, 49, 85), 8.0});
    QSignalSpy saved(&document(), &ui::Document::sessionSaved);
    document().saveSession(session);
    return (!saved.isEmpty() || saved.wait(kPatience)) && !document().isModified();
  }
  //! Presses "Save" when it is closed, and waits until that is done. `meanwhile`: until then.
  template <typename Meanwhile>
  bool closeWithSave(Meanwhile&& meanwhile) {
    QSignalSpy saved(&document(), &ui::Document::sessionSaved);
    window->close();
    meanwhile();
    return !saved.isEmpty() || saved.wait(kPatience);
  }
};

}  // namespace

class UnsavedTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aWindowThatIsSavedCloses();
  void whatIsChangedWhileItIsSavedIsAskedAbout();
  void aWindowThatStaysOpenAsksTheNextTime();
};

void UnsavedTest::aWindowThatIsSavedCloses() {
  Saved s;
  QVERIFY(s.ok);
  s.setRadius(9);
  const Answers answers({QMessageBox::Save});
  QVERIFY(s.closeWithSave([] {}));
  QTRY_VERIFY(!s.window->isVisible());
  QCOMPARE(answers.asked(), 1);
}

void UnsavedTest::whatIsChangedWhileItIsSavedIsAskedAbout() {
  Saved s;
  QVERIFY(s.ok);
  s.setRadius(9);
  const Answers answers({QMessageBox::Save, QMessageBox::Cancel});
  QVERIFY(s.closeWithSave([&] { s.setRadius(10); }));
  QTRY_COMPARE(answers.asked(), 2);
  QTest::qWait(300);
  QVERIFY(s.window->isVisible());
  QVERIFY(s.document().isModified());
}

void UnsavedTest::aWindowThatStaysOpenAsksTheNextTime() {
  Saved s;
  QVERIFY(s.ok);
  s.setRadius(9);
  const Answers answers({QMessageBox::Save, QMessageBox::Cancel});
  const QString file = s.folder.filePath("surface.stl");
  QVERIFY(s.closeWithSave([&] { Q_EMIT s.document().exporting(file); }));
  const auto stay = [&] { return buttonSaying(*s.window, "Stay open"); };
  QTRY_VERIFY(stay() && stay()->isVisible());
  stay()->click();
  Q_EMIT s.document().exported(file);
  QTest::qWait(300);
  QVERIFY(s.window->isVisible());
  s.setRadius(10);
  s.window->close();
  QCOMPARE(answers.asked(), 2);
  QVERIFY(s.window->isVisible());
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  QApplication::setQuitOnLastWindowClosed(false);  // the tests after it go on
  UnsavedTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "unsaved_test.moc"
