// The brush on the surface by mouse and keys, in the slices and in 3D: pinning, unpinning, smoothing,
// pulling.

#include <QProcess>
#include <QPushButton>
#include <QTableWidget>

#include "tests/ui/window/correct_support.h"
#include "ui/view/surface_brush.h"
#include "ui/view/surface_scene.h"
#include "ui/window/grow/held_section.h"
#include "ui/window/grow/touch_section.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Brush;
using ui::Command;
using ui::GrowthState;
using ui::Plane;

namespace {

int pinPixels(const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      count += c.green() > c.red() + 40 && c.blue() > c.red() + 30 && c.green() > 110;
    }
  return count;
}

//! Its surface is grown, and the step Correct is shown.
struct Grown : Opened {
  bool ready = ok && grow();
  ui::SurfaceView& surface() { return window->views().surface(); }
  const Vec3 end = kLeft - Vec3(8, 0, 0);  // of the left ball, on its surface

  bool isNear(const Vec3& p, const Vec3& place, double mm) const { return (p - place).norm() <= mm; }
  //! In the 3D view, as a hand does. `picture`: kept of it under way.
  void drag3d(const QPoint& from, const QPoint& to, const QString& picture = {}) {
    QTest::mousePress(&surface(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) {
      const QPoint at = from + (to - from) * i / 8;
      QMouseEvent move(QEvent::MouseMove, at, surface().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&surface(), &move);
    }
    if (!picture.isEmpty()) keepPicture(picture);
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, to);
  }
  //! Seen from the front, all of it in view.
  void lookFromFront() {
    surface().setFlightTime(0);
    surface().resetCamera();
    window->commands()[Command::lookFromFront]->trigger();
    (void)surface().picture();
  }
  QPoint middle3d() { return surface().rect().center(); }
  bool edited(const std::function<void()>& gesture) {
    QSignalSpy made(&document(), &ui::Document::meshEdited);
    gesture();
    return !made.isEmpty() || made.wait(kPatience);
  }
  bool undone(int iteration) {
    QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
    return QTest::qWaitFor([&] { return document().iteration() == iteration; }, kPatience);
  }
};

}  // namespace

class TouchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aStrokeInASlicePinsWhatItCoversIsListedAndTakenAway();
  void aStrokeIn3dPinsTheSideThatIsSeen();
  void pinsAreSavedAndTheCommandLineReplaysThem();
  void pinsAreDrawnInSlicesAndIn3dAndHidden();
  void theOutlineIsPulledByAPointAndUndoTakesItBack();
  void theSurfaceIsPulledIn3d();
  void aLineAcrossTheOutlineCutsThere();
  void whatIsRefusedSaysWhyAndChangesNothing();
  void aClickSmoothsUnderTheBrush();
  void theKeysAndTheButtonsTurnItOnAndASurfaceThatGoesTurnsItOff();
  void aSessionOpensWithItsCrosshairAndWithoutSlicesIn3d();
  void aSessionOpensWithItsCameraAndItsViews();
};

void TouchTest::aStrokeInASlicePinsWhatItCoversIsListedAndTakenAway() {
  Grown o;
  QVERIFY(o.ready);
  o.window->viewState().brush().setRadius(2);
  QTest::keyClick(o.window.get(), Qt::Key_L);
  QVERIFY(o.window->commands()[Command::pinByBrush]->isChecked());
  const int entries = o.document().undoStack()->count(), iteration = o.document().iteration();
  o.drag(kLeft, kLeft + Vec3(0, 1, 0));  // deep within: nothing lies there
  QVERIFY2(o.window->messages().text().contains("nothing is pinned"),
           qPrintable(o.window->messages().text()));
  QCOMPARE(o.document().undoStack()->count(), entries);
  o.drag(o.end + Vec3(0, -4, 0), o.end + Vec3(0, 4, 0));
  const std::vector<Pin> pins = o.document().constraints().pins;
  QVERIFY(pins.size() > 1);
  for (const Pin& pin : pins) QVERIFY(pin.radius == 2 && pin.iteration == iteration);
  QCOMPARE(o.document().undoStack()->count(), entries + 1);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pin"));
  o.keepPicture("pinned_by_brush");

  auto* section = o.window->findChild<ui::HeldSection*>();
  auto* table = section->findChild<QTableWidget*>();
  QCOMPARE(table->rowCount(), 1);  // the stroke
  QVERIFY2(table->item(0, 0)->text().contains("balls"), qPrintable(table->item(0, 0)->text()));
  table->selectRow(0);
  QTest::mouseClick(section->findChild<QPushButton*>(), Qt::LeftButton);
  QVERIFY(o.document().constraints().empty());
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().pins == pins);

  QTest::keyClick(o.window.get(), Qt::Key_L, Qt::ShiftModifier);
  o.drag(kLeft, kLeft);  // touches no vertex
  QVERIFY(o.document().constraints().pins == pins);
  o.drag(o.end + Vec3(0, -5, 0), o.end + Vec3(0, 5, 0));
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Unpin"));
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QTest::mouseClick(o.button("Remove all pins"), Qt::LeftButton);
  QVERIFY(o.document().constraints().empty());
}

