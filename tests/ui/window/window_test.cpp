// The window as a person uses it: real mouse and key events on a real display.

#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QListWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QProcess>
#include <QTimer>
#include <QUndoStack>

#include "core/io/meshes/mesh_io.h"
#include "tests/io/dicom_test_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/commands.h"
#include "ui/window/steps_panel.h"
#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/language.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;

namespace {

void drop(ui::MainWindow& window, const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPoint middle = window.rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &event);
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Says nothing of the size of its voxels. False: it could not be written.
bool writeCine(const QString& path) {
  Slice s;
  s.frames = 5;
  s.placed = false;
  s.frameTime = 33;
  const QByteArray bytes = QByteArray::fromStdString(dicomBytes(s, "1.2"));
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

// Runs the growth of the open session to its end with Space.
bool growToTheEnd(ui::MainWindow& window) {
  QTest::keyClick(&window, Qt::Key_Space);
  return waitFor(window, GrowthState::finished);
}

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aClickAndReturnPlaceASeedAndSpaceGrowsItIntoARing();
  void steppingBackIsExactAndANewParameterGoesOnFromThere();
  void anEventIsInspectedInItsStages();
  void whatIsExportedIsWhatReplayMakes();
  void theColouringOfTheSurfaceComesBackWithTheSession();
  void onlyWhatCouldBeOpenedStandsAmongTheRecent();
  void badFilesLeaveTheOpenWorkAlone();
  void aCineIsOfferedASpacingInEveryLanguage();
  void theSpacingThatIsEnteredIsOfTheFileThatLacksIt();
  void twoStacksUnderOneUidAreAChoice();
  void anUncalibratedVolumeTakesTheSpacingThatIsGiven();
  void savingTheSampleAsksForANameAndLeavesItAsItIs();
  void aSeedIsUndoneByName();
  void everyCommandIsInAMenuWithItsKeys();
  void everyControlHasAName();
  void keysStayWithTheControlThatUsesThem();
  void aViewFillsTheWindowAndGoesBack();
  void theLayoutIsRemembered();
  void everyFieldWithDecimalsTakesBothPoints();
  void aPictureOfAllViewsShowsAllWhileOneIsMaximised();
};

void WindowTest::aClickAndReturnPlaceASeedAndSpaceGrowsItIntoARing() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  QVERIFY(window->document().seeds().empty());
  ui::SliceView& axial = window->views().slice(ui::Plane::axial);
  // The volume's middle lies in the cyst, beside the needle; the axial slice is centred in its view.
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() - QPoint(30, 0));
  QTest::keyClick(&axial, Qt::Key_Return);
  QCOMPARE(window->document().seeds().size(), std::size_t{1});
  const Vec3 offset = window->document().seeds().front().centre - window->viewState().crosshair();
  QVERIFY(offset.norm() < 1e-9);

  QTest::keyClick(&axial, Qt::Key_Space);
  QVERIFY(waitFor(*window, GrowthState::finished));
  QCOMPARE(shownLabel(*window, "Genus")->text(), QString("1"));
  QCOMPARE(shownLabel(*window, "Components")->text(), QString("1"));
  QVERIFY(shownLabel(*window, "Certificate")->text().startsWith(QString("✓")));
}

void WindowTest::steppingBackIsExactAndANewParameterGoesOnFromThere() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  ui::Document& document = window->document();
  const auto forward = [&](int n) {
    for (int i = 0; i < n; ++i) {
      const int wanted = document.iteration() + 1;
      QTest::keyClick(window.get(), Qt::Key_Period);
      if (!QTest::qWaitFor([&] { return document.iteration() == wanted; }, kPatience)) return false;
    }
    return true;
  };
  // The seeds are shown as iteration 0 before the first step is made.
  QTest::keyClick(window.get(), Qt::Key_Period);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == 1; }, kPatience));
  QVERIFY(forward(5));
  const auto before = document.snapshot();
  QVERIFY(forward(1));
  QTest::keyClick(window.get(), Qt::Key_Comma);
  QVERIFY(QTest::qWaitFor([&] { return document.iteration() == before->iteration; }, kPatience));
  const auto after = document.snapshot();
  QCOMPARE(after->mesh.points.size(), before->mesh.points.size());
  QVERIFY(after->mesh.points == before->mesh.points);
  QVERIFY(after->mesh.triangles == before->mesh.triangles);

  const int dropped = document.lastIteration();
  QVERIFY(dropped > before->iteration);
  Parameters parameters = document.parameters();
  parameters.curvature = 0.6;
  document.setParameters(parameters, "Change curvature");
  QVERIFY(forward(1));
  QCOMPARE(document.lastIteration(), before->iteration + 1);
}

