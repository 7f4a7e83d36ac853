// The step Correct by mouse and keys: walls painted, erased, undone; ways out of a wall over the surface;
// what is held back lifted; pins and edits at the crosshair.

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QWheelEvent>
#include <set>

#include "core/io/volume_io.h"
#include "tests/support/test_volume.h"
#include "tests/support/wall_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/view/slice_geometry.h"
#include "ui/window/held_section.h"
#include "ui/window/local_section.h"
#include "ui/window/wall_section.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Command;
using ui::GrowthState;
using ui::Plane;
using ui::WallBrush;

namespace {

const Vec3 kLeft(12, 20, 20), kRight(30, 20, 20), kNeck(21, 20, 20);

//! Two dark balls with a wide bar between them, at the same places however the columns are counted.
QString writeBalls(const QTemporaryDir& folder, bool fromTheLeft) {
  const QString path = folder.filePath("balls.nii.gz");
  const auto intensity = [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const bool between = p.x() > kLeft.x() && p.x() < kRight.x();
    const double bar = between ? std::hypot(p.y() - 20, p.z() - 20) - 3.5 : 100;
    const double distance = std::min({(p - kLeft).norm() - 8.0, (p - kRight).norm() - 8.0, bar});
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 110 + 90 * std::clamp(distance, -1.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  Grid grid = testing::cubicGrid(43);
  if (fromTheLeft) {
    grid.direction.col(0) = Vec3(-1, 0, 0);
    grid.origin = Vec3(42, 0, 0);
  }
  writeVolume(testing::volumeByIndex(grid, intensity), path.toStdString());
  return path;
}

struct Opened {
  QTemporaryDir folder;
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = false;

  explicit Opened(bool fromTheLeft = false) {
    if (!window || !open(*window, writeBalls(folder, fromTheLeft))) return;
    Parameters p = window->document().parameters();
    p.range = IntensityRange{-1000, 110};  // all that is dark: nothing else holds it back
    window->document().setParameters(p, "Range");
    window->viewState().setCrosshair(kLeft);
    QTest::keyClick(window.get(), Qt::Key_Return);
    window->showStep(Command::stepCorrect);
    ok = window->document().seeds().size() == 1;
  }
  ui::Document& document() { return window->document(); }
  ui::SliceView& axial() { return window->views().slice(Plane::axial); }
  QPoint pixel(const Vec3& world) {
    ui::SliceGeometry geometry(document().volume().grid, Plane::axial, axial().size());
    geometry.setSlice(geometry.nearestSlice(window->viewState().crosshair()));
    return geometry.worldToScreen(world).toPoint();
  }
  //! As a hand does: in steps of a few pixels.
  void drag(const Vec3& from, const Vec3& to) {
    QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(from));
    for (int i = 1; i <= 10; ++i) {
      const QPoint at = pixel(from + i / 10.0 * (to - from));
      QMouseEvent move(QEvent::MouseMove, at, axial().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&axial(), &move);
    }
    QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pixel(to));
  }
  void turnWheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys) {
    QWheelEvent event(at, axial().mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&axial(), &event);
  }
  //! To the end; the step Correct is shown.
  bool grow() {
    document().run();
    const bool done = waitFor(*window, GrowthState::finished);
    window->showStep(Command::stepCorrect);
    return done && document().snapshot();
  }
  QDoubleSpinBox* localRadius() {
    return window->findChild<ui::LocalSection*>()->findChild<QDoubleSpinBox*>();
  }
  QAbstractButton* choice(const QString& name) {
    const auto all = window->findChild<ui::LocalSection*>()->findChildren<QAbstractButton*>();
    for (QAbstractButton* b : all)
      if (b->accessibleName() == name) return b;
    return nullptr;
  }
  //! The window as it is seen in both appearances; to be looked at.
  void keepPicture(const QString& name) {
    const QString pictures = qEnvironmentVariable("HANDLEBODY_KEEP_PICTURES");
    if (pictures.isEmpty()) return;
    for (const auto appearance : {ui::Appearance::dark, ui::Appearance::light}) {
      window->setAppearance(appearance);
      QTest::qWait(300);
      window->grab().save(pictures + '/' + name +
                          (appearance == ui::Appearance::dark ? "_dark.png" : "_light.png"));
    }
  }
  double clearance() {
    return testing::clearance(Mesh(document().snapshot()->mesh), document().constraints().walls.balls);
  }
  double furthest() {
    double x = 0;
    for (const Vec3& p : document().snapshot()->mesh.points) x = std::max(x, p.x());
    return x;
  }
  QAbstractButton* button(const QString& text) {
    const auto all = window->findChildren<QAbstractButton*>();
    for (QAbstractButton* b : all)
      if (b->isVisible() && b->text() == text) return b;
    return nullptr;
  }
};