void TouchTest::aStrokeIn3dPinsTheSideThatIsSeen() {
  Grown o;
  QVERIFY(o.ready);
  if (!o.surface().hasOpenGl()) QSKIP("no OpenGL");
  o.lookFromFront();
  o.window->viewState().brush().setRadius(2);
  QTest::keyClick(o.window.get(), Qt::Key_L);
  const QPoint middle = o.middle3d();
  o.drag3d(middle - QPoint(15, 0), middle + QPoint(15, 0), "pinning_in_3d");  // over the bar
  const std::vector<Pin> pins = o.document().constraints().pins;
  QVERIFY(!pins.empty());
  for (const Pin& pin : pins) QVERIFY(pin.centre.y() < kNeck.y());  // anterior
  o.keepPicture("pinned_in_3d");
  const std::size_t before = pins.size();
  o.drag3d(QPoint(12, 60), QPoint(40, 60));  // beside it: the camera's
  QCOMPARE(o.document().constraints().pins.size(), before);
}

void TouchTest::pinsAreSavedAndTheCommandLineReplaysThem() {
  Grown o;
  QVERIFY(o.ready);
  o.document().goTo(o.document().lastIteration() / 2);
  QVERIFY(QTest::qWaitFor([&] { return o.document().state() == GrowthState::paused; }, kPatience));
  const Vec3 place = o.document().snapshot()->mesh.points.front();
  o.window->viewState().setCrosshair(place);
  QCoreApplication::processEvents();
  QTest::keyClick(o.window.get(), Qt::Key_L);
  o.drag(place, place + Vec3(0, 1, 0));
  const auto pins = o.document().constraints().pins;
  QVERIFY(!pins.empty());
  QVERIFY(o.grow());
  QVERIFY(o.document().snapshot()->certificate.passes());
  QSignalSpy saved(&o.document(), &ui::Document::sessionSaved);
  const QString session = o.folder.filePath("pinned.json"), mesh = o.folder.filePath("pinned.stl");
  o.document().saveSession(session);
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QSignalSpy written(&o.document(), &ui::Document::exported);
  o.document().exportResult(mesh, CoordinateSpace::lps);
  QVERIFY(!written.isEmpty() || written.wait(kPatience));
  const QString again = o.folder.filePath("again.stl"), report = o.folder.filePath("again.json");
  QCOMPARE(QProcess::execute(HANDLEBODY_CLI, {"replay", session, "-o", again, "--report", report}), 0);
  QFile first(mesh), second(again), told(report);
  QVERIFY(first.open(QIODevice::ReadOnly) && second.open(QIODevice::ReadOnly) &&
          told.open(QIODevice::ReadOnly));
  QVERIFY(first.readAll() == second.readAll());
  QVERIFY(told.readAll().contains("\"pinned\""));
}

void TouchTest::pinsAreDrawnInSlicesAndIn3dAndHidden() {
  Grown o;
  QVERIFY(o.ready);
  o.window->viewState().setSlicesIn3d(false);
  const int before = pinPixels(o.axial().picture());
  QTest::keyClick(o.window.get(), Qt::Key_L);
  QTest::mousePress(&o.axial(), Qt::LeftButton, {}, o.pixel(o.end));
  QVERIFY(pinPixels(o.axial().picture()) > before + 20);  // while it is drawn
  QTest::mouseRelease(&o.axial(), Qt::LeftButton, {}, o.pixel(o.end));
  const int held = pinPixels(o.axial().picture());
  QVERIFY(held > before + 20);
  QAction* shown = o.window->commands()[Command::wallsAndPins];
  QVERIFY(shown->isChecked());
  if (o.surface().hasOpenGl()) {
    o.lookFromFront();
    QTest::keyClick(&o.surface(), Qt::Key_PageDown, Qt::ShiftModifier);  // from the right
    const int seen = pinPixels(o.surface().picture());
    shown->trigger();
    QVERIFY(seen > pinPixels(o.surface().picture()) + 100);
    shown->trigger();
  }
  shown->trigger();
  QVERIFY(pinPixels(o.axial().picture()) <= before);
  QTest::keyClick(o.window.get(), Qt::Key_B);  // a brush shows them
  QVERIFY(shown->isChecked());
  QVERIFY(pinPixels(o.axial().picture()) > before);
}

