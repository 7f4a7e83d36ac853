// What a crash left behind: the offer to restore it, and a reading that is cancelled.

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProgressBar>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include "tests/ui/window/window_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

const char* const kOther = "cyst.nii.gz";

//! A journal whose program was killed: one click in the sample. `isNamed`: it says where that is.
QString leaveJournal(bool isNamed = true) {
  const auto old = ui::Document::recoverable();
  for (const QString& path : old) ui::Document::discardRecoverable(path);
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/journal");
  folder.mkpath(".");
  const QJsonValue volume = isNamed ? QJsonValue(sample(kOther)) : QJsonValue(QJsonValue::Null);
  const QJsonObject click{{"centre", QJsonArray{77.0, 49.0, 85.0}}, {"radius", 8.0}};
  const QJsonObject all{{"version", "0.1.0"},
                        {"input", QJsonObject{{"path", volume}, {"sha256", QJsonValue::Null}}},
                        {"requested", QJsonObject{{"seeds", QJsonArray{click}}}}};
  QFile file(folder.filePath("killed.json"));
  const bool isWritten = file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(all).toJson()) > 0;
  return isWritten ? file.fileName() : QString();
}

bool isOffered(ui::MainWindow& window) {
  const QAbstractButton* restore = buttonSaying(window, "Restore");
  return window.messages().isVisible() && restore && restore->isVisible();
}

//! A window that offers what was left; null if it does not.
std::unique_ptr<ui::MainWindow> offeringWindow() {
  auto window = shownWindow();
  if (window) window->files().offerRecovery();
  return window && isOffered(*window) ? std::move(window) : nullptr;
}

QToolButton* cancelButton(ui::MainWindow& window) {
  const auto buttons = window.statusBar()->findChildren<QToolButton*>();
  for (QToolButton* button : buttons)
    if (button->accessibleName() == "Cancel") return button;
  return nullptr;
}

//! No event is handled meanwhile, so that the reading has not ended when `act` is done.
template <typename Act>
bool opensOtherAfter(ui::MainWindow& window, Act&& act) {
  buttonSaying(window, "Restore")->click();
  act();
  return open(window, sample(kOther)) && window.document().seeds().empty();
}

}  // namespace

class RecoveryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsRestoredIsNotOfferedAgain();
  void theJournalStaysWhenItsReadingIsCancelled();
  void theJournalStaysWhenAnotherFileIsOpenedInstead();
  void theJournalStaysWhenItAsksForAFileAndAnotherIsOpened();
  void theOfferStaysWhenAFileIsOpened();
  void thatNothingIsKeptForACrashIsSeen();
  void theOfferIsSeenAgainAfterWhatIsSaidMeanwhile();
  void anOfferThatIsClosedGoes();
  void restoringAsksAboutUnsavedWork();
  void aCancelledReadingLeavesTheStatusBar();
};

void RecoveryTest::whatIsRestoredIsNotOfferedAgain() {
  const QString journal = leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window);
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  buttonSaying(*window, "Restore")->click();
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().seeds().size(), std::size_t{1});
  QVERIFY(window->document().isModified());
  QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(journal), kPatience);  // when its own is written
  QVERIFY(!isOffered(*window));
}

void RecoveryTest::theJournalStaysWhenItsReadingIsCancelled() {
  const QString journal = leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window && cancelButton(*window));
  QVERIFY(opensOtherAfter(*window, [&] { cancelButton(*window)->click(); }));
  QVERIFY(QFile::exists(journal));
  QVERIFY(ui::Document::recoverable().contains(journal));
}

void RecoveryTest::theJournalStaysWhenAnotherFileIsOpenedInstead() {
  const QString journal = leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window);
  QVERIFY(opensOtherAfter(*window, [] {}));
  QVERIFY(QFile::exists(journal));
}