std::set<std::array<double, 3>> coordinates(const TriangleSoup& mesh) {
  std::set<std::array<double, 3>> all;
  for (const Vec3& p : mesh.points) all.insert({p.x(), p.y(), p.z()});
  return all;
}

int pixelsLike(const QImage& picture, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      count += std::abs(c.hue() - colour.hue()) < 15 && c.saturation() > 60;
    }
  return count;
}

const QColor kViolet(0xd8, 0x5c, 0xf0);
const Vec3 kAbove = kNeck - Vec3(0, 6, 0), kBelow = kNeck + Vec3(0, 6, 0);

}  // namespace

class CorrectTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aStrokeBecomesAWallThatTheSurfaceStaysOutOf();
  void theKeysTurnTheBrushOnAndOffAndEscapeGivesUpAStroke();
  void theRadiusFollowsTheWheelTheKeysAndTheField();
  void theEraserTakesAStrokeAwayAndUndoBringsItBack();
  void aStrokeOverTheSurfaceOffersTheWayBackAndGrowsOn();
  void aStrokeOverTheSeedIsNotKeptAndSaysWhy();
  void wallsAreDrawnInTheSlicesAndIn3d();
  void aWallIsPutUpAtTheCrosshairByKey();
  void whatIsHeldBackIsListedFoundAndLifted();
  void aPinIsPutDownByKeyListedFoundAndLifted();
  void theSurfaceIsSmoothedWhereItIsNearestToTheCrosshair();
  void theNearestPointOfTheSurfaceIsPulledToTheCrosshair();
  void theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept_data();
  void theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept();
  void withoutASurfaceOrOnALockedObjectNothingIsPinnedOrEdited();
};

void CorrectTest::aStrokeBecomesAWallThatTheSurfaceStaysOutOf() {
  Opened o;
  QVERIFY(o.ok);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  o.window->viewState().brush().setRadius(4);
  o.drag(kAbove, kBelow);
  const auto& balls = o.document().constraints().walls.balls;
  QVERIFY(balls.size() >= 5);
  QCOMPARE(o.document().undoStack()->undoText(), QString("Paint wall"));
  QCOMPARE(o.document().undoStack()->count(), 3);  // range, seed, one stroke
  for (const WallBall& ball : balls) QVERIFY(std::abs(ball.centre.x() - kNeck.x()) < 0.6);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  QTest::keyClick(o.window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QVERIFY(o.clearance() > 0);
  QVERIFY(o.furthest() < kNeck.x());
  QVERIFY(o.document().snapshot()->certificate.passes());
}

void CorrectTest::theKeysTurnTheBrushOnAndOffAndEscapeGivesUpAStroke() {
  Opened o;
  QVERIFY(o.ok);
  WallBrush& brush = o.window->viewState().brush();
  const ui::Commands& commands = o.window->commands();
  QTest::keyClick(o.window.get(), Qt::Key_B);
  QVERIFY(brush.mode() == WallBrush::Mode::paint);
  QVERIFY(commands[Command::paintWalls]->isChecked());
  QTest::keyClick(o.window.get(), Qt::Key_E);
  QVERIFY(brush.mode() == WallBrush::Mode::erase);
  QVERIFY(commands[Command::eraseWalls]->isChecked() && !commands[Command::paintWalls]->isChecked());
  QTest::mouseClick(o.button("Paint walls"), Qt::LeftButton);
  QVERIFY(brush.mode() == WallBrush::Mode::paint);
  const Vec3 crosshair = o.window->viewState().crosshair();
  QTest::mousePress(&o.axial(), Qt::LeftButton, {}, o.pixel(kNeck));
  QVERIFY(!brush.stroke().empty());
  QTest::keyClick(&o.axial(), Qt::Key_Escape);
  QVERIFY(brush.stroke().empty() && brush.isOn());
  QTest::mouseRelease(&o.axial(), Qt::LeftButton, {}, o.pixel(kNeck));
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.window->viewState().crosshair(), crosshair);  // painting does not move it
  QTest::keyClick(&o.axial(), Qt::Key_Escape);
  QVERIFY(!brush.isOn());
  QVERIFY(!o.button("Paint walls")->isChecked());
  QTest::mouseClick(&o.axial(), Qt::LeftButton, {}, o.pixel(kNeck));
  QVERIFY(o.window->viewState().crosshair() != crosshair);
}