void TouchTest::theOutlineIsPulledByAPointAndUndoTakesItBack() {
  Grown o;
  QVERIFY(o.ready);
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration(), entries = o.document().undoStack()->count();
  o.window->viewState().brush().setRadius(4);
  QTest::keyClick(o.window.get(), Qt::Key_U);
  const Vec3 to = o.end - Vec3(3, 0, 0);
  QVERIFY(o.edited([&] { o.drag(o.end, to); }));
  QCOMPARE(o.document().iteration(), iteration + 1);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QCOMPARE(o.document().undoStack()->count(), entries + 1);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pull here"));
  const MeshEdit edit = o.document().constraints().edits.at(0);
  QVERIFY(edit.kind == MeshEditKind::pull && edit.radius == 4);
  QVERIFY(o.isNear(edit.vector, to, 1));
  const auto& points = o.document().snapshot()->mesh.points;
  QVERIFY(std::find(points.begin(), points.end(), edit.vector) != points.end());
  o.keepPicture("pulled_by_dragging");
  QVERIFY(o.undone(iteration));
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
}

void TouchTest::theSurfaceIsPulledIn3d() {
  Grown o;
  QVERIFY(o.ready);
  if (!o.surface().hasOpenGl()) QSKIP("no OpenGL");
  o.lookFromFront();
  const int iteration = o.document().iteration();
  QTest::keyClick(o.window.get(), Qt::Key_U);
  QVERIFY(o.edited([&] { o.drag3d(o.middle3d(), o.middle3d() - QPoint(0, 12), "pulling_in_3d"); }));
  const MeshEdit edit = o.document().constraints().edits.at(0);
  QVERIFY(edit.vector.z() > edit.place.z());  // up is superior
  QVERIFY(std::abs(edit.vector.y() - edit.place.y()) < 1e-9);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QVERIFY(o.undone(iteration));
}

void TouchTest::aLineAcrossTheOutlineCutsThere() {
  Grown o;
  QVERIFY(o.ready);
  const int iteration = o.document().iteration(),
            components = o.document().snapshot()->certificate.components;
  const double volume = o.document().snapshot()->certificate.volume;
  QTest::keyClick(o.window.get(), Qt::Key_X);
  const Vec3 middle = kLeft - Vec3(3, 0, 0);
  QVERIFY(o.edited([&] { o.drag(middle - Vec3(0, 12, 0), middle + Vec3(0, 12, 0)); }));
  const ui::Document& document = o.document();
  QCOMPARE(document.snapshot()->certificate.components, components + 1);
  QVERIFY(document.snapshot()->certificate.passes());
  QVERIFY(std::abs(document.snapshot()->certificate.volume / volume - 1) < 0.01);
  const MeshEdit edit = document.constraints().edits.at(0);
  QVERIFY(edit.kind == MeshEditKind::cut && edit.keep == KeptSide::both);
  QVERIFY(o.isNear(edit.place, middle, 1));
  QVERIFY(std::abs(edit.vector.x()) > 0.99 && std::abs(edit.vector.norm() - 1) < 1e-9);
  QVERIFY(std::abs(edit.radius - 12) < 1);
  o.keepPicture("cut_along_a_line");
  QVERIFY(o.undone(iteration));
  QCOMPARE(document.snapshot()->certificate.components, components);
  QSignalSpy made(&o.document(), &ui::Document::meshEdited);
  o.drag(middle, middle);  // a click is no cut
  QVERIFY(!made.wait(200));
}

void TouchTest::whatIsRefusedSaysWhyAndChangesNothing() {
  Grown o;
  QVERIFY(o.ready);
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration();
  o.window->viewState().brush().setRadius(0.5);
  QTest::keyClick(o.window.get(), Qt::Key_U);
  QSignalSpy refused(&o.document(), &ui::Document::refused);
  o.drag(o.end, o.end + Vec3(30, 0, 0));  // 60 radii
  QVERIFY(!refused.isEmpty() || refused.wait(kPatience));
  QVERIFY(!o.window->messages().text().isEmpty());
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().iteration(), iteration);
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Add seed"));
}

void TouchTest::aClickSmoothsUnderTheBrush() {
  Grown o;
  QVERIFY(o.ready);
  const int iteration = o.document().iteration();
  o.window->viewState().brush().setRadius(5);
  QTest::keyClick(o.window.get(), Qt::Key_M);
  QVERIFY(o.edited([&] { QTest::mouseClick(&o.axial(), Qt::LeftButton, {}, o.pixel(o.end)); }));
  const MeshEdit edit = o.document().constraints().edits.at(0);
  QVERIFY(edit.kind == MeshEditKind::smooth && o.isNear(edit.place, o.end, 0.6));
  QVERIFY(o.document().snapshot()->certificate.passes());
  QVERIFY(o.undone(iteration));
}

