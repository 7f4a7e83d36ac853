// The brush on the surface in a slice: pinning, pulling, smoothing.

#include <cmath>

#include "tests/ui/view/slice_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

bool isPinColour(const QColor& c) { return c.green() > 200 && c.blue() > 200 && c.red() < 190; }

//! A ball whose outline is a circle around kPlace, at rest.
struct SliceWithBall : OneSlice {
  SliceWithBall() {
    setSnapshot(document, icosphere(middle, 12, 1.5), {}, {}, true);
    setGrowthState(document, GrowthState::finished);
    state.brush().setRadius(5);
  }
  //! `mm` to the right of the middle.
  QPoint beside(double mm) const { return kPlace + QPoint(static_cast<int>(mm / geometry.mmPerPixel()), 0); }
  void moveTo(const QPoint& at, Qt::MouseButtons buttons) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, {});
    QCoreApplication::sendEvent(&view, &move);
  }
  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, held, {});
    QCoreApplication::sendEvent(&view, &event);
  }
  const Vec3 middle = geometry.toWorld(kPlace);
};

}  // namespace

TEST_CASE("The brush that pins lights up the outline under it, and the stroke is told at its end",
          "[slice_view][pins]") {
  SliceWithBall slice;
  Brush& brush = slice.state.brush();
  brush.setMode(Brush::Mode::pin);
  CHECK(countPixels(slice.view.picture(), isPinColour) == 0);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, slice.beside(12));
  CHECK(pinned(slice.document).empty());
  CHECK(countPixels(slice.view.picture(), isPinColour) > 30);
  slice.moveTo(slice.beside(16), Qt::LeftButton);
  const std::vector<WallBall> stroke = brush.stroke();
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, slice.beside(16));
  CHECK(pinned(slice.document) == stroke);
  CHECK(brush.stroke().empty());

  Constraints pins;
  pins.pins = {{slice.geometry.toWorld(slice.beside(12)), 5, 0}};
  setConstraints(slice.document, pins);
  const int held = countPixels(slice.view.picture(), isPinColour);
  CHECK(held > 60);  // with its key
  slice.state.setShowsConstraints(false);
  CHECK(countPixels(slice.view.picture(), isPinColour) == 0);
  slice.state.setShowsConstraints(true);
  brush.setMode(Brush::Mode::unpin);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, slice.beside(12));
  CHECK(countPixels(slice.view.picture(), isPinColour) == 0);  // as it would be
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, slice.beside(12));
  CHECK(unpinned(slice.document).size() == 1);
}

TEST_CASE("Another button in the middle of a stroke neither ends it nor moves the slice",
          "[slice_view][pins]") {
  SliceWithBall slice;
  slice.state.brush().setMode(Brush::Mode::pin);
  const Vec3 before = slice.under(kPlace);
  slice.send(QEvent::MouseButtonPress, slice.beside(12), Qt::LeftButton, Qt::LeftButton);
  slice.moveTo(slice.beside(16), Qt::LeftButton);
  for (const Qt::MouseButton other : {Qt::MiddleButton, Qt::RightButton}) {
    slice.send(QEvent::MouseButtonPress, slice.beside(16), other, Qt::LeftButton | other);
    slice.moveTo(slice.beside(20), Qt::LeftButton | other);
    slice.send(QEvent::MouseButtonRelease, slice.beside(20), other, Qt::LeftButton);
    CHECK(pinned(slice.document).empty());
  }
  slice.moveTo(slice.beside(24), Qt::LeftButton);
  const std::vector<WallBall> stroke = slice.state.brush().stroke();
  slice.send(QEvent::MouseButtonRelease, slice.beside(24), Qt::LeftButton, Qt::NoButton);
  REQUIRE(!stroke.empty());
  CHECK(pinned(slice.document) == stroke);
  CHECK((slice.under(kPlace) - before).norm() < 1e-9);
}

