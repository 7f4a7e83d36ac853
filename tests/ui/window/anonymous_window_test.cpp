// The switch "Without what names the patient": nothing that the window writes with it names the patient.

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QTimer>
#include <QUndoStack>
#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/unpacked.h"
#include "tests/ui/window/time_window_support.h"
#include "ui/model/time_series.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/measures/centre_line_page.h"
#include "ui/window/measures/compare_page.h"
#include "ui/window/measures/measures_panel.h"
#include "ui/window/measures/object_measures_page.h"
#include "ui/window/time/over_time_panel.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;
using ui::MeasuresPanel;

namespace {

const std::string kSeries = "1.2.3.4711.99.1", kStudy = "1.2.3.4711.6.1";
//! What of a series names Jane Doe, her study or where it was made.
const MoreElements kHeader{{0x00080020, {"DA", "19991231"}},       {0x00080021, {"DA", "19991230"}},
                           {0x00080022, {"DA", "19991229"}},       {0x00080023, {"DA", "19991228"}},
                           {0x00080030, {"TM", "235958.471101"}},  {0x00080031, {"TM", "235957.471102"}},
                           {0x00080032, {"TM", "235956.471103"}},  {0x00080033, {"TM", "235955.471104"}},
                           {0x00080050, {"SH", "ACC4711"}},        {0x00080080, {"LO", "Hospital X"}},
                           {0x00080081, {"ST", "1 Hospital Way"}}, {0x00080090, {"PN", "House^Greg"}},
                           {0x00081010, {"SH", "SCANNER_7"}},      {0x00081030, {"LO", "Knee study"}},
                           {0x00081070, {"PN", "Tech^Tom"}},       {0x00100010, {"PN", "Doe^Jane"}},
                           {0x00100020, {"LO", "PID0815"}},        {0x00100030, {"DA", "19700203"}},
                           {0x00101000, {"LO", "OTHER0816"}},      {0x00101001, {"PN", "Roe^Janet"}},
                           {0x00101010, {"AS", "029Y"}},           {0x00101040, {"LO", "12 Elm Street"}},
                           {0x00102154, {"SH", "+1-555-0199"}},    {0x00104000, {"LT", "afraid of dogs"}},
                           {0x00200010, {"SH", "STUDY99"}},        {0x00200052, {"UI", "1.2.3.4711.8.1"}}};
//! Of these, what a DICOM file that is made of the series has from it.
const std::set<std::string> kCopied{"19991231",       "235958.471101", "ACC4711",  "House^Greg", "Knee study",
                                    "Doe^Jane",       "PID0815",       "19700203", "029Y",       "STUDY99",
                                    "1.2.3.4711.8.1", kSeries,         kStudy};

//! What is looked for in every file; long enough, or with characters, not to stand there by chance.
std::set<std::string> telling() {
  std::set<std::string> values{"DOE_", "_JANE", kSeries, kStudy};
  for (const auto& [tag, value] : kHeader) values.insert(value.second);
  return values;
}

//! A series with a bright ball, and an older mesh among its files, of Jane Doe or of somebody else.
struct Jane {
  QTemporaryDir folder;
  QString series, mesh;
  Vec3 seed{0, 0, 0}, place{0, 0, 0};  //!< in the ball; in the middle of the mesh