void TouchTest::theKeysAndTheButtonsTurnItOnAndASurfaceThatGoesTurnsItOff() {
  Opened o;
  QVERIFY(o.ok);
  const ui::Commands& commands = o.window->commands();
  Brush& brush = o.window->viewState().brush();
  QTest::keyClick(o.window.get(), Qt::Key_L);  // there is no surface yet
  QVERIFY(!brush.isOn());
  QVERIFY(!commands[Command::pullByDragging]->isEnabled());
  QVERIFY(o.grow());
  auto* section = o.window->findChild<ui::TouchSection*>();
  const auto buttons = section->findChildren<QAbstractButton*>();
  const auto press = [&](const QString& text) {
    for (QAbstractButton* b : buttons)
      if (b->text() == text) return QTest::mouseClick(b, Qt::LeftButton);
  };
  for (const auto& [text, mode] :
       {std::pair("Pin", Brush::Mode::pin), std::pair("Unpin", Brush::Mode::unpin),
        std::pair("Smooth", Brush::Mode::smooth), std::pair("Pull", Brush::Mode::pull)}) {
    press(text);
    QVERIFY2(brush.mode() == mode, text);
  }
  QTest::keyClick(o.window.get(), Qt::Key_B);
  QVERIFY(brush.mode() == Brush::Mode::paintWalls && !commands[Command::pullByDragging]->isChecked());
  QTest::keyClick(o.window.get(), Qt::Key_M);
  QVERIFY(brush.mode() == Brush::Mode::smooth);
  o.keepPicture("brush_on_the_surface");
  o.document().addObject();  // without a surface
  QVERIFY(!brush.isOn());
}

void TouchTest::aSessionOpensWithItsCrosshairAndWithoutSlicesIn3d() {
  Opened o;
  QVERIFY(o.ok);
  o.document().setView(R"({"crosshair": [21, 20, 23], "slicesIn3d": false})");
  QSignalSpy saved(&o.document(), &ui::Document::sessionSaved);
  const QString session = o.folder.filePath("view.json");
  o.document().saveSession(session);
  QVERIFY(!saved.isEmpty() || saved.wait(kPatience));
  QVERIFY(open(*o.window, session));
  QCOMPARE(o.window->viewState().crosshair(), Vec3(21, 20, 23));
  QVERIFY(!o.window->viewState().slicesIn3d());
  QVERIFY(!o.window->commands()[Command::slicesIn3d]->isChecked());
}

void TouchTest::aSessionOpensWithItsCameraAndItsViews() {
  Opened o;
  QVERIFY(o.ok);
  ui::ViewGrid& views = o.window->views();
  if (!views.surface().hasOpenGl()) QSKIP("no OpenGL");
  views.maximise(ui::Cell::surface);
  const ui::CameraPose pose{Vec3(20, 21, 22), Vec3(0, -0.6, 0.8), Vec3(0, 0.8, 0.6), 33};
  views.surface().setCamera({pose, false});
  QSignalSpy saved(&o.document(), &ui::Document::sessionSaved);
  const QString session = o.folder.filePath("camera.json");
  const auto isSaved = [&] { return !saved.isEmpty() || saved.wait(kPatience); };
  o.document().saveSession(session);
  QVERIFY(isSaved());
  saved.clear();
  o.window->commands()[Command::saveSession]->trigger();  // with what the window keeps
  QVERIFY(isSaved());
  views.maximise(std::nullopt);
  views.resetViews();
  QVERIFY(open(*o.window, session));
  QVERIFY(views.maximised() == ui::Cell::surface);
  const auto camera = views.surface().camera();
  QVERIFY(camera && !camera->follows);
  QVERIFY((camera->pose.focus - pose.focus).norm() < 1e-9 && (camera->pose.up - pose.up).norm() < 1e-9);
  QVERIFY((camera->pose.towardsEye - pose.towardsEye).norm() < 1e-9);
  QVERIFY(std::abs(camera->pose.height - pose.height) < 1e-9);
  // One that looks nowhere is left out.
  o.document().setView(
      R"({"camera": {"focus": [1, 2, 3], "towardsEye": [0, 0, 0], "up": [0, 0, 0], "height": -1}})");
  saved.clear();
  o.document().saveSession(session);
  QVERIFY(isSaved());
  QVERIFY(open(*o.window, session));
  QVERIFY(views.surface().camera()->follows);
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  TouchTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "touch_test.moc"