void CorrectTest::theRadiusFollowsTheWheelTheKeysAndTheField() {
  Opened o;
  QVERIFY(o.ok);
  WallBrush& brush = o.window->viewState().brush();
  auto* field = o.window->findChild<ui::WallSection*>()->findChild<QDoubleSpinBox*>();
  QVERIFY(field && field->isVisible());
  QCOMPARE(brush.radius(), 3.0);
  QCOMPARE(field->value(), 3.0);
  field->setValue(5);
  QCOMPARE(brush.radius(), 5.0);
  QTest::keyClick(o.window.get(), Qt::Key_BracketRight, Qt::ControlModifier);
  QVERIFY(std::abs(brush.radius() - 5.5) < 1e-9);
  QTest::keyClick(o.window.get(), Qt::Key_BracketLeft, Qt::ControlModifier);
  QVERIFY(std::abs(brush.radius() - 5) < 1e-9);
  const QPoint at = o.pixel(kNeck);
  const QImage before = o.axial().picture();
  o.turnWheel(at, 1, Qt::ControlModifier);  // the brush is off: zooms
  QVERIFY(std::abs(brush.radius() - 5) < 1e-9);
  QVERIFY(o.axial().picture() != before);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  o.turnWheel(at, 2, Qt::ControlModifier);
  QVERIFY(std::abs(brush.radius() - 5 * 1.21) < 1e-9);
  QVERIFY(std::abs(field->value() - 6.05) < 0.01);
  for (int i = 0; i < 100; ++i) o.turnWheel(at, -1, Qt::ControlModifier);
  QCOMPARE(brush.radius(), 0.5);
}

void CorrectTest::theEraserTakesAStrokeAwayAndUndoBringsItBack() {
  Opened o;
  QVERIFY(o.ok);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  o.drag(kAbove, kBelow);
  const WallList walls = o.document().constraints().walls;
  QTest::keyClick(o.window.get(), Qt::Key_E);
  o.window->viewState().brush().setRadius(1);
  o.drag(kBelow, kBelow);
  const std::size_t left = o.document().constraints().walls.balls.size();
  QVERIFY(left > 0 && left < walls.balls.size());
  o.window->viewState().brush().setRadius(3);
  o.drag(kAbove, kBelow);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Erase wall"));
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().walls == walls);
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().empty());
}

void CorrectTest::aStrokeOverTheSurfaceOffersTheWayBackAndGrowsOn() {
  Opened o;
  QVERIFY(o.ok);
  o.document().setPausesAtLeaks(false);
  QTest::keyClick(o.window.get(), Qt::Key_Space);
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QVERIFY(o.furthest() > kRight.x());
  o.window->showStep(Command::stepCorrect);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  o.window->viewState().brush().setRadius(4);
  o.drag(kAbove, kBelow);
  QVERIFY(o.window->messages().text().contains("already where the wall is"));
  QVERIFY(!o.button("Push it out"));  // it moves outward alone
  QAbstractButton* back = o.button("Go back to before it came in here");
  QVERIFY(back);
  QTest::mouseClick(back, Qt::LeftButton);
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QVERIFY(o.clearance() > 0);
  QVERIFY(o.furthest() < kNeck.x());
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().empty());
}