TEST_CASE("Two quick dabs of the brush are two, and do not maximise the view", "[slice_view][pins]") {
  SliceWithBall slice;
  int maximised = 0;
  QObject::connect(&slice.view, &SliceView::maximiseRequested, [&] { ++maximised; });
  const auto doubleClick = [&] {
    for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonDblClick}) {
      slice.send(type, slice.beside(12), Qt::LeftButton, Qt::LeftButton);
      slice.send(QEvent::MouseButtonRelease, slice.beside(12), Qt::LeftButton, Qt::NoButton);
    }
  };
  slice.state.brush().setMode(Brush::Mode::smooth);
  doubleClick();
  CHECK(edits(slice.document).size() == 2);
  slice.state.brush().setMode(Brush::Mode::off);
  slice.state.setWindowLevelTool(true);
  doubleClick();
  CHECK(maximised == 0);
  slice.state.setWindowLevelTool(false);
  doubleClick();
  CHECK(maximised == 1);
}

TEST_CASE("A surface that grows, or is locked away, is not touched by the brush", "[slice_view][pins]") {
  SliceWithBall slice;
  setGrowthState(slice.document, GrowthState::running);
  const Vec3 crosshair = slice.state.crosshair();
  for (const Brush::Mode mode :
       {Brush::Mode::pin, Brush::Mode::unpin, Brush::Mode::smooth, Brush::Mode::pull}) {
    slice.state.brush().setMode(mode);
    drag(slice.view, Qt::LeftButton, slice.beside(12), slice.beside(20));
    CHECK(slice.view.cursor().shape() == Qt::ForbiddenCursor);
  }
  CHECK(pinned(slice.document).empty());
  CHECK(unpinned(slice.document).empty());
  CHECK(edits(slice.document).empty());
  CHECK(slice.state.crosshair() == crosshair);
}

TEST_CASE("A point of the outline is pulled to where it is dragged, from near it as from on it",
          "[slice_view][pull]") {
  SliceWithBall slice;
  Brush& brush = slice.state.brush();
  brush.setMode(Brush::Mode::pull);
  drag(slice.view, Qt::LeftButton, kPlace, slice.beside(8));  // no outline is near
  CHECK(edits(slice.document).empty());
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, slice.beside(12));
  CHECK(edits(slice.document).empty());  // it did not move
  const QPoint from = slice.beside(12) + QPoint(5, 0), to = from + QPoint(0, 40);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, from);
  slice.moveTo(to, Qt::LeftButton);
  REQUIRE(brush.pull());
  const Brush::Pull pull = *brush.pull();
  CHECK(std::abs((pull.from - slice.middle).norm() - 12) < 0.3);
  CHECK((pull.to - pull.from - (slice.geometry.toWorld(to) - slice.geometry.toWorld(from))).norm() < 1e-9);
  const auto arrow = [](const QColor& c) { return c.red() > 230 && c.green() > 215 && c.blue() < 215; };
  CHECK(countPixels(slice.view.picture(), arrow) > 60);
  CHECK(edits(slice.document).empty());
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, to);
  REQUIRE(edits(slice.document).size() == 1);
  const MeshEdit& edit = edits(slice.document).front();
  CHECK(edit.kind == MeshEditKind::pull);
  CHECK(edit.place == pull.from);
  CHECK(edit.vector == pull.to);
  CHECK(edit.radius == 5);
  CHECK_FALSE(brush.pull());
  // Escape gives it up.
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, from);
  slice.moveTo(to, Qt::LeftButton);
  QTest::keyClick(&slice.view, Qt::Key_Escape);
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, to);
  CHECK(edits(slice.document).size() == 1);
  CHECK(brush.isOn());
  QTest::keyClick(&slice.view, Qt::Key_Escape);
  CHECK_FALSE(brush.isOn());
}

TEST_CASE("A click with the brush that smooths is one edit there", "[slice_view][pull]") {
  SliceWithBall slice;
  slice.state.brush().setMode(Brush::Mode::smooth);
  drag(slice.view, Qt::LeftButton, slice.beside(12), slice.beside(20));
  REQUIRE(edits(slice.document).size() == 1);
  const MeshEdit& edit = edits(slice.document).front();
  CHECK(edit.kind == MeshEditKind::smooth);
  CHECK((edit.place - slice.geometry.toWorld(slice.beside(12))).norm() < 1e-9);
  CHECK(edit.radius == 5);
}