  explicit Jane(const QString& name = "DOE_JANE", const MoreElements& header = kHeader)
      : series(folder.filePath(name)), mesh(series + '/' + name + ".stl") {
    std::vector<Slice> slices = evenStack(24);
    for (std::size_t k = 0; k < slices.size(); ++k) {
      slices[k].columns = slices[k].rows = 40;
      slices[k].spacing = "2.5\\2.5";
      slices[k].series = kSeries;
      slices[k].study = kStudy;
      slices[k].more = header;
      slices[k].number = static_cast<int>(k) + 1;
      slices[k].pixel = [k](int x, int y) {
        return (Vec3(x, y, static_cast<double>(k)) - Vec3(19.5, 19.5, 11.5)).norm() < 9 ? 500 : 100;
      };
    }
    writeSeries(series.toStdString(), slices);
    const Grid grid = readVolume(series.toStdString()).grid;
    seed = grid.toWorld(Vec3(19, 19, 11));
    place = grid.toWorld(Vec3(6, 6, 4));
    TriangleSoup old = icosphere(Vec3(0, 0, 0), 3, 0.5);
    for (Vec3& p : old.points) p = place + Vec3(4 * p.x(), p.y(), p.z());
    writeMesh(old, mesh.toStdString());
  }
};

//! A window in which the mesh is open as an object that is done, and the ball has grown.
std::unique_ptr<ui::MainWindow> workOn(const Jane& jane) {
  auto window = shownWindow();
  if (!window || !open(*window, jane.series)) return nullptr;
  ui::Document& document = window->document();
  QSignalSpy opened(&document, &ui::Document::objectsOpened);
  document.openObjects({jane.mesh});
  if (opened.isEmpty() && !opened.wait(kPatience)) return nullptr;
  if (!QTest::qWaitFor([&] { return document.objectInfo(0).snapshot != nullptr; }, kPatience)) return nullptr;
  document.addSeed({jane.seed, {}});
  document.run();
  return waitFor(*window, GrowthState::finished) ? std::move(window) : nullptr;
}

void switchOn(ui::MainWindow& window) {
  window.showStep(Command::stepExport);
  buttonSaying(window, "Without what names the patient")->click();
}

//! Whether what `act` writes is written.
template <typename Act>
bool isExportedBy(ui::Document& document, Act&& act) {
  QSignalSpy exported(&document, &ui::Document::exported), failed(&document, &ui::Document::exportFailed);
  act();
  return QTest::qWaitFor([&] { return !exported.isEmpty() || !failed.isEmpty(); }, kPatience) &&
         failed.isEmpty();
}

//! Writes all objects and the report into a folder that is made; empty, or the format that failed.
QString failedExport(ui::MainWindow& window, const QString& folder, const QStringList& endings) {
  QDir().mkpath(folder);
  ui::Document& document = window.document();
  const auto* panel = window.findChild<ui::ExportPanel*>();
  for (const QString& ending : endings) {
    const QString path = folder + "/a" + ending;
    const bool isDone = isExportedBy(document, [&] {
      if (ending == ".json")
        document.exportReport(path, panel->isAnonymous());
      else
        document.exportObjects(path, panel->space(), panel->content());
    });
    if (!isDone) return ending;
  }
  return {};
}

std::set<std::string> foundIn(const std::string& text, const std::set<std::string>& values) {
  std::set<std::string> hits;
  for (const std::string& value : values)
    if (text.find(value) != std::string::npos) hits.insert(value);
  return hits;
}

//! In all files of a folder, and in what is packed in them.
std::set<std::string> found(const QString& folder) {
  std::set<std::string> hits;
  for (const QString& name : QDir(folder).entryList(QDir::Files))
    hits.merge(foundIn(unpacked(readBytes((folder + "/" + name).toStdString())), telling()));
  return hits;
}

//! The formats that can be written of the series on this machine: tetrahedra need another program.
QStringList endingsFor(const ui::Document& document) {
  QStringList endings{".stl", ".vtp",      ".ply",     ".obj",     ".3mf",   ".gltf", ".nii.gz", ".nrrd",
                      ".mha", ".seg.nrrd", ".seg.dcm", ".stl.dcm", ".label", ".msh",  ".vtu",    ".inp"};
  endings.removeIf([&](const QString& ending) { return !document.exportFault(ending).isEmpty(); });
  return endings << ".json";
}

QAbstractButton* buttonOf(QWidget& page, const char* text) {
  for (QAbstractButton* button : page.findChildren<QAbstractButton*>())
    if (button->text() == QString::fromUtf8(text)) return button;
  return nullptr;
}

//! The measures of all objects, a line through the mesh, and the mesh beside its own file.
bool measure(ui::MainWindow& window, const Jane& jane) {
  window.commands()[Command::showMeasures]->trigger();
  window.document().setActiveObject(0);
  MeasuresPanel& panel = window.measures();
  panel.compare().compareWith(jane.mesh);
  panel.centreLine().find(jane.place - Vec3(6, 0, 0), jane.place + Vec3(6, 0, 0));
  return QTest::qWaitFor(
      [&] {
        return panel.objects().shown() && panel.objects().shown()->objects.size() == 2 &&
               !panel.objects().isMeasuring() && panel.compare().shown() && panel.centreLine().shown();
      },
      kPatience);
}

//! What the buttons of these pages save, one after the other.
template <typename Panel>
std::string savedBy(Panel& panel, std::initializer_list<QWidget*> pages,
                    std::initializer_list<const char*> buttons) {
  QSignalSpy saved(&panel, &Panel::saveRequested);
  for (QWidget* page : pages)
    for (const char* text : buttons) buttonOf(*page, text)->click();
  std::string all;
  for (const QList<QVariant>& save : saved) all += save[3].value<std::string>();
  return saved.size() == static_cast<qsizetype>(pages.size() * buttons.size()) ? all : std::string();
}

//! The session as it is saved, or without what names the patient; empty if that failed.
std::string sessionOf(ui::MainWindow& window, const QString& path, bool isAnonymous) {
  ui::Document& document = window.document();
  QSignalSpy saved(&document, &ui::Document::sessionSaved), exported(&document, &ui::Document::exported);
  if (isAnonymous)
    document.exportAnonymousSession(path);
  else
    document.saveSession(path);
  const bool isWritten = QTest::qWaitFor([&] { return !saved.isEmpty() || !exported.isEmpty(); }, kPatience);
  return isWritten ? readBytes(path.toStdString()) : std::string();
}

//! The message that comes next after `act`, if it asks for a file.
template <typename Act>
QString askedAfter(ui::MainWindow& window, Act&& act) {
  QSignalSpy asked(&window.document(), &ui::Document::fileNeeded);
  act();
  if (asked.isEmpty() && !asked.wait(kPatience)) return {};
  return window.messages().isVisible() ? window.messages().text() : QString();
}

bool isOpenAfterGiving(ui::MainWindow& window, const QString& file) {
  QSignalSpy opened(&window.document(), &ui::Document::opened);
  window.files().give(file);
  return !opened.isEmpty() || opened.wait(kPatience);
}

//! Takes the name that the next question for a file proposes, in a folder that is made.
void acceptIn(const QString& folder, ui::MainWindow& window) {
  QDir().mkpath(folder);
  QTimer::singleShot(500, &window, [folder] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (auto* files = qobject_cast<QFileDialog*>(dialog)) files->setDirectory(folder);
    if (dialog) dialog->accept();
  });
}