void CorrectTest::aStrokeOverTheSeedIsNotKeptAndSaysWhy() {
  Opened o;
  QVERIFY(o.ok);
  const int entries = o.document().undoStack()->count();
  QTest::keyClick(o.window.get(), Qt::Key_B);
  o.drag(kLeft - Vec3(5, 0, 0), kLeft);
  QVERIFY(o.window->messages().text().contains("over the seed"));
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->count(), entries);
  QCOMPARE(o.document().seeds().size(), std::size_t(1));
}

void CorrectTest::wallsAreDrawnInTheSlicesAndIn3d() {
  Opened o;
  QVERIFY(o.ok);
  const int before = pixelsLike(o.axial().picture(), kViolet);
  QTest::keyClick(o.window.get(), Qt::Key_B);
  QTest::mousePress(&o.axial(), Qt::LeftButton, {}, o.pixel(kNeck));
  QVERIFY(pixelsLike(o.axial().picture(), kViolet) > before + 300);  // while it is drawn
  QTest::mouseRelease(&o.axial(), Qt::LeftButton, {}, o.pixel(kNeck));
  QVERIFY(pixelsLike(o.axial().picture(), kViolet) > before + 300);
  QVERIFY(pixelsLike(o.window->views().slice(Plane::sagittal).picture(), kViolet) < 20);  // not there yet
  o.window->viewState().setCrosshair(kNeck);
  QVERIFY(pixelsLike(o.window->views().slice(Plane::sagittal).picture(), kViolet) > 300);
  if (o.window->views().surface().hasOpenGl()) {
    o.window->viewState().setSlicesIn3d(false);
    QVERIFY(pixelsLike(o.window->views().surface().picture(), kViolet) > 100);
  }
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(pixelsLike(o.axial().picture(), kViolet) <= before + 20);

  Constraints discs;
  discs.walls.discs = {{kNeck, Vec3(1, 0, 0), 6}};
  o.document().setConstraints(discs, "Disc");
  QVERIFY(pixelsLike(o.axial().picture(), kViolet) > before + 60);                         // a line
  QVERIFY(pixelsLike(o.window->views().slice(Plane::sagittal).picture(), kViolet) > 300);  // all of it
  Constraints map;
  map.walls.map = testing::wallMap(o.document().volume().grid, [](int i, int, int) { return i > 30; });
  o.document().setConstraints(map, "Map");
  QVERIFY(pixelsLike(o.axial().picture(), kViolet) > before + 3000);
}

