// What step 6 writes of several objects.

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSemaphore>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>

#include "tests/ui/window/two_balls.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/open/file_work.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

std::vector<int> valuesOf(const QString& path) {
  const Volume map = readVolume(path.toStdString());
  std::vector<int> values;
  visitVoxels(map, [&](const auto* voxels) {
    for (std::size_t i = 0; i < map.grid.voxelCount(); ++i) values.push_back(static_cast<int>(voxels[i]));
  });
  return values;
}

//! What a user does while `work` asks: a name that is typed for each dialog of files (empty: cancelled), yes
//! or no for each question, whose texts it gives.
struct Asked {
  QStringList names;
  std::vector<QMessageBox::StandardButton> answers;
};
QStringList questionsOf(const std::function<void()>& work, Asked asked) {
  QStringList questions;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    QWidget* open = QApplication::activeModalWidget();
    if (auto* box = qobject_cast<QMessageBox*>(open)) {
      questions << box->text();
      const auto answer = asked.answers.empty() ? QMessageBox::No : asked.answers.front();
      if (!asked.answers.empty()) asked.answers.erase(asked.answers.begin());
      box->button(answer)->click();
    } else if (auto* dialog = qobject_cast<QDialog*>(open)) {
      const QString name = asked.names.isEmpty() ? QString() : asked.names.takeFirst();
      if (auto* edit = dialog->findChild<QLineEdit*>("fileNameEdit")) edit->setText(name);
      name.isEmpty() ? dialog->reject() : dialog->accept();
    }
  });
  timer.start(200);
  work();
  return questions;
}

void writeWord(const QString& path) {
  QFile file(path);
  if (file.open(QIODevice::WriteOnly)) file.write("mine");
}

bool holdsWord(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) && file.readAll() == "mine";
}

}  // namespace

class ExportedObjectsWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void allAreExportedTogether();
  void eachIsExportedAlone();
  void nothingIsExportedOfAllWhileOneGrows();
  void whatIsThereIsAskedAbout();
  void theWindowClosesWhenAFileIsWritten();
  void theWindowClosesWhenMeasuresAreWritten();
  void nothingIsWrittenIntoTheVolume();
  void picturesAndTablesAreNotWrittenIntoTheVolume();
  void whatIsBetteredIsChosenAndTold();
  void aNameIsProposedThatTheDialogTakesAsOne();
  void ofSeveralFilesTheOneThatIsWrittenIsNamed();
  void whyNothingIsWrittenGoesWithItsVolume();
};

void ExportedObjectsWindowTest::allAreExportedTogether() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  QVERIFY(panel->which() == ui::ExportPanel::Objects::together);
  const QLabel* numbers = shownLabel(*window, "What is written");
  QVERIFY(numbers && numbers->text().contains("2"));
  QSignalSpy exported(&window->document(), &ui::Document::exported);
  const QString path = folder.filePath("all.nrrd");
  window->document().exportObjects(path, panel->space());
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  const std::vector<int> values = valuesOf(path);
  QCOMPARE(std::set<int>(values.begin(), values.end()), (std::set<int>{0, 1, 2}));
}

//! What each file of its own holds together is what the file of all of them does.
void ExportedObjectsWindowTest::eachIsExportedAlone() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  auto* choice = called<QComboBox>(*panel, "Objects");
  QVERIFY(choice && choice->isVisible());
  choice->setCurrentText("Each object in a file of its own");
  QVERIFY(panel->which() == ui::ExportPanel::Objects::each);
  QVERIFY(shownLabel(*window, "What is written")->text().contains("2"));
  ui::Document& document = window->document();
  const QStringList paths = document.objectPaths(folder.filePath("alone.nrrd"), ".nrrd", false);
  QCOMPARE(paths.size(), 2);
  QSignalSpy exported(&document, &ui::Document::exported);
  document.exportEachObject(folder.filePath("alone.nrrd"), ".nrrd", panel->space());
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QCOMPARE(exported.first().first().toString(), folder.filePath("alone_*.nrrd"));
  document.exportObjects(folder.filePath("all.nrrd"), panel->space());
  QVERIFY(exported.count() == 2 || exported.wait(kPatience));
  const std::vector<int> all = valuesOf(folder.filePath("all.nrrd")), first = valuesOf(paths[0]),
                         second = valuesOf(paths[1]);
  QVERIFY(std::count(first.begin(), first.end(), 1) > 0 && std::count(second.begin(), second.end(), 2) > 0);
  for (std::size_t i = 0; i < all.size(); ++i) QCOMPARE(all[i], first[i] + second[i]);
}