//! A window in which the object of a sample over time has grown.
std::unique_ptr<ui::MainWindow> growIn(const BeatingSample& sample) {
  auto window = shownWindow();
  if (!window || !open(*window, sample.volume)) return nullptr;
  window->document().addSeed({sample.seed, {}});
  window->document().run();
  return waitFor(*window, GrowthState::finished) ? std::move(window) : nullptr;
}

bool carry(ui::MainWindow& window) {
  window.commands()[Command::carryOverTime]->trigger();
  return QTest::qWaitFor([&] { return !window.document().time().isCarrying(); }, kPatience);
}

const QString kAsksForVolume = QStringLiteral("This session does not say where its volume is. Choose it.");

std::string savedMeasures(ui::MainWindow& window) {
  MeasuresPanel& panel = window.measures();
  return savedBy(panel, {&panel.objects(), &panel.compare(), &panel.centreLine()},
                 {"Save as CSV…", "Save as JSON…"}) +
         panel.objects().copyText().toStdString();
}

}  // namespace

class AnonymousWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void noFileThatIsExportedNamesThePatient();
  void norDoesWhatIsSavedOfMeasures();
  void norDoesAPicture();
  void norDoTheFramesOverTime();
  void norDoesTheCurveOfFramesThatCannotBeRead();
  void norDoesASessionThatIsExported();
  void suchASessionAsksForItsFilesAndGoesOn();
  void theSeriesOfItsFolderIsFoundByItsVoxels();
};

