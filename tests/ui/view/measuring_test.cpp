// Rulers and angles placed and dragged in the views, with real events.

#include <QSignalSpy>
#include <QUndoStack>
#include <cmath>
#include <iostream>

#include "tests/ui/view/widget_support.h"
#include "ui/model/measurements.h"

#include <Eigen/Geometry>

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

constexpr int kWidth = 400, kHeight = 300;

//! Voxels of 0.7 × 1.3 × 2.5 mm whose axes are those of nothing in particular.
Volume obliqueVolume() {
  Grid grid = handlebody::testing::cubicGrid(40);
  grid.spacing = Vec3(0.7, 1.3, 2.5);
  grid.direction =
      (Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-0.25, Vec3::UnitX()))
          .toRotationMatrix();
  return handlebody::testing::volumeByIndex(grid, [](int i, int j, int k) { return i + j + k; });
}

struct MeasuredSlice : Work {
  explicit MeasuredSlice(Plane plane, const Volume& v = blockVolume()) : view(plane, document, state) {
    volume = v;
    open();
    show(view, {kWidth, kHeight});
    geometry = SliceGeometry(volume.grid, plane, {kWidth, kHeight});
  }
  void click(const QPoint& at) { QTest::mouseClick(&view, Qt::LeftButton, {}, at); }
  const std::vector<Measurement>& list() const { return document.measurements().all(); }
  //! mm between two pixels, by voxels and spacing alone: turning the volume changes nothing of it.
  double between(const QPoint& a, const QPoint& b) const {
    return (geometry.toIndex(b) - geometry.toIndex(a)).cwiseProduct(volume.grid.spacing).norm();
  }

  SliceView view;
  SliceGeometry geometry;
};

//! Within all three slices of both volumes.
const QPoint kFrom(185, 120), kTo(222, 178), kThird(170, 165);

//! With the left button held down.
void moveHeld(QWidget& view, const QPointF& at) {
  QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&view, &move);
}

//! The first is made and deleted, then the second is made: two steps back the first has the place of the
//! second.
void makeOneAfterTheOther(Measurements& list, const Measurement& first, const Measurement& second) {
  list.add(first);
  list.remove(0);
  list.add(second);
}

bool isMark(const QColor& c) {  // of a ruler, chosen or not
  return c.green() > 180 && (c.blue() > 180 || c.red() > 220) && std::abs(c.red() - c.blue()) > 90;
}

}  // namespace

TEST_CASE("Two clicks make a ruler of as many mm as lie between them, with uneven voxels and turned volumes",
          "[measuring]") {
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal})
    for (const Volume& volume : {blockVolume(), obliqueVolume()}) {
      MeasuredSlice slice(plane, volume);
      const Vec3 crosshair = slice.state.crosshair();
      slice.state.measure().setMode(MeasureTool::Mode::ruler);
      slice.click(kFrom);
      CHECK(slice.list().empty());
      CHECK(slice.state.measure().placed().size() == 1);
      slice.click(kTo);
      REQUIRE(slice.list().size() == 1);
      CHECK(std::abs(valueOf(slice.list()[0]) - slice.between(kFrom, kTo)) < 1e-9);
      CHECK(slice.state.crosshair() == crosshair);
      CHECK(!slice.state.measure().isOn());  // the next click is the crosshair's
      for (const Vec3& p : slice.list()[0].points) CHECK(std::abs(slice.geometry.distance(p)) < 1e-9);
    }
}

TEST_CASE("Three clicks make an angle that is right in mm, not in voxels", "[measuring]") {
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    MeasuredSlice slice(plane, obliqueVolume());
    slice.state.measure().setMode(MeasureTool::Mode::angle);
    for (const QPoint& at : {kFrom, kTo, kThird}) slice.click(at);
    REQUIRE(slice.list().size() == 1);
    // By the law of cosines from the three distances.
    const double a = slice.between(kFrom, kTo), b = slice.between(kTo, kThird),
                 c = slice.between(kFrom, kThird);
    const double degrees = std::acos((a * a + b * b - c * c) / (2 * a * b)) * 180 / std::acos(-1.0);
    CHECK(std::abs(valueOf(slice.list()[0]) - degrees) < 1e-7);
  }
}