void WindowTest::anEventIsInspectedInItsStages() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QVERIFY(growToTheEnd(*window));
  const int index = firstHandle(window->document());
  QVERIFY(index >= 0);
  window->goToEvent(index);
  const Event event = window->document().events()[index];
  QVERIFY(QTest::qWaitFor([&] { return window->document().iteration() == event.iteration; }, kPatience));
  QVERIFY((window->viewState().crosshair() - event.location).norm() < 1e-9);

  QSignalSpy traced(&window->document(), &ui::Document::eventTraced);
  const auto buttons = window->findChildren<QAbstractButton*>();
  QAbstractButton* opened = nullptr;
  for (QAbstractButton* button : buttons)
    if (button->accessibleName() == "Stage: Open") opened = button;
  QVERIFY(opened && opened->isVisible());
  const QImage plain = window->views().surface().picture();
  QTest::mouseClick(opened, Qt::LeftButton);
  QVERIFY(!traced.isEmpty() || traced.wait(kPatience));
  QTest::qWait(1000);  // the camera's flight
  if (window->views().surface().hasOpenGl()) QVERIFY(window->views().surface().picture() != plain);
}

void WindowTest::whatIsExportedIsWhatReplayMakes() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  QVERIFY(growToTheEnd(*window));
  const QTemporaryDir folder;
  const QString mesh = folder.filePath("mesh.stl"), session = folder.filePath("session.json"),
                again = folder.filePath("again.stl");
  QSignalSpy exported(&window->document(), &ui::Document::exported);
  window->document().exportResult(mesh, CoordinateSpace::lps);
  QVERIFY(exported.wait(kPatience));
  QSignalSpy saved(&window->document(), &ui::Document::sessionSaved);
  window->document().saveSession(session);
  QVERIFY(saved.wait(kPatience));
  QCOMPARE(QProcess::execute(HANDLEBODY_CLI, {"replay", session, "-o", again, "--quiet"}), 0);
  QVERIFY(!contentOf(mesh).isEmpty());
  QCOMPARE(contentOf(again), contentOf(mesh));
}

void WindowTest::theColouringOfTheSurfaceComesBackWithTheSession() {
  const std::pair<Command, ui::MeshColouring> all[] = {{Command::meshEdges, ui::MeshColouring::edges},
                                                       {Command::meshState, ui::MeshColouring::state},
                                                       {Command::meshSupport, ui::MeshColouring::support}};
  const QTemporaryDir folder;
  const QString session = folder.filePath("session.json");
  for (const auto& [command, colouring] : all) {
    auto window = shownWindow();
    QVERIFY(window && open(*window, sample("cyst_session.json")));
    window->commands()[command]->trigger();
    QVERIFY(window->viewState().meshColouring() == colouring);
    Q_EMIT window->files().aboutToSave();
    QSignalSpy saved(&window->document(), &ui::Document::sessionSaved);
    window->document().saveSession(session);
    QVERIFY(saved.wait(kPatience));
    auto other = shownWindow();
    QVERIFY(other && open(*other, session));
    QVERIFY(other->viewState().meshColouring() == colouring);
    QVERIFY(other->commands()[command]->isChecked());
  }
}

void WindowTest::onlyWhatCouldBeOpenedStandsAmongTheRecent() {
  const QTemporaryDir folder;
  const QString bad = folder.filePath("bad.nii.gz"), good = sample("cyst.nii.gz");
  QFile file(bad);
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no volume") > 0);
  file.close();
  auto window = shownWindow();
  QSignalSpy failed(&window->document(), &ui::Document::openFailed);
  window->files().open(bad);
  QVERIFY(failed.wait(kPatience));
  QVERIFY(window->files().recent().isEmpty());
  QVERIFY(open(*window, good));
  QCOMPARE(window->files().recent(), QStringList{good});
}