void AnonymousWindowTest::noFileThatIsExportedNamesThePatient() {
  const Jane jane;
  auto window = workOn(jane);
  QVERIFY(window);
  const QString named = jane.folder.filePath("named"), hidden = jane.folder.filePath("hidden");
  QCOMPARE(failedExport(*window, named, {".obj", ".3mf", ".seg.dcm", ".json"}), QString());
  std::set<std::string> told = kCopied;
  told.insert({"DOE_", "_JANE"});
  const std::set<std::string> open = found(named);
  QVERIFY(std::includes(open.begin(), open.end(), told.begin(), told.end()));  // else it would prove nothing
  switchOn(*window);
  const QStringList endings = endingsFor(window->document());
  QVERIFY(endings.size() >= 13 && endings.contains(".seg.dcm") && endings.contains(".stl.dcm"));
  QCOMPARE(failedExport(*window, hidden, endings), QString());
  QCOMPARE(QDir(hidden).entryList(QDir::Files).size(), endings.size());
  QCOMPARE(found(hidden), std::set<std::string>());
  const std::string report = readBytes((hidden + "/a.json").toStdString());
  QCOMPARE(foundIn(report, {"DOE", "JANE", "Doe", "Jane", "Object 1"}), std::set<std::string>{"Object 1"});
}

void AnonymousWindowTest::norDoesWhatIsSavedOfMeasures() {
  const Jane jane;
  auto window = workOn(jane);
  QVERIFY(window && measure(*window, jane));
  QObject::disconnect(&window->measures(), nullptr, &window->files(), nullptr);  // a dialog would wait
  const std::string named = savedMeasures(*window);
  QVERIFY(named.find(jane.mesh.toStdString()) != std::string::npos);
  QVERIFY(named.find("\"object\": \"DOE_JANE\"") != std::string::npos);  // of the centre line
  switchOn(*window);
  const std::string hidden = savedMeasures(*window);
  QVERIFY(hidden.find("\"object\": \"Object 1\"") != std::string::npos);
  std::set<std::string> values = telling();
  values.insert({"DOE", "JANE", jane.folder.path().toStdString(), "Object 1"});
  QCOMPARE(foundIn(hidden, values), std::set<std::string>{"Object 1"});
  // Where the mesh's object is the reference.
  ui::ComparePage& page = window->measures().compare();
  window->document().setActiveObject(1);
  page.compareWithObject(0);
  QVERIFY(QTest::qWaitFor([&] { return !page.isComparing(); }, kPatience) && page.shown());
  const std::string compared = savedBy(window->measures(), {&page}, {"Save as CSV…", "Save as JSON…"});
  QVERIFY(compared.find(window->document().anonymousNames().front()) != std::string::npos);
  values.erase("Object 1");
  QCOMPARE(foundIn(compared, values), std::set<std::string>());
}

void AnonymousWindowTest::norDoesAPicture() {
  const Jane jane, john("ROE_JOHN", {{0x00100010, {"PN", "Roe^John"}}, {0x00100020, {"LO", "42"}}});
  auto window = workOn(jane), other = workOn(john);
  QVERIFY(window && other);
  for (ui::MainWindow* each : {window.get(), other.get()}) {
    switchOn(*each);
    if (each->focusWidget()) each->focusWidget()->clearFocus();  // a view that has it is framed
  }
  // Nothing in the pixels, as they are the same for somebody else with the same voxels.
  const auto areAlike = [&] { return window->views().picture({}) == other->views().picture({}); };
  QVERIFY(QTest::qWaitFor(areAlike, kPatience));
  const QString pictures = jane.folder.filePath("pictures");
  acceptIn(pictures, *window);
  window->commands()[Command::exportPicture]->trigger();
  QCOMPARE(QDir(pictures).entryList(QDir::Files), QStringList("handlebody.png"));
  QCOMPARE(found(pictures), std::set<std::string>());
}