TEST_CASE("The end of a ruler is dragged within the slice, which is one change to undo", "[measuring]") {
  MeasuredSlice slice(Plane::coronal, obliqueVolume());
  slice.state.measure().setMode(MeasureTool::Mode::ruler);
  slice.click(kFrom);
  slice.click(kTo);
  const Vec3 crosshair = slice.state.crosshair();
  const Measurement before = slice.list().at(0);
  drag(slice.view, Qt::LeftButton, kTo, kThird);
  CHECK(std::abs(valueOf(slice.list()[0]) - slice.between(kFrom, kThird)) < 1e-9);
  CHECK(slice.list()[0].points[0] == before.points[0]);
  CHECK(slice.state.crosshair() == crosshair);
  // Beside the ends the mouse is the crosshair's.
  slice.click(kThird + QPoint(25, 0));
  CHECK(slice.state.crosshair() != crosshair);
  slice.document.measurements().remove(0);
  CHECK(slice.list().empty());
}

TEST_CASE("Return places a point at the crosshair, and Escape takes it back, then ends the tool",
          "[measuring]") {
  MeasuredSlice slice(Plane::axial);
  slice.state.measure().setMode(MeasureTool::Mode::ruler);
  QTest::keyClick(&slice.view, Qt::Key_Return);
  CHECK(slice.document.seeds().empty());
  REQUIRE(slice.state.measure().placed().size() == 1);
  CHECK(slice.state.measure().placed()[0] == slice.state.crosshair());
  QTest::keyClick(&slice.view, Qt::Key_Escape);
  CHECK(slice.state.measure().placed().empty());
  CHECK(slice.state.measure().isOn());
  QTest::keyClick(&slice.view, Qt::Key_Escape);
  CHECK(!slice.state.measure().isOn());
  QTest::keyClick(&slice.view, Qt::Key_Return);
  CHECK(slice.document.seeds().size() == 1);
  CHECK(slice.list().empty());
}

TEST_CASE("A double click places one point, and the view stays as large as it is", "[measuring]") {
  MeasuredSlice slice(Plane::axial);
  slice.state.measure().setMode(MeasureTool::Mode::ruler);
  const QSignalSpy maximised(&slice.view, &SliceView::maximiseRequested);
  slice.click(kFrom);
  QTest::mouseDClick(&slice.view, Qt::LeftButton, {}, kFrom);  // the second press and release alone
  CHECK(maximised.isEmpty());
  CHECK(slice.list().empty());
  CHECK(slice.state.measure().placed().size() == 1);
}

TEST_CASE("A ruler is drawn in the slices that it lies in, with its value, and in no others", "[measuring]") {
  MeasuredSlice slice(Plane::axial);
  const QImage without = slice.view.picture();
  const Vec3 a = slice.world(20, 30, 32), b = slice.world(44, 30, 32);
  slice.document.measurements().add({MeasurementKind::ruler, {a, b}});
  slice.document.measurements().select(-1);
  const int there = countPixels(slice.view.picture(), isMark) - countPixels(without, isMark);
  CHECK(there > 100);
  slice.state.setCrosshair(slice.world(32, 32, 36));
  const QImage elsewhere = slice.view.picture();
  slice.document.measurements().remove(0);
  CHECK(largestDifference(elsewhere, slice.view.picture()) <= 1);
}