void CorrectTest::aWallIsPutUpAtTheCrosshairByKey() {
  Opened o;
  QVERIFY(o.ok);
  o.window->viewState().setCrosshair(kNeck);
  QTest::keyClick(o.window.get(), Qt::Key_B, Qt::ShiftModifier);
  QCOMPARE(o.document().constraints().walls.balls.size(), std::size_t(1));
  QCOMPARE(o.document().constraints().walls.balls[0].centre, kNeck);
  QTest::keyClick(o.window.get(), Qt::Key_E, Qt::ShiftModifier);
  QVERIFY(o.document().constraints().empty());
  QTest::keyClick(o.window.get(), Qt::Key_B, Qt::ShiftModifier);
  QTest::keyClick(o.window.get(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Remove all walls"));
}

void CorrectTest::whatIsHeldBackIsListedFoundAndLifted() {
  Opened o;
  QVERIFY(o.ok);
  auto* section = o.window->findChild<ui::HeldSection*>();
  auto* table = section->findChild<QTableWidget*>();
  auto* lift = section->findChild<QPushButton*>();
  QVERIFY(!table->isVisible());
  Constraints some;
  some.walls.discs = {{kNeck, Vec3(1, 0, 0), 6}};
  some.vetoes = {{12, Vec3(15, 20, 20)}};
  some.topology = {2, {}, {Vec3(18, 20, 20)}};
  o.document().setConstraints(some, "Some");
  QVERIFY(table->isVisible());
  QCOMPARE(table->rowCount(), 4);
  QVERIFY(!lift->isEnabled());
  const int disc = 3;
  QVERIFY(table->item(disc, 0)->text().startsWith("Disc"));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                    table->visualItemRect(table->item(disc, 0)).center());
  QCOMPARE(o.window->viewState().crosshair(), kNeck);
  QVERIFY(lift->isEnabled());
  QTest::mouseClick(lift, Qt::LeftButton);
  QVERIFY(o.document().constraints().walls.discs.empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Lift the disc"));
  QCOMPARE(table->rowCount(), 3);
  table->selectRow(0);  // the limit, without which no place needs to be allowed
  QTest::mouseClick(lift, Qt::LeftButton);
  QVERIFY(o.document().constraints().topology.empty());
  table->setFocus();
  table->selectRow(0);
  QTest::keyClick(table, Qt::Key_Delete);
  QCOMPARE(o.document().seeds().size(), std::size_t(1));  // the selected seed stays
  QVERIFY(o.document().constraints().empty());
  QVERIFY(!table->isVisible());
  for (int i = 0; i < 3; ++i) QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints() == some);
}

void CorrectTest::aPinIsPutDownByKeyListedFoundAndLifted() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const Vec3 place = o.document().snapshot()->mesh.points.front();
  const int iteration = o.document().iteration();
  o.window->viewState().setCrosshair(Vec3(5, 36, 36));  // far from the surface
  const int entries = o.document().undoStack()->count();
  o.localRadius()->setValue(2);
  QTest::keyClick(o.window.get(), Qt::Key_P, Qt::ShiftModifier);
  QVERIFY2(o.window->messages().text().contains("nothing is pinned"),
           qPrintable(o.window->messages().text()));
  QCOMPARE(o.document().undoStack()->count(), entries);

  o.window->viewState().setCrosshair(place);
  QTest::mouseClick(o.button("Pin"), Qt::LeftButton);
  QVERIFY(o.window->messages().text().startsWith("The surface is pinned here"));
  QVERIFY(o.document().constraints().pins == std::vector<Pin>({{place, 2, iteration}}));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pin here"));
  o.keepPicture("pinned");
  auto* section = o.window->findChild<ui::HeldSection*>();
  auto* table = section->findChild<QTableWidget*>();
  QCOMPARE(table->rowCount(), 1);
  QVERIFY(table->item(0, 0)->text().startsWith("Pin at iteration"));
  o.window->viewState().setCrosshair(kRight);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->item(0, 0)).center());
  QCOMPARE(o.window->viewState().crosshair(), place);
  QTest::mouseClick(section->findChild<QPushButton*>(), Qt::LeftButton);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Lift the pin"));
  for (int i = 0; i < 2; ++i) QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(o.document().constraints().empty());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Add seed"));
}

void CorrectTest::theSurfaceIsSmoothedWhereItIsNearestToTheCrosshair() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration();
  o.window->viewState().setCrosshair(kLeft - Vec3(11, 0, 0));  // beside the end of the left ball
  o.localRadius()->setValue(6);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_S, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(o.document().iteration(), iteration + 1);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Smooth here"));
  const MeshEdit& edit = o.document().constraints().edits.at(0);
  QVERIFY(edit.kind == MeshEditKind::smooth && edit.radius == 6);
  const TriangleSoup after = o.document().snapshot()->mesh;
  QCOMPARE(after.points.size(), before.points.size());
  const std::set<std::array<double, 3>> there = coordinates(after);
  int moved = 0;
  for (const Vec3& p : before.points) {
    if (there.contains({p.x(), p.y(), p.z()})) continue;
    ++moved;
    QVERIFY((p - edit.place).norm() <= 6);
    QVERIFY(p.x() < kLeft.x());
  }
  QVERIFY2(moved > 10, qPrintable(QString::number(moved)));
  QVERIFY2(o.window->messages().text().startsWith("Smoothed by hand: "),
           qPrintable(o.window->messages().text()));
  o.keepPicture("smoothed");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
  QVERIFY(o.document().constraints().empty());
}