void ExportedObjectsWindowTest::nothingIsExportedOfAllWhileOneGrows() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  ui::Document& document = window->document();
  QAction* result = window->commands()[Command::exportResult];
  QAction* report = window->commands()[Command::exportReport];
  const QString tip = result->toolTip();
  document.goToStart();
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == 0; }, kPatience));
  document.run();
  document.setActiveObject(0);
  QVERIFY(!document.allFault().isEmpty());
  QVERIFY(!result->isEnabled() && !report->isEnabled());
  QVERIFY2(result->toolTip().contains("still grows"), qPrintable(result->toolTip()));
  auto* choice = called<QComboBox>(*window->findChild<ui::ExportPanel*>(), "Objects");
  choice->setCurrentText("The active object");
  QVERIFY(result->isEnabled() && !report->isEnabled());
  QCOMPARE(result->toolTip(), tip);
  choice->setCurrentText("All objects in one file");
  QVERIFY(!result->isEnabled());
  QVERIFY(QTest::qWaitFor([&] { return document.allFault().isEmpty(); }, kPatience));
  QVERIFY(result->isEnabled() && report->isEnabled());
  QCOMPARE(result->toolTip(), tip);
}

void ExportedObjectsWindowTest::theWindowClosesWhenAFileIsWritten() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  ui::Document& document = window->document();
  QSignalSpy saved(&document, &ui::Document::sessionSaved);
  document.saveSession(folder.filePath("s.json"));  // so that nothing is asked
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QSignalSpy exported(&document, &ui::Document::exported), failed(&document, &ui::Document::exportFailed);
  document.exportResult(folder.filePath("missing/ball.stl"), CoordinateSpace::lps);
  QVERIFY(!window->close());
  QVERIFY(!failed.isEmpty() || failed.wait(kPatience));
  QTest::qWait(100);
  QVERIFY(window->isVisible());  // with what went wrong
  document.exportResult(folder.filePath("ball.stl"), CoordinateSpace::lps);
  QVERIFY(!window->close());
  QVERIFY(window->isVisible() && window->messages().text().contains("is being written"));
  QVERIFY(QTest::qWaitFor([&] { return !window->isVisible(); }, kPatience));
  QCOMPARE(exported.size(), 1);
  QVERIFY(QFileInfo::exists(folder.filePath("ball.stl")));
}

void ExportedObjectsWindowTest::theWindowClosesWhenMeasuresAreWritten() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  const QString path = folder.filePath("m.ply");
  const auto goesOn = std::make_shared<QSemaphore>();  // what is written waits for it
  const auto save = [&](const ui::FileWriter& write) {
    const auto later = [goesOn, write](const std::string& name) {
      if (goesOn->tryAcquire(1, kPatience)) write(name);
    };
    questionsOf([&] { window->files().saveFile("Save", "mesh", ".ply", later); }, {{path}, {}});
  };
  save([](const std::string&) { throw std::runtime_error("The disk is full."); });
  QVERIFY(!window->close());
  goesOn->release();
  QTRY_VERIFY_WITH_TIMEOUT(window->messages().text().contains("disk is full"), kPatience);
  QTest::qWait(100);
  QVERIFY(window->isVisible());
  save([](const std::string& name) { writeWord(QString::fromStdString(name)); });
  QVERIFY(!window->close());
  QVERIFY(window->isVisible() && window->messages().text().contains("is being written"));
  goesOn->release();
  QVERIFY(QTest::qWaitFor([&] { return !window->isVisible(); }, kPatience));
  QVERIFY(holdsWord(path));
}