void WindowTest::badFilesLeaveTheOpenWorkAlone() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  const QString path = window->document().path();
  const QTemporaryDir folder;
  // Says that it holds 32768 x 32768 x 4 voxels, and is a hundred bytes long.
  const QString huge = folder.filePath("huge.mha"), text = folder.filePath("text.nii");
  QFile hugeFile(huge), textFile(text);
  QVERIFY(hugeFile.open(QIODevice::WriteOnly) && textFile.open(QIODevice::WriteOnly));
  hugeFile.write(
      "ObjectType = Image\nNDims = 3\nDimSize = 32768 32768 4\nElementType = MET_SHORT\nElementDataFile = "
      "LOCAL\n");
  textFile.write("not a volume");
  hugeFile.close();
  textFile.close();
  for (const QString& bad : {huge, text, folder.filePath("missing.nrrd")}) {
    QSignalSpy failed(&window->document(), &ui::Document::openFailed);
    drop(*window, bad);
    QVERIFY(!failed.isEmpty() || failed.wait(kPatience));
    QVERIFY2(window->messages().text().contains(QFileInfo(bad).fileName()),
             qPrintable(window->messages().text()));
    QVERIFY(window->messages().isVisible());
    QCOMPARE(window->document().path(), path);
    QCOMPARE(window->document().seeds().size(), std::size_t{1});
  }
}

void WindowTest::aCineIsOfferedASpacingInEveryLanguage() {
  const QTemporaryDir folder;
  const QString cine = folder.filePath("cine.dcm"), text = folder.filePath("text.nii");
  QFile textFile(text);
  QVERIFY(writeCine(cine) && textFile.open(QIODevice::WriteOnly));
  textFile.write("not a volume");
  textFile.close();
  for (const char* language : {"en", "de"}) {
    ui::useLanguage(QString::fromLatin1(language));
    auto window = shownWindow();
    QVERIFY(window);
    const QString offer = QString::fromLatin1(language) == "de" ? "Abstand eingeben" : "Enter the spacing";
    for (const QString& bad : {cine, text}) {
      QSignalSpy failed(&window->document(), &ui::Document::openFailed);
      window->files().open(bad);
      QVERIFY(!failed.isEmpty() || failed.wait(kPatience));
      const auto* button = buttonSaying(*window, offer.toUtf8().constData());
      QCOMPARE(button && button->isVisible(), bad == cine);
      QVERIFY2(!window->messages().text().contains("--spacing"), qPrintable(window->messages().text()));
    }
  }
  ui::useLanguage(QStringLiteral("en"));
}

//! Also where another one is being opened when the offer is taken.
void WindowTest::theSpacingThatIsEnteredIsOfTheFileThatLacksIt() {
  const QTemporaryDir folder;
  const QString cine = folder.filePath("cine.dcm");
  auto window = shownWindow();
  QVERIFY(window && writeCine(cine));
  QSignalSpy failed(&window->document(), &ui::Document::openFailed),
      opened(&window->document(), &ui::Document::opened),
      asked(&window->files(), &ui::FileWork::spacingNeeded);
  window->files().open(cine);
  QVERIFY(!failed.isEmpty() || failed.wait(kPatience));
  window->files().open(sample("cyst.nii.gz"));
  QAbstractButton* offer = buttonSaying(*window, "Enter the spacing");
  QVERIFY(offer && offer->isVisible());
  offer->click();
  QCOMPARE(asked.size(), 1);
  QCOMPARE(asked.front().front().toString(), cine);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
}

void WindowTest::twoStacksUnderOneUidAreAChoice() {
  const QTemporaryDir folder;
  std::vector<Slice> slices = evenStack(3), larger = evenStack(4);
  for (Slice& s : larger) s.rows = 6, s.number = 10;
  slices.insert(slices.end(), larger.begin(), larger.end());
  writeSeries(folder.path().toStdString(), slices);
  auto window = shownWindow();
  QVERIFY(window);
  QSignalSpy asked(&window->document(), &ui::Document::seriesChoiceNeeded);
  window->files().open(folder.path());
  QVERIFY(!asked.isEmpty() || asked.wait(kPatience));
  QListWidget* list = nullptr;
  for (QListWidget* l : window->findChildren<QListWidget*>())
    if (l->accessibleName() == "Series in the folder") list = l;
  QVERIFY(list && list->isVisible());
  QCOMPARE(list->count(), 2);
  QVERIFY(list->item(1)->text().contains("stack 2\n4 × 6 × 4, "));
  list->setCurrentRow(1);
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  QTest::keyClick(list, Qt::Key_Return);
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QCOMPARE(window->document().volume().grid.size[1], 6);
  QCOMPARE(*window->document().selection().series, std::string("1.2.3.4#2"));
  QVERIFY(!list->parentWidget()->isHidden());  // on its page: the other one can be opened from there
}