void CorrectTest::theNearestPointOfTheSurfaceIsPulledToTheCrosshair() {
  Opened o;
  QVERIFY(o.ok && o.grow());
  const TriangleSoup before = o.document().snapshot()->mesh;
  const int iteration = o.document().iteration();
  const Vec3 there = kLeft - Vec3(11, 0, 0);
  QVERIFY(!coordinates(before).contains({there.x(), there.y(), there.z()}));
  o.window->viewState().setCrosshair(there);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_U, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(o.document().iteration(), iteration + 1);
  QVERIFY(o.document().snapshot()->certificate.passes());
  QVERIFY(coordinates(o.document().snapshot()->mesh).contains({there.x(), there.y(), there.z()}));
  QCOMPARE(o.document().undoStack()->undoText(), QString("Pull here"));
  o.keepPicture("pulled");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QVERIFY(o.document().snapshot()->mesh.points == before.points);
}

void CorrectTest::theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept_data() {
  QTest::addColumn<bool>("fromTheLeft");
  QTest::newRow("columns to the left") << false;
  QTest::newRow("columns to the right") << true;
}

void CorrectTest::theSurfaceIsCutAlongTheChosenPlaneAndOneSideIsKept() {
  QFETCH(bool, fromTheLeft);
  Opened o(fromTheLeft);
  QVERIFY(o.ok && o.grow());
  const int iteration = o.document().iteration();
  const auto bodies = [&] { return o.document().snapshot()->certificate.genus.size(); };
  QCOMPARE(bodies(), std::size_t(1));
  QVERIFY(o.button("Superior") && !o.button("Left"));
  QTest::mouseClick(o.choice("Plane: Sagittal"), Qt::LeftButton);
  QVERIFY(o.button("Left") && o.button("Right") && !o.button("Superior"));
  o.window->viewState().setCrosshair(kNeck);
  QSignalSpy edited(&o.document(), &ui::Document::meshEdited);
  QTest::keyClick(o.window.get(), Qt::Key_C, Qt::ShiftModifier);
  QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
  QCOMPARE(bodies(), std::size_t(2));
  QVERIFY(o.document().snapshot()->certificate.passes());
  QCOMPARE(o.document().undoStack()->undoText(), QString("Cut here"));
  o.keepPicture("cut");
  QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  QCOMPARE(bodies(), std::size_t(1));

  for (const bool left : {true, false}) {  // larger x is further left: LPS
    QTest::mouseClick(o.choice(left ? "Keep: Left" : "Keep: Right"), Qt::LeftButton);
    edited.clear();
    QTest::mouseClick(o.button("Cut"), Qt::LeftButton);
    QVERIFY(!edited.isEmpty() || edited.wait(kPatience));
    QCOMPARE(bodies(), std::size_t(1));
    QCOMPARE(o.furthest() > kRight.x(), left);
    QTest::keyClick(o.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return o.document().iteration() == iteration; }, kPatience));
  }
  // A plane that meets nothing: said, and no entry of the undo list is left.
  const int entries = o.document().undoStack()->count();
  o.window->viewState().setCrosshair(Vec3(1, 20, 20));
  QSignalSpy refused(&o.document(), &ui::Document::refused);
  QTest::mouseClick(o.button("Cut"), Qt::LeftButton);
  QVERIFY(!refused.isEmpty() || refused.wait(kPatience));
  QVERIFY(o.document().constraints().empty());
  QVERIFY(o.document().undoStack()->count() <= entries);
}

void CorrectTest::withoutASurfaceOrOnALockedObjectNothingIsPinnedOrEdited() {
  Opened o;
  QVERIFY(o.ok);
  const ui::Commands& commands = o.window->commands();
  const auto isAny = [&](bool wanted) {
    for (const Command id : {Command::pinHere, Command::smoothHere, Command::pullHere, Command::cutHere})
      if (commands[id]->isEnabled() == wanted) return true;
    return false;
  };
  QVERIFY(!isAny(true));
  o.document().run();
  QVERIFY(!isAny(true));
  QVERIFY(waitFor(*o.window, GrowthState::finished));
  QVERIFY(!isAny(false));
  o.document().setObjectLocked(0, true);
  QVERIFY(!isAny(true));
  o.document().setObjectLocked(0, false);
  QVERIFY(!isAny(false));
  o.document().addObject();
  QVERIFY(!isAny(true));
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  CorrectTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "correct_test.moc"