void AnonymousWindowTest::norDoTheFramesOverTime() {
  BeatingSample sample;
  sample.volume = sample.folder.filePath("DOE_JANE.nii.gz");
  QVERIFY(sample.make());
  auto window = growIn(sample);
  QVERIFY(window && carry(*window));
  switchOn(*window);
  const QString frames = sample.folder.filePath("frames");
  QDir().mkpath(frames);
  ui::Document& document = window->document();
  for (const char* ending : {".vtp", ".stl", ".ply", ".obj", ".nii.gz", ".nrrd"})
    QVERIFY(
        isExportedBy(document, [&] { document.exportFrames(frames + "/a" + ending, CoordinateSpace::lps); }));
  QCOMPARE(QDir(frames).entryList(QDir::Files).size(),
           4 * BeatingSample::kFrames + 1 + 2);  // with a list of the .vtp
  QCOMPARE(found(frames), std::set<std::string>());
}

void AnonymousWindowTest::norDoesTheCurveOfFramesThatCannotBeRead() {
  BeatingSample sample;
  sample.volume = sample.folder.filePath("DOE_JANE.nii.gz");
  QVERIFY(sample.make());
  auto window = growIn(sample);
  QVERIFY(window);
  window->document().time().store().setBound(1);  // byte: nothing is kept
  QVERIFY(QFile::remove(sample.volume) && carry(*window));
  ui::OverTimePanel& panel = window->overTime();
  QObject::disconnect(&panel, nullptr, &window->files(), nullptr);  // a dialog would wait
  const std::string named = savedBy(panel, {&panel}, {"CSV…", "Plot…"});
  QVERIFY(named.find("DOE_JANE") != std::string::npos);
  switchOn(*window);
  const std::string hidden = savedBy(panel, {&panel}, {"CSV…", "Plot…"});
  QVERIFY(!hidden.empty());
  QCOMPARE(foundIn(hidden, {"DOE", "JANE", sample.folder.path().toStdString()}), std::set<std::string>());
}

void AnonymousWindowTest::norDoesASessionThatIsExported() {
  const Jane jane;
  auto window = workOn(jane);
  QVERIFY(window);
  window->showStep(Command::stepExport);
  auto* panel = window->findChild<ui::ExportPanel*>();
  const QAbstractButton *save = buttonOf(*panel, "Save session"),
                        *exports = buttonOf(*panel, "Export anonymous session…");
  QVERIFY(save && exports && save->isVisible() && !exports->isVisible());
  const std::string named = sessionOf(*window, jane.folder.filePath("named.json"), false);
  QVERIFY(named.find("DOE_JANE.stl") != std::string::npos);  // else the search would prove nothing
  switchOn(*window);
  QVERIFY(!save->isVisible() && exports->isVisible() && exports->isEnabled());
  const std::string hidden = sessionOf(*window, jane.folder.filePath("hidden.json"), true);
  std::set<std::string> values = telling();
  values.insert({"DOE", "JANE", "Doe", "Jane", "\"series\"", "Object 1", jane.folder.path().toStdString()});
  QCOMPARE(foundIn(hidden, values), std::set<std::string>{"Object 1"});
  QCOMPARE(window->document().sessionPath(), jane.folder.filePath("named.json"));
}