void ExportedObjectsWindowTest::nothingIsWrittenIntoTheVolume() {
  const QTemporaryDir folder;
  const QString scan = folder.filePath("scan"), name = QFileInfo(writeBalls(folder)).fileName();
  QVERIFY(QDir().mkdir(scan) && QFile::rename(folder.filePath(name), scan + "/" + name));
  auto window = shownWindow();
  QVERIFY(window && open(*window, scan));
  QVERIFY(growTwo(*window));
  ui::Document& document = window->document();
  QSignalSpy exported(&document, &ui::Document::exported), refused(&document, &ui::Document::exportRefused),
      notSaved(&document, &ui::Document::saveFailed);
  for (const QString& path : {scan + "/" + name, scan + "/new.nrrd"})
    document.exportResult(path, CoordinateSpace::lps);
  document.saveSession(scan + "/s.json");
  QCOMPARE(refused.size(), 2);
  QCOMPARE(notSaved.size(), 1);
  QCOMPARE(QDir(scan).entryList(QDir::Files), QStringList{name});
  document.exportResult(folder.filePath("new.nrrd"), CoordinateSpace::lps);
  document.exportResult(scan + "/again.nrrd", CoordinateSpace::lps);
  QCOMPARE(refused.size(), 3);
  QVERIFY(!window->close());  // what is refused at once is not what is being written
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
}

void ExportedObjectsWindowTest::picturesAndTablesAreNotWrittenIntoTheVolume() {
  const QTemporaryDir folder;
  const QString scan = folder.filePath("scan"), name = QFileInfo(writeBalls(folder)).fileName();
  QVERIFY(QDir().mkdir(scan) && QFile::rename(folder.filePath(name), scan + "/" + name));
  auto window = shownWindow();
  QVERIFY(window && open(*window, scan));
  ui::FileWork& files = window->files();
  const auto isRefused = [&](const QString& file, const std::function<void()>& work) {
    window->messages().dismiss();
    questionsOf(work, {{scan + "/" + file}, {}});
    return window->messages().text().contains("part of the volume");
  };
  QVERIFY(isRefused("p.png", [&] { files.exportPicture(); }));
  QVERIFY(isRefused("t.csv", [&] { files.saveText("Save", "measures", ".csv", "1,2"); }));
  const auto write = [](const std::string& path) { writeWord(QString::fromStdString(path)); };
  QVERIFY(isRefused("m.ply", [&] { files.saveFile("Save", "mesh", ".ply", write); }));
  QTest::qWait(100);
  QCOMPARE(QDir(scan).entryList(QDir::Files), QStringList{name});
}

//! The ending that a typed name lacks is added: a file of the whole name is asked about all the same. One of
//! the typed name that is not itself written is not.
void ExportedObjectsWindowTest::whatIsThereIsAskedAbout() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  QVERIFY(growTwo(*window));
  window->showStep(Command::stepExport);
  called<QComboBox>(*window->findChild<ui::ExportPanel*>(), "Objects")
      ->setCurrentText("Each object in a file of its own");
  ui::Document& document = window->document();
  const QString base = folder.filePath("mine"), ending = window->findChild<ui::ExportPanel*>()->extension();
  const QString first = document.objectPaths(base + ending, ending, false).front();
  writeWord(first);
  writeWord(base + ending);
  QSignalSpy exported(&document, &ui::Document::exported);
  const auto work = [&] { window->files().exportResult(); };
  QStringList questions = questionsOf(work, {{base, QString()}, {QMessageBox::No}});
  QCOMPARE(questions.size(), 1);
  QVERIFY2(questions[0].contains(QFileInfo(first).fileName()), qPrintable(questions[0]));
  QVERIFY(!questions[0].contains(QFileInfo(base + ending).fileName()));
  QVERIFY(exported.isEmpty() && holdsWord(first));
  questions = questionsOf(work, {{base}, {QMessageBox::Yes}});
  QCOMPARE(questions.size(), 1);
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QVERIFY(!holdsWord(first) && holdsWord(base + ending));

  writeWord(folder.filePath("report.json"));
  const auto report = [&] { window->files().exportReport(); };
  questions = questionsOf(report, {{folder.filePath("report"), QString()}, {QMessageBox::No}});
  QCOMPARE(questions.size(), 1);
  QVERIFY(questions[0].contains("report.json") && holdsWord(folder.filePath("report.json")));
}