void RecoveryTest::theJournalStaysWhenItAsksForAFileAndAnotherIsOpened() {
  const QString journal = leaveJournal(false);
  auto window = offeringWindow();
  QVERIFY(window);
  QSignalSpy asked(&window->document(), &ui::Document::fileNeeded);
  QVERIFY(opensOtherAfter(*window, [&] { asked.wait(kPatience); }));
  QCOMPARE(asked.size(), 1);
  QVERIFY(QFile::exists(journal));
}

void RecoveryTest::theOfferStaysWhenAFileIsOpened() {
  const QString journal = leaveJournal();
  auto window = shownWindow();
  QVERIFY(window);
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  window->files().open(sample(kOther));  // as `handlebody cyst.nii.gz` does
  window->files().offerRecovery();
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QVERIFY(isOffered(*window));
  QVERIFY(QFile::exists(journal));
  buttonSaying(*window, "Discard")->click();
  QVERIFY(!window->messages().isVisible());
  QVERIFY(!QFile::exists(journal));
}

void RecoveryTest::thatNothingIsKeptForACrashIsSeen() {
  auto window = shownWindow();
  QVERIFY(window);
  Q_EMIT window->document().journalFailed(QStringLiteral("Nothing is kept."));
  QVERIFY(window->messages().isVisible());
  QCOMPARE(window->messages().text(), QString("Nothing is kept."));
}

void RecoveryTest::theOfferIsSeenAgainAfterWhatIsSaidMeanwhile() {
  leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window);
  ui::MessageBar& messages = window->messages();
  const QString offer = messages.text();
  messages.show(ui::MessageBar::Kind::error, QStringLiteral("It cannot be read."));
  QVERIFY(!isOffered(*window));
  messages.dismiss();
  QVERIFY(isOffered(*window));
  bool isTaken = false;
  messages.show(ui::MessageBar::Kind::warning, QStringLiteral("It leaks."),
                {{QStringLiteral("Put it right"), [&] { isTaken = true; }}});
  buttonSaying(*window, "Put it right")->click();
  QVERIFY(isTaken);
  QVERIFY(isOffered(*window));
  QCOMPARE(messages.text(), offer);
}

void RecoveryTest::anOfferThatIsClosedGoes() {
  const QString journal = leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window);
  const auto buttons = window->messages().findChildren<QToolButton*>();
  QCOMPARE(buttons.size(), 1);
  buttons.front()->click();
  QVERIFY(!window->messages().isVisible());
  QVERIFY(open(*window, sample(kOther)));
  QVERIFY(!isOffered(*window));
  QVERIFY(QFile::exists(journal));  // for the next start
}

void RecoveryTest::restoringAsksAboutUnsavedWork() {
  const QString journal = leaveJournal();
  auto window = offeringWindow();
  QVERIFY(window && open(*window, sample(kOther)));
  window->document().addSeed({Vec3(77, 49, 85), {}});
  QString asked;
  QTimer::singleShot(500, window.get(), [&] {
    QWidget* question = QApplication::activeModalWidget();
    if (!question) return;
    asked = question->windowTitle();
    question->close();
  });
  buttonSaying(*window, "Restore")->click();
  QCOMPARE(asked, QString("Unsaved work"));
  QVERIFY(!window->document().isOpening());
  QVERIFY(QFile::exists(journal));
}

void RecoveryTest::aCancelledReadingLeavesTheStatusBar() {
  auto window = shownWindow();
  QVERIFY(window);
  const auto* progress = window->statusBar()->findChild<QProgressBar*>();
  QToolButton* cancel = cancelButton(*window);
  QVERIFY(progress && cancel);
  window->files().open(sample(kOther));
  QVERIFY(progress->isVisible() && cancel->isVisible());
  cancel->click();
  QVERIFY(!progress->isVisible() && !cancel->isVisible());
  QCOMPARE(shownText(*window, "State of the growth"), QString("Nothing is open"));
  QTest::qWait(1000);
  QVERIFY(!window->document().hasVolume());
  QVERIFY(!progress->isVisible());
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  RecoveryTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "recovery_test.moc"