void AnonymousWindowTest::suchASessionAsksForItsFilesAndGoesOn() {
  const Jane jane;
  const QString session = jane.folder.filePath("hidden.json"), named = jane.folder.filePath("named.json");
  double volume = 0;
  {
    auto window = workOn(jane);
    QVERIFY(window && !sessionOf(*window, session, true).empty());
    volume = window->document().snapshot()->certificate.volume;
    QVERIFY(!sessionOf(*window, named, false).empty());  // nothing is unsaved when it closes
  }
  auto window = shownWindow();
  QVERIFY(window);
  QCOMPARE(askedAfter(*window, [&] { window->files().open(session); }), kAsksForVolume);
  QVERIFY(buttonSaying(*window, "Choose the file")->isVisible());
  QVERIFY(buttonSaying(*window, "Choose the folder")->isVisible());
  const QString refused = askedAfter(*window, [&] { window->files().give(jane.mesh); });
  QVERIFY2(refused.contains("DOE_JANE.stl") && refused.contains("SHA-256"), qPrintable(refused));
  QVERIFY(buttonSaying(*window, "Choose the folder")->isVisible());
  const QString surface = askedAfter(*window, [&] { window->files().give(jane.series); });
  QVERIFY2(surface.contains("surface"), qPrintable(surface));
  QVERIFY(isOpenAfterGiving(*window, jane.mesh));
  ui::Document& document = window->document();
  QVERIFY(window->files().recent().contains(session));
  QVERIFY(document.sessionPath().isEmpty());  // to save is not to name the volume in it
  QVERIFY(waitFor(*window, GrowthState::finished));
  QCOMPARE(document.snapshot()->certificate.volume, volume);
  const std::string hidden = readBytes(session.toStdString());
  QVERIFY(sessionOf(*window, named, false).find("DOE_JANE") != std::string::npos);
  QCOMPARE(readBytes(session.toStdString()), hidden);
  QVERIFY(open(*window, named));
  QCOMPARE(document.sessionPath(), named);
}

void AnonymousWindowTest::theSeriesOfItsFolderIsFoundByItsVoxels() {
  const QTemporaryDir folder;
  const QString series = folder.filePath("DOE_JANE"), session = folder.filePath("hidden.json");
  std::vector<Slice> slices = evenStack(3), larger = evenStack(4);
  for (Slice& s : larger) s.rows = 6, s.number = 10;
  slices.insert(slices.end(), larger.begin(), larger.end());
  writeSeries(series.toStdString(), slices);
  VolumeSelection second;
  second.series = "1.2.3.4#2";
  auto window = shownWindow();
  QVERIFY(window);
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  window->files().open(series, second);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  ui::Document& document = window->document();
  document.addSeed({document.volume().grid.toWorld(Vec3(1, 1, 1)), 1.0});
  QVERIFY(sessionOf(*window, session, true).find("1.2.3.4") == std::string::npos);
  document.undoStack()->undo();
  QSignalSpy choice(&document, &ui::Document::seriesChoiceNeeded);
  opened.clear();
  QCOMPARE(askedAfter(*window, [&] { window->files().open(session); }), kAsksForVolume);
  window->files().give(series);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QVERIFY(choice.isEmpty());
  QCOMPARE(document.volume().grid.size[1], 6);
  QCOMPARE(document.seeds().size(), std::size_t(1));
  // One of before keeps nothing of the voxels, and asks as a folder of several series does.
  const std::string text = readBytes(session.toStdString());
  const std::string without =
      std::regex_replace(text, std::regex(",\\s*\"voxels_sha256\":\\s*\"[0-9a-f]+\""), "");
  QVERIFY(without.size() < text.size());
  const QString earlier = folder.filePath("earlier.json");
  std::ofstream(earlier.toStdString()) << without;
  QCOMPARE(askedAfter(*window, [&] { window->files().open(earlier); }), kAsksForVolume);
  window->files().give(series);
  QVERIFY(!choice.isEmpty() || choice.wait(kPatience));
  QCOMPARE(choice.front().front().toString(), earlier);
  opened.clear();
  window->files().open(earlier, second);  // as the list of the step Open does it
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(document.volume().grid.size[1], 6);
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  AnonymousWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "anonymous_window_test.moc"