void ExportedObjectsWindowTest::whatIsBetteredIsChosenAndTold() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, writeBalls(folder)));
  window->viewState().setCrosshair(kLeft);
  QTest::keyClick(window.get(), Qt::Key_Return);
  QTest::keyClick(window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  window->showStep(Command::stepExport);
  auto* choice = qobject_cast<QCheckBox*>(buttonSaying(*window, "Better thin triangles"));
  QVERIFY(choice && choice->isVisible() && choice->isChecked());
  ui::Document& document = window->document();
  QTest::mouseClick(choice, Qt::LeftButton, {}, QPoint(8, choice->height() / 2));
  QVERIFY(!document.polishes());
  document.setPolishes(true);
  QVERIFY(choice->isChecked());
  // A cut leaves thin triangles at its rim.
  QSignalSpy edited(&document, &ui::Document::meshEdited);
  MeshEdit cut{0, MeshEditKind::cut, kLeft + Vec3(0.3, 0.2, 1.7)};
  cut.vector = Vec3(1, 2, 9);
  cut.keep = KeptSide::negative;
  document.editMesh(cut);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QSignalSpy exported(&document, &ui::Document::exported), polished(&document, &ui::Document::polished);
  document.exportResult(folder.filePath("cut.stl"), CoordinateSpace::lps);
  QVERIFY(!exported.isEmpty() || exported.wait(kPatience));
  QCOMPARE(polished.size(), 1);
  QVERIFY(shownText(*window, "What was bettered").contains("Polished"));
}

//! The dialog takes double quotes for the ends of names.
void ExportedObjectsWindowTest::aNameIsProposedThatTheDialogTakesAsOne() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("vol \"b\".nii.gz");
  QVERIFY(QFile::rename(writeBalls(folder), path));
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  window->document().addSeed({kLeft, {}});  // a session without one is not written
  QSignalSpy saved(&window->document(), &ui::Document::sessionSaved);
  QTimer timer;
  connect(&timer, &QTimer::timeout, [] {
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->accept();
  });
  timer.start(200);
  window->files().saveAs();
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QCOMPARE(saved.first().first().toString(), folder.filePath("vol b_session.json"));
  QVERIFY(QFile::exists(folder.filePath("vol b_session.json")));
}

void ExportedObjectsWindowTest::ofSeveralFilesTheOneThatIsWrittenIsNamed() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->showStep(Command::stepExport);
  ui::Document& document = window->document();
  const auto told = [&] { return shownText(*window, "What is being written"); };
  const auto why = [&] { return shownText(*window, "Why nothing is written"); };
  Q_EMIT document.exporting("/a/long.stl");
  QCOMPARE(told(), QString("Writing long.stl…"));
  Q_EMIT document.exportPolishes("Object");
  Q_EMIT document.exporting("/a/report.json");
  QVERIFY2(told().startsWith("Bettering") && told().endsWith("Waiting: 1."), qPrintable(told()));
  Q_EMIT document.exportFailed("The disk is full.");
  QCOMPARE(told(), QString("Writing report.json…"));
  Q_EMIT document.exported("/a/report.json");
  QVERIFY(told().isEmpty());
  QCOMPARE(why(), QString("The disk is full."));  // which goes when the next begins
  Q_EMIT document.exporting("/a/again.stl");
  QVERIFY(!told().isEmpty() && why().isEmpty());
  Q_EMIT document.exportCancelled("/a/again.stl");
  QVERIFY(told().isEmpty());
}

void ExportedObjectsWindowTest::whyNothingIsWrittenGoesWithItsVolume() {
  const QTemporaryDir folder;
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  window->showStep(Command::stepExport);
  Q_EMIT window->document().exportFailed("The disk is full.");
  QCOMPARE(shownText(*window, "Why nothing is written"), QString("The disk is full."));
  QVERIFY(open(*window, writeBalls(folder)));
  window->showStep(Command::stepExport);
  QCOMPARE(shownText(*window, "Why nothing is written"), QString());
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  ExportedObjectsWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "exported_objects_window_test.moc"
