// Questions about unsaved work: when they are asked, and that nothing is lost without one.

#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
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

//! Presses the button of the question that is asked next, soon; closes one that has no such button.
void pressSoon(const char* text) {
  QTimer::singleShot(300, qApp, [text] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    const auto buttons = box->buttons();
    for (QAbstractButton* button : buttons)
      if (button->text().contains(QLatin1String(text))) return button->click();
    box->reject();
  });
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

//! A seed in the sample's volume, saved in a session.
struct Saved {
  QTemporaryDir folder;
  QString session = folder.filePath("session.json");
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = window && open(*window, sample(kVolume)) && save();

  //! The same volume in another file.
  QString other() const {
    const QString path = folder.filePath("other.nii.gz");
    QFile::copy(sample(kVolume), path);
    return path;
  }
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

//! Saves as `path` when what is being opened has been read, in the question for the name.
void saveAsWhenRead(ui::MainWindow& window, const QString& path) {
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog || !window.document().isOpeningWaiting()) return;
    if (auto* edit = dialog->findChild<QLineEdit*>("fileNameEdit")) edit->setText(path);
    dialog->accept();
  });
  timer.start(100);
  window.files().saveAs();
}

}  // namespace

class UnsavedTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aWindowThatIsSavedCloses();
  void whatIsChangedWhileItIsSavedIsAskedAbout();
  void aWindowThatStaysOpenAsksTheNextTime();
  void aSessionThatIsBeingWrittenIsWaitedFor();
  void theWindowStaysWhereTheSessionCannotBeWritten();
  void whatIsSavedElsewhereIsNotReplacedUnasked();
  void whatIsDoneWhileAFileIsReadIsAskedAbout();
  void whatIsSavedWhileAFileIsReadIsNotAskedAbout();
  void nothingTakesThePlaceOfWhatANameIsAskedFor();
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

//! Nothing is unsaved by then, so that nothing is asked.
void UnsavedTest::aSessionThatIsBeingWrittenIsWaitedFor() {
  Saved s;
  QVERIFY(s.ok);
  QVERIFY(QFile::remove(s.session));
  const Answers answers;
  QSignalSpy saved(&s.document(), &ui::Document::sessionSaved);
  s.window->files().save();
  s.window->close();
  QVERIFY(s.window->isVisible());
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QVERIFY(QFile::exists(s.session));
  QTRY_VERIFY(!s.window->isVisible());
  QCOMPARE(answers.asked(), 0);
}

void UnsavedTest::theWindowStaysWhereTheSessionCannotBeWritten() {
  Saved s;
  QVERIFY(s.ok);
  const Answers answers;
  QSignalSpy saved(&s.document(), &ui::Document::sessionSaved);
  s.window->files().save();
  s.window->close();
  Q_EMIT s.document().saveFailed(QStringLiteral("There is no room."));  // before how it really ended is told
  QCOMPARE(s.window->messages().text(), QString("There is no room."));
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QTest::qWait(300);
  QVERIFY(s.window->isVisible());
  QCOMPARE(answers.asked(), 0);
}

void UnsavedTest::whatIsSavedElsewhereIsNotReplacedUnasked() {
  Saved s;
  QVERIFY(s.ok);
  QFile elsewhere(s.session);
  QVERIFY(elsewhere.open(QIODevice::Append) && elsewhere.write("\n\n") == 2);
  elsewhere.close();
  const QByteArray there = contentOf(s.session);
  QSignalSpy saved(&s.document(), &ui::Document::sessionSaved);
  s.setRadius(9);
  {
    const Answers cancel;
    s.window->files().save();
    QCOMPARE(cancel.asked(), 1);
  }
  QTest::qWait(300);
  QVERIFY(saved.isEmpty() && s.document().isModified());
  QCOMPARE(contentOf(s.session), there);

  pressSoon("Overwrite");
  s.window->files().save();
  QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
  QVERIFY(contentOf(s.session) != there && !s.document().isModified());

  const Answers none;
  s.setRadius(10);
  s.window->files().save();
  QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 2, kPatience);
  QCOMPARE(none.asked(), 0);
}

void UnsavedTest::whatIsDoneWhileAFileIsReadIsAskedAbout() {
  Saved s;
  QVERIFY(s.ok);
  const Answers answers({QMessageBox::Cancel, QMessageBox::Discard});
  QSignalSpy opened(&s.document(), &ui::Document::opened);
  s.window->files().open(s.other());
  QCOMPARE(answers.asked(), 0);  // nothing is unsaved
  s.setRadius(9);
  QTRY_COMPARE_WITH_TIMEOUT(answers.asked(), 1, kPatience);
  QTRY_VERIFY(!s.document().isOpening());
  QVERIFY(opened.isEmpty());
  QVERIFY(s.document().isModified());
  QVERIFY(shownText(*s.window, "State of the growth") != QString("Reading other.nii.gz…"));

  s.window->files().open(s.other());
  QCOMPARE(answers.asked(), 2);
  QVERIFY(opened.wait(kPatience));  // what was discarded is not asked about again
  QCOMPARE(answers.asked(), 2);
  QCOMPARE(s.document().path(), s.other());
}

void UnsavedTest::whatIsSavedWhileAFileIsReadIsNotAskedAbout() {
  Saved s;
  QVERIFY(s.ok);
  const Answers answers;
  QSignalSpy opened(&s.document(), &ui::Document::opened);
  s.window->files().open(s.other());
  s.setRadius(9);
  s.window->files().save();
  QVERIFY(opened.wait(kPatience));
  QCOMPARE(answers.asked(), 0);
  QCOMPARE(s.document().path(), s.other());
  QVERIFY(s.document().sessionPath().isEmpty());
}

void UnsavedTest::nothingTakesThePlaceOfWhatANameIsAskedFor() {
  Saved s;
  QVERIFY(s.ok);
  const QString path = s.folder.filePath("again.json");
  QSignalSpy opened(&s.document(), &ui::Document::opened);
  s.window->files().open(s.other());
  saveAsWhenRead(*s.window, path);
  QVERIFY(opened.isEmpty());
  QVERIFY(opened.wait(kPatience));
  QCOMPARE(s.document().path(), s.other());
  QVERIFY(open(*s.window, path));
  QCOMPARE(QFileInfo(s.document().path()).fileName(), QString(kVolume));
  QCOMPARE(s.document().seeds().size(), std::size_t{1});
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
