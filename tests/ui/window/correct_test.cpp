// The step Correct by mouse and keys: walls painted, erased, undone; ways out of a wall over the surface;
// what is held back lifted.

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>

#include "tests/ui/window/correct_support.h"
#include "ui/window/correct/wall_section.h"
#include "ui/window/grow/held_section.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::Brush;
using ui::Command;
using ui::GrowthState;
using ui::Plane;

namespace {

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

//! Of a channel of a pixel; the rims of texts may differ by a level from picture to picture.
int largestDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 255;
  int largest = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (const int d : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)})
        largest = std::max(largest, std::abs(d));
    }
  return largest;
}

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
  void aPictureOfAllViewsHasTheWallsAtOnce();
  void aWallIsPutUpAtTheCrosshairByKey();
  void whatIsHeldBackIsListedFoundAndLifted();
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
  Brush& brush = o.window->viewState().brush();
  const ui::Commands& commands = o.window->commands();
  QTest::keyClick(o.window.get(), Qt::Key_B);
  QVERIFY(brush.mode() == Brush::Mode::paintWalls);
  QVERIFY(commands[Command::paintWalls]->isChecked());
  QTest::keyClick(o.window.get(), Qt::Key_E);
  QVERIFY(brush.mode() == Brush::Mode::eraseWalls);
  QVERIFY(commands[Command::eraseWalls]->isChecked() && !commands[Command::paintWalls]->isChecked());
  QTest::mouseClick(o.button("Paint walls"), Qt::LeftButton);
  QVERIFY(brush.mode() == Brush::Mode::paintWalls);
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
  Brush& brush = o.window->viewState().brush();
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
  QVERIFY(QTest::qWaitFor([&] { return o.window->messages().text().contains("already where the wall is"); },
                          kPatience));
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

void CorrectTest::aPictureOfAllViewsHasTheWallsAtOnce() {
  Opened o;
  QVERIFY(o.ok);
  ui::ViewGrid& views = o.window->views();
  o.axial().setFocus();
  o.window->viewState().setSlicesIn3d(false);
  const auto partOf = [&](const QImage& all, const QWidget& view) {
    const double ratio = all.devicePixelRatio();
    return all.copy(QRect(view.mapTo(&views, QPoint(0, 0)) * ratio, view.size() * ratio));
  };
  const int before = pixelsLike(partOf(views.picture(std::nullopt), views.surface()), kViolet);
  Constraints map;
  map.walls.map = testing::wallMap(o.document().volume().grid, [](int i, int, int) { return i > 30; });
  o.document().setConstraints(map, "Map");
  const QImage all = views.picture(std::nullopt);  // none of the views has been painted since
  if (views.surface().hasOpenGl()) QVERIFY(pixelsLike(partOf(all, views.surface()), kViolet) > before + 100);
  // As each of them alone: without the keyboard's focus and the buttons over them.
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal})
    QVERIFY(largestDifference(partOf(all, views.slice(plane)), views.slice(plane).picture()) <= 2);
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

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Handlebody");
  QApplication::setApplicationName("handlebody-test");
  CorrectTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "correct_test.moc"