TEST_CASE("Clicks on the surface in 3D place points on it; a drag turns the camera", "[measuring]") {
  Work work;
  work.open();
  SurfaceView view(work.document, work.state);
  view.setFlightTime(0);
  show(view, {kWidth, kHeight});
  if (!view.hasOpenGl()) {
    std::cout << "SKIPPED: no OpenGL\n";
    return;
  }
  const Vec3 centre = work.world(32, 32, 32);
  constexpr double kRadius = 14;
  setSnapshot(work.document, icosphere(centre, kRadius, 1.5));
  view.lookFrom(Plane::coronal);
  view.resetCamera();
  view.picture();
  work.state.measure().setMode(MeasureTool::Mode::ruler);
  const QPoint middle(kWidth / 2, kHeight / 2);
  QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
  REQUIRE(work.state.measure().placed().size() == 1);
  // In front, towards anterior.
  CHECK((work.state.measure().placed()[0] - (centre - kRadius * Vec3::UnitY())).norm() < 0.5);
  drag(view, Qt::LeftButton, middle, middle + QPoint(60, 10));
  CHECK(work.state.measure().placed().size() == 1);
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(5, 5));  // beside the surface
  CHECK(work.state.measure().placed().size() == 1);
  view.lookFrom(Plane::sagittal);
  view.picture();
  QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
  const auto& list = work.document.measurements().all();
  REQUIRE(list.size() == 1);
  // From the front to the left: a chord of a quarter of a circle.
  CHECK(std::abs(valueOf(list[0]) - std::sqrt(2.0) * kRadius) < 0.5);
  CHECK(countPixels(view.picture(), isMark) > 60);
  // Its end is under the mouse still: it is dragged along the surface.
  drag(view, Qt::LeftButton, middle, middle + QPoint(30, 0));
  CHECK(std::abs((list[0].points[1] - centre).norm() - kRadius) < 0.5);
  CHECK((list[0].points[1] - (centre + kRadius * Vec3::UnitX())).norm() > 1);
}

TEST_CASE("The end that the mouse holds is let go where undo puts another measurement in its place",
          "[measuring]") {
  MeasuredSlice slice(Plane::axial);
  const auto at = [&](const QPoint& pixel) { return slice.geometry.toWorld(pixel); };
  const Measurement first{MeasurementKind::ruler, {at(kFrom), at(kTo)}};
  const Measurement ruler{MeasurementKind::ruler, {at(kFrom), at(kThird)}};
  const Measurement angle{MeasurementKind::angle, {at(kFrom), at(kTo), at(kThird)}};  // one point more
  for (const Measurement& held : {ruler, angle}) {
    makeOneAfterTheOther(slice.document.measurements(), first, held);
    QTest::mousePress(&slice.view, Qt::LeftButton, {}, kThird);
    slice.document.undoStack()->undo();
    slice.document.undoStack()->undo();
    REQUIRE(slice.list() == std::vector{first});
    moveHeld(slice.view, kThird + QPoint(20, 10));
    QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, kThird + QPoint(20, 10));
    CHECK(slice.list() == std::vector{first});
    slice.document.measurements().remove(0);
  }
}

TEST_CASE("An end that is dragged is let go when another volume is opened", "[measuring]") {
  MeasuredSlice slice(Plane::axial);
  const Measurement ruler{MeasurementKind::ruler,
                          {slice.geometry.toWorld(kFrom), slice.geometry.toWorld(kTo)}};
  slice.document.measurements().add(ruler);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, kTo);
  setVolume(slice.document, slice.volume);  // with a session that has the same ruler
  slice.document.measurements().startWith({ruler});
  moveHeld(slice.view, kThird);
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, kThird);
  CHECK(slice.list() == std::vector{ruler});
}

TEST_CASE("In 3D, too, the end that the mouse holds is let go where undo takes it away", "[measuring]") {
  Work work;
  work.open();
  SurfaceView view(work.document, work.state);
  view.setFlightTime(0);
  show(view, {kWidth, kHeight});
  if (!view.hasOpenGl()) {
    std::cout << "SKIPPED: no OpenGL\n";
    return;
  }
  const Vec3 centre = work.world(32, 32, 32);
  constexpr double kRadius = 14;
  setSnapshot(work.document, icosphere(centre, kRadius, 1.5));
  view.lookFrom(Plane::coronal);
  view.resetCamera();
  view.picture();
  const Vec3 front = centre - kRadius * Vec3::UnitY(), left = centre + kRadius * Vec3::UnitX();
  const Measurement first{MeasurementKind::ruler, {front, left}};
  Measurements& list = work.document.measurements();
  makeOneAfterTheOther(list, first,
                       {MeasurementKind::angle, {left, centre + kRadius * Vec3::UnitZ(), front}});
  const QPoint middle(kWidth / 2, kHeight / 2);  // there the front is seen
  QTest::mousePress(&view, Qt::LeftButton, {}, middle);
  work.document.undoStack()->undo();
  work.document.undoStack()->undo();
  REQUIRE(list.all() == std::vector{first});
  moveHeld(view, middle + QPoint(20, 10));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(20, 10));
  CHECK(list.all() == std::vector{first});
}