void WindowTest::anUncalibratedVolumeTakesTheSpacingThatIsGiven() {
  const QTemporaryDir folder;
  Slice clip;
  clip.frames = 5;
  clip.placed = false;
  clip.spacing = "";
  const QString path = folder.filePath("clip.dcm");
  writeBytes(path.toStdString(), dicomBytes(clip, "1.2"));
  auto window = shownWindow();
  QVERIFY(window && open(*window, path));
  QVERIFY(!window->document().info().calibrated);
  for (QDoubleSpinBox* field : window->findChildren<QDoubleSpinBox*>())
    if (field->accessibleName() == "Spacing of slices") {
      QVERIFY(!field->parentWidget()->isHidden());
      field->setValue(2.5);
    }
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  for (QAbstractButton* button : window->findChildren<QAbstractButton*>())
    if (button->text() == "Open with this spacing") button->click();
  QVERIFY(!opened.isEmpty() || opened.wait(kPatience));
  QVERIFY(window->document().info().calibrated);
  QCOMPARE(window->document().volume().grid.spacing.z(), 2.5);
}

void WindowTest::savingTheSampleAsksForANameAndLeavesItAsItIs() {
  // Where an installed program has it.
  const QDir program(QApplication::applicationDirPath());
  const QString folder = program.filePath("../share/handlebody/sample_volumes");
  QVERIFY(QDir().mkpath(folder));
  for (const char* name : {"cyst_session.json", "cyst.nii.gz"})
    QVERIFY(QFile::exists(folder + '/' + name) || QFile::copy(sample(name), folder + '/' + name));
  const QString session = folder + "/cyst_session.json";
  const QByteArray before = contentOf(session);

  auto window = shownWindow();
  QSignalSpy opened(&window->document(), &ui::Document::opened);
  window->files().openSample();
  QVERIFY(opened.wait(kPatience));
  QVERIFY(window->files().recent().isEmpty());
  window->document().setSeedRadius(0, 9.0);
  QSignalSpy saved(&window->document(), &ui::Document::sessionSaved);
  QString asked;
  QTimer::singleShot(500, window.get(), [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog) return;
    asked = dialog->windowTitle();
    dialog->close();
  });
  window->commands()[ui::Command::saveSession]->trigger();
  QCOMPARE(asked, QString("Save the session"));
  QVERIFY(!saved.wait(500));
  QCOMPARE(contentOf(session), before);
  window->document().undoStack()->undo();  // nothing is unsaved when it closes
}

void WindowTest::aSeedIsUndoneByName() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  ui::SliceView& coronal = window->views().slice(ui::Plane::coronal);
  QTest::mouseClick(&coronal, Qt::LeftButton, {}, coronal.rect().center());
  QTest::keyClick(&coronal, Qt::Key_Return);
  QAction* undo = window->commands()[Command::undo];
  QVERIFY2(undo->text().startsWith("Undo ") && undo->text().contains("seed"), qPrintable(undo->text()));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window->document().seeds().empty());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(window->document().seeds().size(), std::size_t{1});
  window->document().selectSeed(0);
  QTest::keyClick(&coronal, Qt::Key_Backspace);
  QVERIFY(window->document().seeds().empty());
}

void WindowTest::everyCommandIsInAMenuWithItsKeys() {
  auto window = shownWindow();
  QVERIFY(window);
  QSet<QAction*> inMenus;
  const auto menus = window->menuBar()->findChildren<QMenu*>();
  for (QMenu* menu : menus)
    for (QAction* action : menu->actions()) inMenus << action;
  QSet<QString> keys;
  for (const ui::CommandSpec& spec : ui::Commands::table()) {
    QAction* action = window->commands()[spec.id];
    QVERIFY2(inMenus.contains(action), spec.text);
    for (const QKeySequence& key : action->shortcuts()) {
      QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString()));  // one key, one command
      keys << key.toString();
    }
  }
}

void WindowTest::everyControlHasAName() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  const auto widgets = window->findChildren<QWidget*>();
  for (const QWidget* widget : widgets) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) continue;
    const bool own = QByteArray(widget->metaObject()->className()).startsWith("handlebody");
    const bool control = own || qobject_cast<const QAbstractButton*>(widget) ||
                         widget->inherits("QAbstractSpinBox") || widget->inherits("QComboBox") ||
                         widget->inherits("QAbstractItemView") || widget->inherits("QAbstractSlider");
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool named = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
    const bool partOfAnother = widget->inherits("QScrollBar") || widget->inherits("QScrollArea") ||
                               widget->inherits("QComboBoxListView");
    if (!control || named || partOfAnother || qobject_cast<const ui::MainWindow*>(widget)) continue;
    if (widget->focusProxy() || widget->inherits("handlebody::ui::ValueField")) continue;
    QFAIL(qPrintable(
        QString("%1 in %2 has no name")
            .arg(widget->metaObject()->className(), widget->parentWidget()->metaObject()->className())));
  }
}

