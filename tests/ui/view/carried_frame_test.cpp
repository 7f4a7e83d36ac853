// A frame that the surface was carried to: what is drawn there belongs to it, and not to the frame that is
// changed.

#include "tests/ui/view/surface_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

bool isWallColour(const QColor& c) { return c.hue() > 270 && c.hue() < 310 && c.saturation() > 60; }

//! A ball with a click in its middle, a pin and a wall; wherever there is another wall in the carried frame.
struct ChangedFrame {
  explicit ChangedFrame(Work& w) : work(w) {
    setSnapshot(work.document, icosphere(click, 12, 1));
    work.document.addSeed({click, 5.0});
    Constraints edited;
    edited.pins = {{pin, 4, 0}};
    edited.walls.balls = {{wall, 4}};
    setConstraints(work.document, edited);
  }
  void showOther() {
    WallList walls;
    walls.balls = {{otherWall, 4}};
    showCarried(work.document, walls);
  }

  Work& work;
  const Vec3 click = work.world(32, 32, 32), pin = work.world(20, 32, 32), wall = work.world(52, 32, 32),
             otherWall = work.world(32, 46, 32);
};

}  // namespace

TEST_CASE("In a slice of a carried frame there are its walls, and neither clicks nor pins", "[slice_view]") {
  Work work;
  work.open();
  work.state.setCrosshair(work.world(8, 8, 32));  // its lines lie elsewhere
  SliceView view(Plane::axial, work.document, work.state);
  show(view, {kWidth, kHeight});
  const SliceGeometry geometry(work.volume.grid, Plane::axial, {kWidth, kHeight});
  ChangedFrame frame(work);
  const auto around = [&](const Vec3& place, auto&& is) {
    const QPoint at = geometry.worldToScreen(place).toPoint();
    return countPixels(view.picture(), QRect(at - QPoint(26, 26), at + QPoint(26, 26)), is);
  };
  const auto isSeed = [](const QColor& c) { return c.blue() > 200 && c.red() < 130; };
  const auto isPin = [](const QColor& c) { return c.green() > 200 && c.blue() > 200 && c.red() < 190; };
  CHECK(around(frame.click, isSeed) > 20);
  CHECK(around(frame.pin, isPin) > 10);
  CHECK(around(frame.wall, isWallColour) > 100);
  CHECK(around(frame.otherWall, isWallColour) == 0);
  frame.showOther();
  CHECK(around(frame.click, isSeed) == 0);
  CHECK(around(frame.pin, isPin) == 0);
  CHECK(around(frame.wall, isWallColour) == 0);
  CHECK(around(frame.otherWall, isWallColour) > 100);
  // What is not seen is not dragged: the mouse is the crosshair's.
  const QPoint at = geometry.worldToScreen(frame.click).toPoint();
  drag(view, Qt::LeftButton, at, at + QPoint(30, 20));
  CHECK(work.document.seeds().front().centre == frame.click);
}

TEST_CASE("In 3D a carried frame has its own walls, and neither clicks nor pins", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const auto isSeed = [](const QColor& c) { return c.blue() > c.red() + 60 && c.green() > c.red() + 20; };
  const auto isPin = [](const QColor& c) { return c.green() > c.red() + 40 && c.blue() > c.red() + 30; };
  const QRect middle(60, 60, 280, 180);  // without arrows and texts
  SECTION("clicks, where there is no surface") {
    surface.document.addSeed({surface.world(32, 32, 32), 12.0});
    CHECK(countPixels(surface.picture(), middle, isSeed) > 300);
    showCarried(surface.document, {});
    CHECK(countPixels(surface.picture(), middle, isSeed) == 0);
  }
  SECTION("walls and pins") {
    ChangedFrame frame(surface);
    surface.view.lookFrom(Plane::sagittal, true);  // from the right, where the pin lies
    surface.view.resetCamera();
    CHECK(countPixels(surface.picture(), middle, isPin) > 30);
    const int hidden = countPixels(surface.picture(), isWallColour);  // behind the ball
    frame.showOther();
    CHECK(countPixels(surface.picture(), middle, isPin) == 0);
    CHECK(countPixels(surface.picture(), isWallColour) > hidden + 100);
  }
}

TEST_CASE("Of an object that is hidden no clicks are drawn or dragged", "[slice_view][surface_view]") {
  Surface surface;
  const Vec3 click = surface.world(32, 32, 32);
  surface.document.addSeed({click, 12.0});
  const auto isSeed = [](const QColor& c) { return c.blue() > c.red() + 60 && c.green() > c.red() + 20; };
  SECTION("in a slice") {
    surface.state.setCrosshair(surface.world(8, 8, 32));
    SliceView slice(Plane::axial, surface.document, surface.state);
    show(slice, {kWidth, kHeight});
    const QPoint at(kWidth / 2, kHeight / 2);
    const QRect middle(at - QPoint(80, 80), at + QPoint(80, 80));
    CHECK(countPixels(slice.picture(), middle, isSeed) > 100);
    setVisible(surface.document, false);
    CHECK(countPixels(slice.picture(), middle, isSeed) == 0);
    drag(slice, Qt::LeftButton, at, at + QPoint(30, 20));
    CHECK(surface.document.seeds().front().centre == click);
    setVisible(surface.document, true);
    CHECK(countPixels(slice.picture(), middle, isSeed) > 100);
  }
  SECTION("in 3D, where they were behind its surface") {
    if (!surface.ready()) return;
    const QRect middle(100, 70, 200, 160);
    surface.setSphere();
    CHECK(countPixels(surface.picture(), middle, isSeed) == 0);
    setVisible(surface.document, false);
    CHECK(countPixels(surface.picture(), middle, isSeed) == 0);
    CHECK(countPixels(surface.picture(), middle, isWarm) == 0);
  }
}