void WindowTest::keysStayWithTheControlThatUsesThem() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst_session.json")));
  window->showStep(Command::stepTune);
  QWidget* curvature = nullptr;
  const auto widgets = window->findChildren<QWidget*>();
  for (QWidget* widget : widgets)
    if (widget->accessibleName() == "Curvature" && widget->inherits("QDoubleSpinBox")) curvature = widget;
  QVERIFY(curvature);
  curvature->setFocus();
  QTest::keyClick(curvature, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(curvature, "0.5");  // "." is a command of the window as well
  QTest::keyClick(curvature, Qt::Key_Return);
  QCOMPARE(window->document().parameters().curvature, 0.5);
  QCOMPARE(window->document().seeds().size(), std::size_t{1});  // Return placed no seed
  QCOMPARE(window->document().iteration(), -1);                 // and nothing grew
}

void WindowTest::aViewFillsTheWindowAndGoesBack() {
  auto window = shownWindow();
  QVERIFY(window && open(*window, sample("cyst.nii.gz")));
  ui::SliceView& coronal = window->views().slice(ui::Plane::coronal);
  ui::SliceView& axial = window->views().slice(ui::Plane::axial);
  const int width = coronal.width();
  QTest::mouseDClick(&coronal, Qt::LeftButton, {}, coronal.rect().center());
  QTRY_VERIFY(!axial.isVisible() && coronal.width() > width);
  QTest::keyClick(window.get(), Qt::Key_0, Qt::ControlModifier);
  QTRY_VERIFY(axial.isVisible());
}

void WindowTest::theLayoutIsRemembered() {
  auto window = shownWindow();
  QVERIFY(window);
  window->views().maximise(ui::Cell::sagittal);
  window->setAppearance(ui::Appearance::dark);
  window->close();
  ui::MainWindow again;
  QVERIFY(again.views().maximised() == ui::Cell::sagittal);
  QVERIFY(again.commands()[Command::coloursDark]->isChecked());
  again.setAppearance(ui::Appearance::light);
}

//! tests/ui/window/decimal_field_test.cpp: what that means.
void WindowTest::everyFieldWithDecimalsTakesBothPoints() {
  auto window = shownWindow();
  QVERIFY(window);
  const auto fields = window->findChildren<QDoubleSpinBox*>();
  QVERIFY(!fields.isEmpty());
  for (QDoubleSpinBox* field : fields)
    QVERIFY2(dynamic_cast<ui::DecimalField*>(field), qPrintable(field->accessibleName()));
}

void WindowTest::aPictureOfAllViewsShowsAllWhileOneIsMaximised() {
  auto window = shownWindow();
  QVERIFY(window);
  ui::ViewGrid& views = window->views();
  QVERIFY(open(*window, sample("cyst.nii.gz")));
  QTRY_VERIFY(views.slice(ui::Plane::coronal).isVisible());
  const QImage all = views.picture(std::nullopt);
  views.maximise(ui::Cell::sagittal);
  QTRY_VERIFY(!views.slice(ui::Plane::coronal).isVisible());
  QTRY_VERIFY(views.slice(ui::Plane::sagittal).width() > views.width() / 2);
  const QSize large = views.slice(ui::Plane::sagittal).size();
  const QImage sagittal = views.picture(ui::Cell::sagittal);
  const QImage again = views.picture(std::nullopt);
  QCOMPARE(again.size(), all.size());
  const QRect upperLeft(QPoint(8, 8), all.size() / 4);  // of the axial slice, with its name
  QCOMPARE(again.copy(upperLeft), all.copy(upperLeft));
  QVERIFY(views.maximised() == ui::Cell::sagittal);
  QCOMPARE(views.slice(ui::Plane::sagittal).size(), large);
  QCOMPARE(views.picture(ui::Cell::sagittal), sagittal);
  QVERIFY(!views.slice(ui::Plane::coronal).isVisible());
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  WindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "window_test.moc"
