// The slice as a person meets it: real events in, pictures out.

#include <QLocale>
#include <QPainter>
#include <QSignalSpy>
#include <cmath>

#include "tests/ui/view/slice_support.h"
#include "ui/view/overlay.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

TEST_CASE("An empty view says how to open a volume and bears events", "[slice_view]") {
  Work work;
  SliceView view(Plane::axial, work.document, work.state);
  show(view, {kWidth, kHeight});
  QTest::mouseClick(&view, Qt::LeftButton, {}, kPlace);
  QTest::keyClick(&view, Qt::Key_Return);
  QTest::keyClick(&view, Qt::Key_Up);
  turnWheel(view, kPlace, 1);
  CHECK(work.document.seeds().empty());
  const auto light = [](const QColor& c) { return c.lightness() > 80; };
  CHECK(countPixels(view.picture(), QRect(50, 100, 300, 100), light) > 100);  // the hint's letters
}

TEST_CASE("With the brush on, left paints in the slice and the end of the stroke is told once",
          "[slice_view][walls]") {
  OneSlice slice;
  Brush& brush = slice.state.brush();
  brush.setRadius(4);
  brush.setMode(Brush::Mode::paintWalls);
  const Vec3 crosshair = slice.state.crosshair();
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, kPlace);
  const QPoint to = kPlace + QPoint(60, 0);
  QMouseEvent move(QEvent::MouseMove, to, slice.view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&slice.view, &move);
  CHECK(painted(slice.document).empty());  // not before the end
  const std::vector<WallBall> stroke = brush.stroke();
  REQUIRE(stroke.size() > 2);
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, to);
  CHECK(painted(slice.document) == stroke);
  CHECK(brush.stroke().empty());
  CHECK(slice.state.crosshair() == crosshair);
  CHECK((stroke.front().centre - slice.geometry.toWorld(kPlace)).norm() < 1e-9);
  for (const WallBall& ball : stroke) {
    CHECK(ball.radius == 4);
    CHECK(std::abs(slice.geometry.distance(ball.centre)) < 1e-9);
  }
  brush.setMode(Brush::Mode::eraseWalls);
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, kPlace);
  CHECK(erased(slice.document).size() == 1);
}

TEST_CASE("Overlapping walls have one shade, and the eraser shows what would be left",
          "[slice_view][walls]") {
  OneSlice slice;
  const Vec3 middle = slice.geometry.toWorld(kPlace);
  const auto violet = [](const QColor& c) { return c.hue() > 270 && c.hue() < 310 && c.saturation() > 60; };
  const QRect all(0, 0, kWidth, kHeight);
  const int none = countPixels(slice.view.picture(), all, violet);
  Constraints walls;
  walls.walls.balls = {{middle, 5}};
  setConstraints(slice.document, walls);
  const QColor one = slice.view.picture().pixelColor(kPlace);
  CHECK(violet(one));
  walls.walls.balls.assign(12, {middle, 5});
  setConstraints(slice.document, walls);
  CHECK(slice.view.picture().pixelColor(kPlace) == one);
  slice.state.brush().setMode(Brush::Mode::eraseWalls);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, kPlace);
  CHECK(countPixels(slice.view.picture(), all, violet) == none);
  slice.state.brush().take();
  CHECK(countPixels(slice.view.picture(), all, violet) > none + 100);
}

TEST_CASE("The tint is the object as the surface sees it, and comes when it is known", "[slice_view]") {
  OneSlice slice;
  slice.state.setCrosshair(slice.world(32, 32, 50));
  const auto isTinted = [](const QColor& c) { return c.red() > c.green() + 40; };
  const auto tintedShare = [&] {
    const QRectF block(slice.geometry.toScreen(Vec3(44, 4, 50)), slice.geometry.toScreen(Vec3(60, 20, 50)));
    const QRect pixels = block.normalized().toRect();
    return static_cast<double>(countPixels(slice.view.picture(), pixels, isTinted)) /
           (pixels.width() * pixels.height());
  };
  CHECK(tintedShare() == 0);
  slice.state.setTint(Tint{nullptr, {90, 110}});
  CHECK(tintedShare() == 0);
  const auto bright = std::make_shared<ObjectImage>(std::make_shared<SmoothedVolume>(slice.volume, 1.0),
                                                    IntensityRange{150, 1e9}, 1.0);
  slice.state.setTint(Tint{bright, {90, 110}});
  CHECK(tintedShare() == 1);
  slice.state.setTint({});
  CHECK(tintedShare() == 0);
}

TEST_CASE("A click moves the crosshair to the place under the mouse", "[slice_view]") {
  for (Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    OneSlice slice(plane);
    const Vec3 wanted = slice.geometry.toWorld(kPlace);
    CHECK((slice.under(kPlace) - wanted).norm() < 1e-9);
    QTest::mouseClick(&slice.view, Qt::LeftButton, {}, kPlace);
    CHECK((slice.state.crosshair() - wanted).norm() < 1e-9);
  }
}

TEST_CASE("The intensity under the mouse is that of the voxel there", "[slice_view]") {
  OneSlice slice;
  slice.state.setCrosshair(slice.world(32, 32, 50));
  (void)slice.under(slice.geometry.toScreen(Vec3(50, 10, 50)));
  CHECK(slice.intensity == 200);
  (void)slice.under(slice.geometry.toScreen(Vec3(50, 40, 50)));
  CHECK(slice.intensity == 100);
}

TEST_CASE("Beside the volume the mouse is over nothing", "[slice_view]") {
  OneSlice slice;
  (void)slice.under(kPlace);
  const QPointF corner(5, 5);
  QMouseEvent move(QEvent::MouseMove, corner, slice.view.mapToGlobal(corner), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&slice.view, &move);
  CHECK_FALSE(slice.hovered.has_value());
}

TEST_CASE("Whatever changes what lies under a mouse that rests tells it anew", "[slice_view]") {
  OneSlice slice;
  slice.state.setCrosshair(slice.world(32, 32, 39));
  const QPointF place = slice.geometry.toScreen(Vec3(50, 10, 39));
  const Vec3 before = slice.under(place);
  CHECK(slice.intensity == 100);
  SECTION("keys") {
    QTest::keyClick(&slice.view, Qt::Key_PageUp);
    CHECK((*slice.hovered - before - Vec3(0, 0, 1)).norm() < 1e-9);
    CHECK(slice.intensity == 200);
  }
  SECTION("the crosshair") {
    slice.state.setCrosshair(slice.world(32, 32, 45));
    CHECK((*slice.hovered - before - Vec3(0, 0, 6)).norm() < 1e-9);
    CHECK(slice.intensity == 200);
  }
  SECTION("another time point, and another volume") {
    const Grid grid = slice.volume.grid;
    setFrame(slice.document, handlebody::testing::volumeByIndex(grid, [](int, int, int) { return 7; }));
    CHECK(slice.intensity == 7);
    const Grid small = handlebody::testing::cubicGrid(8);
    setVolume(slice.document, handlebody::testing::volumeByIndex(small, [](int, int, int) { return 9; }));
    CHECK((!slice.hovered || slice.intensity == 9));
  }
  SECTION("the zoom, which goes back") {
    turnWheel(slice.view, {0, 0}, 3, Qt::ControlModifier);
    (void)slice.under(place);
    slice.view.resetZoom();
    CHECK((*slice.hovered - before).norm() < 1e-9);
  }
  SECTION("but not where the mouse has left") {
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&slice.view, &leave);
    QTest::keyClick(&slice.view, Qt::Key_PageUp);
    CHECK_FALSE(slice.hovered.has_value());
  }
}

TEST_CASE("The scale bar is written as numbers are in the user's language", "[slice_view]") {
  const QLocale before;
  const auto barIn = [](QLocale::Language language, double mmPerPixel) {
    QLocale::setDefault(language);
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paintScaleBar(painter, QSizeF(kWidth, kHeight), mmPerPixel);
    painter.end();
    return image;
  };
  for (double mmPerPixel : {0.0006, 600.0})  // 0.05 mm, 50,000 mm
    CHECK(largestDifference(barIn(QLocale::English, mmPerPixel), barIn(QLocale::German, mmPerPixel)) > 60);
  CHECK(largestDifference(barIn(QLocale::English, 0.06), barIn(QLocale::German, 0.06)) <= 1);  // 5 mm
  QLocale::setDefault(before);
}

TEST_CASE("A crosshair that is dragged out of the volume stays at its border", "[slice_view]") {
  OneSlice slice;
  drag(slice.view, Qt::LeftButton, kPlace, {-500, 5000});
  CHECK(slice.index().x() == Approx(0));
  CHECK(slice.index().y() == Approx(63));
}

TEST_CASE("The wheel goes through the slices, with Shift by five", "[slice_view]") {
  OneSlice slice;
  const double before = slice.index().z();
  turnWheel(slice.view, kPlace, 1);
  CHECK(slice.index().z() == before + 1);  // away from the user: towards superior
  turnWheel(slice.view, kPlace, -2);
  CHECK(slice.index().z() == before - 1);
  turnWheel(slice.view, kPlace, 1, Qt::ShiftModifier);
  CHECK(slice.index().z() == before + 4);
  CHECK((slice.index().head<2>() - Eigen::Vector2d(32, 32)).norm() < 1e-9);
}

TEST_CASE("Small turns of a fine wheel add up to a slice", "[slice_view]") {
  OneSlice slice;
  const double before = slice.index().z();
  for (int i = 0; i < 4; ++i) {
    QWheelEvent event(kPlace, slice.view.mapToGlobal(QPointF(kPlace)), {}, {0, 30}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&slice.view, &event);
  }
  CHECK(slice.index().z() == before + 1);
}

TEST_CASE("Ctrl and the wheel zoom at the mouse", "[slice_view]") {
  OneSlice slice;
  const Vec3 fixed = slice.under(kPlace), other = slice.under(kPlace + QPoint(50, 0));
  turnWheel(slice.view, kPlace, 2, Qt::ControlModifier);
  CHECK((slice.under(kPlace) - fixed).norm() < 1e-9);
  CHECK((slice.under(kPlace + QPoint(50, 0)) - fixed).norm() < 0.9 * (other - fixed).norm());
  turnWheel(slice.view, kPlace, -2, Qt::ControlModifier);
  CHECK((slice.under(kPlace + QPoint(50, 0)) - other).norm() < 1e-9);
}

TEST_CASE("The right button zooms, upwards closer", "[slice_view]") {
  OneSlice slice;
  const Vec3 crosshair = slice.state.crosshair();
  const auto width = [&] { return (slice.under(kPlace + QPoint(40, 0)) - slice.under(kPlace)).norm(); };
  const double before = width();
  drag(slice.view, Qt::RightButton, kPlace, kPlace - QPoint(0, 60));
  CHECK(width() < 0.8 * before);
  drag(slice.view, Qt::RightButton, kPlace, kPlace + QPoint(0, 60));
  CHECK(width() == Approx(before));
  CHECK(slice.state.crosshair() == crosshair);
}

TEST_CASE("The middle button, or Shift and the left one, pan", "[slice_view]") {
  for (const auto& [button, modifiers] :
       {std::pair(Qt::MiddleButton, Qt::NoModifier), {Qt::LeftButton, Qt::ShiftModifier}}) {
    OneSlice slice;
    const Vec3 crosshair = slice.state.crosshair(), before = slice.under(kPlace);
    drag(slice.view, button, kPlace, kPlace + QPoint(30, -20), modifiers);
    CHECK((slice.under(kPlace + QPoint(30, -20)) - before).norm() < 1e-9);
    CHECK(slice.state.crosshair() == crosshair);
    slice.view.resetZoom();
    CHECK((slice.under(kPlace) - before).norm() < 1e-9);
  }
}

TEST_CASE("Arrows move the crosshair by a voxel in their direction, with Shift by five", "[slice_view]") {
  // On the screen, right is left of the patient, down is posterior; PgUp is superior.
  OneSlice slice;
  const Vec3 start = slice.state.crosshair();
  const auto moved = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    slice.state.setCrosshair(start);
    QTest::keyClick(&slice.view, key, modifiers);
    return Vec3(slice.state.crosshair() - start);
  };
  CHECK((moved(Qt::Key_Right) - Vec3(1, 0, 0)).norm() < 1e-9);
  CHECK((moved(Qt::Key_Left) - Vec3(-1, 0, 0)).norm() < 1e-9);
  CHECK((moved(Qt::Key_Down) - Vec3(0, 1, 0)).norm() < 1e-9);
  CHECK((moved(Qt::Key_Up, Qt::ShiftModifier) - Vec3(0, -5, 0)).norm() < 1e-9);
  CHECK((moved(Qt::Key_PageUp) - Vec3(0, 0, 1)).norm() < 1e-9);
  CHECK((moved(Qt::Key_PageDown, Qt::ShiftModifier) - Vec3(0, 0, -5)).norm() < 1e-9);
}

TEST_CASE("Return adds a seed at the crosshair, Backspace removes it", "[slice_view]") {
  OneSlice slice;
  QTest::keyClick(&slice.view, Qt::Key_Return);
  REQUIRE(slice.document.seeds().size() == 1);
  CHECK(slice.document.seeds()[0].centre == slice.state.crosshair());
  CHECK(slice.document.selectedSeed() == 0);
  QTest::keyClick(&slice.view, Qt::Key_Backspace);
  CHECK(slice.document.seeds().empty());
  QTest::keyClick(&slice.view, Qt::Key_Delete);  // nothing is selected
  CHECK(slice.document.seeds().empty());
}

TEST_CASE("A seed that is deleted while the mouse holds it is let go, and no other is dragged in its place",
          "[slice_view]") {
  OneSlice slice;
  const Vec3 held = slice.state.crosshair(), other = held + Vec3(20, 0, 0);
  const QPoint centre = slice.geometry.worldToScreen(held).toPoint();
  for (const bool isAlone : {true, false}) {
    slice.document.addSeed({held, 6.0});
    if (!isAlone) slice.document.addSeed({other, 6.0});
    for (const QPoint& grip : {centre, centre + QPoint(qRound(6 / slice.geometry.mmPerPixel()), 0)}) {
      QTest::mousePress(&slice.view, Qt::LeftButton, {}, grip);
      slice.document.removeSeed(0);
      slice.under(grip + QPoint(30, 20));
      slice.under(grip + QPoint(40, 20));
      QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, grip + QPoint(40, 20));
      if (!isAlone) CHECK(slice.document.seeds().front() == Seed{other, 6.0});
      while (!slice.document.seeds().empty()) slice.document.removeSeed(0);
      slice.document.addSeed({held, 6.0});
      if (!isAlone) slice.document.addSeed({other, 6.0});
    }
    while (!slice.document.seeds().empty()) slice.document.removeSeed(0);
  }
}

TEST_CASE("Shift and Return add a click outside, which is dragged, sized and deleted like a seed",
          "[slice_view]") {
  OneSlice slice;
  QTest::keyClick(&slice.view, Qt::Key_Return, Qt::ShiftModifier);
  REQUIRE(slice.document.seeds().size() == 1);
  CHECK(slice.document.seeds()[0] == Seed{slice.state.crosshair(), std::nullopt, true});
  CHECK(slice.document.selectedSeed() == 0);
  const double before = slice.document.shownRadius(0);
  QTest::keyClick(&slice.view, Qt::Key_Plus);
  CHECK(slice.document.shownRadius(0) == Approx(before + 0.5));
  const QPoint centre = slice.geometry.worldToScreen(slice.state.crosshair()).toPoint();
  drag(slice.view, Qt::LeftButton, centre, centre + QPoint(60, 30));
  CHECK((slice.document.seeds()[0].centre - slice.state.crosshair()).norm() > 10);
  CHECK(slice.document.seeds()[0].background);
  QTest::keyClick(&slice.view, Qt::Key_Backspace);
  CHECK(slice.document.seeds().empty());
}

TEST_CASE("A click outside is crossed out from rim to rim, and no seed is", "[slice_view]") {
  OneSlice slice;
  slice.document.addSeed({slice.world(20, 32, 32), 9.0, true});
  slice.document.addSeed({slice.world(44, 32, 32), 9.0});
  const auto isOutside = [](const QColor& c) { return c.red() > 200 && c.blue() < 90 && c.green() < 160; };
  const auto isSeed = [](const QColor& c) { return c.blue() > 200 && c.red() < 130; };
  const double radius = 9 / slice.geometry.mmPerPixel();
  for (int selected : {-1, 0}) {
    slice.document.selectSeed(selected);
    const QImage image = slice.view.picture();
    //! Around the places on both diagonals, half way to the rim.
    const auto crossed = [&](double voxel, auto&& is) {
      int count = 0;
      const QPointF centre = slice.geometry.toScreen(Vec3(voxel, 32, 32));
      for (const QPointF& way : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)}) {
        const QPoint at = (centre + way * radius / 2 * std::sqrt(0.5)).toPoint();
        count += countPixels(image, QRect(at - QPoint(2, 2), at + QPoint(2, 2)), is) > 1;
      }
      return count;
    };
    CHECK(crossed(20, isOutside) == 4);
    CHECK(crossed(20, isSeed) == 0);
    CHECK(crossed(44, isOutside) == 0);
    CHECK(crossed(44, isSeed) == 0);
  }
}

TEST_CASE("Plus and minus change the radius of the selected seed, not below a voxel", "[slice_view]") {
  OneSlice slice;
  QTest::keyClick(&slice.view, Qt::Key_Return);
  const double before = slice.document.shownRadius(0);
  QTest::keyClick(&slice.view, Qt::Key_Plus);
  CHECK(slice.document.shownRadius(0) == Approx(before + 0.5));
  for (int i = 0; i < 50; ++i) QTest::keyClick(&slice.view, Qt::Key_Minus);
  CHECK(slice.document.shownRadius(0) == 1);
}

TEST_CASE("A seed's centre is dragged within the slice, as one change", "[slice_view]") {
  OneSlice slice;
  slice.document.addSeed({slice.world(32, 32, 33), 8.0});
  const QPoint centre = slice.geometry.toScreen(Vec3(32, 32, 33)).toPoint();
  const Vec3 crosshair = slice.state.crosshair();
  const Vec3 wanted = slice.world(32, 32, 33) + slice.geometry.toWorld(centre + QPoint(60, 30)) -
                      slice.geometry.toWorld(centre);
  drag(slice.view, Qt::LeftButton, centre, centre + QPoint(60, 30));
  CHECK((slice.document.seeds()[0].centre - wanted).norm() < 1e-9);
  CHECK(slice.document.selectedSeed() == 0);
  CHECK(slice.state.crosshair() == crosshair);
  const std::vector<int> first = gestures(slice.document);
  REQUIRE_FALSE(first.empty());
  for (int gesture : first) CHECK(gesture == first[0]);
  drag(slice.view, Qt::LeftButton, centre + QPoint(60, 30), centre);
  CHECK(gestures(slice.document).back() != first[0]);
}

TEST_CASE("A click on a seed that drags nothing moves the crosshair there", "[slice_view]") {
  OneSlice slice;
  slice.document.addSeed({slice.world(20, 20, 32), 8.0});
  slice.document.addSeed({slice.world(44, 44, 32), 8.0});
  const Vec3 seed = slice.document.seeds()[0].centre;
  REQUIRE((slice.state.crosshair() - seed).norm() > 5);
  const QPoint centre = slice.geometry.toScreen(Vec3(20, 20, 32)).toPoint();
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, centre);
  CHECK(slice.document.selectedSeed() == 0);
  CHECK(slice.document.seeds()[0].centre == seed);
  CHECK((slice.state.crosshair() - seed).norm() < slice.geometry.mmPerPixel());
}

TEST_CASE("A seed's rim sets its radius to where the mouse is", "[slice_view]") {
  OneSlice slice;
  slice.document.addSeed(
      {slice.world(32, 32, 35), 8.0});  // three slices off: the rim is that of a smaller circle
  const QPointF centre = slice.geometry.toScreen(Vec3(32, 32, 32));
  const double shown = std::sqrt(64.0 - 9) / slice.geometry.mmPerPixel();
  const QPoint rim = (centre + QPointF(shown, 0)).toPoint(), to = rim + QPoint(25, 0);
  drag(slice.view, Qt::LeftButton, rim, to);
  CHECK(slice.document.shownRadius(0) ==
        Approx((slice.geometry.toWorld(to) - slice.world(32, 32, 35)).norm()));
  CHECK((slice.document.seeds()[0].centre - slice.world(32, 32, 35)).norm() < 1e-12);
}

TEST_CASE("The cursor tells what a drag would do", "[slice_view]") {
  OneSlice slice;
  slice.document.addSeed({slice.world(32, 32, 32), 10.0});
  const QPointF centre = slice.geometry.toScreen(Vec3(32, 32, 32));
  const double radius = 10 / slice.geometry.mmPerPixel();
  const auto shape = [&](const QPointF& at) {
    (void)slice.under(at);
    return slice.view.cursor().shape();
  };
  CHECK(shape(centre) == Qt::SizeAllCursor);
  CHECK(shape(centre + QPointF(radius, 0)) == Qt::SizeHorCursor);
  CHECK(shape(centre + QPointF(0, -radius)) == Qt::SizeVerCursor);
  CHECK(shape(centre + QPointF(radius, -radius) * std::sqrt(0.5)) == Qt::SizeBDiagCursor);
  CHECK(shape(centre + QPointF(radius, radius) * std::sqrt(0.5)) == Qt::SizeFDiagCursor);
  CHECK(shape(centre + QPointF(2 * radius, 0)) == Qt::CrossCursor);
  slice.state.setWindowLevelTool(true);
  CHECK(shape(centre) == Qt::BitmapCursor);
}

TEST_CASE("With the W tool a drag changes window and level and leaves the crosshair", "[slice_view]") {
  OneSlice slice;
  const Vec3 crosshair = slice.state.crosshair();
  slice.state.setWindowLevel(100, 50);
  QTest::keyClick(&slice.view, Qt::Key_W);
  CHECK(slice.state.windowLevelTool());
  drag(slice.view, Qt::LeftButton, kPlace, kPlace + QPoint(50, -25));
  CHECK(slice.state.window() == Approx(100 * std::exp(0.2)));
  CHECK(slice.state.level() == Approx(40));
  CHECK(slice.state.crosshair() == crosshair);
  QTest::keyClick(&slice.view, Qt::Key_W);
  CHECK_FALSE(slice.state.windowLevelTool());
}

TEST_CASE("A W that is held down during a drag is over when it is let go", "[slice_view]") {
  OneSlice slice;
  QTest::keyPress(&slice.view, Qt::Key_W);
  drag(slice.view, Qt::LeftButton, kPlace, kPlace + QPoint(50, 0));
  QTest::keyRelease(&slice.view, Qt::Key_W);
  CHECK_FALSE(slice.state.windowLevelTool());
}

TEST_CASE("A double click asks for the whole window", "[slice_view]") {
  OneSlice slice;
  QSignalSpy spy(&slice.view, &SliceView::maximiseRequested);
  QTest::mouseDClick(&slice.view, Qt::LeftButton, {}, kPlace);
  CHECK(spy.count() == 1);
}

TEST_CASE("A click in one slice moves the others to that place", "[slice_view]") {
  OneSlice axial;
  SliceView coronal(Plane::coronal, axial.document, axial.state);
  show(coronal, {kWidth, kHeight});
  QSignalSpy spy(&coronal, &SliceView::hovered);
  QTest::mouseClick(&axial.view, Qt::LeftButton, {}, axial.geometry.toScreen(Vec3(20, 51, 32)).toPoint());
  QMouseEvent move(QEvent::MouseMove, QPointF(kPlace), coronal.mapToGlobal(QPointF(kPlace)), Qt::NoButton,
                   Qt::NoButton, {});
  QCoreApplication::sendEvent(&coronal, &move);
  REQUIRE(spy.count() == 1);
  CHECK(spy[0][1].value<Vec3>().y() == 51);
}

TEST_CASE("The mesh's outline lies on the circle in which the slice cuts a sphere", "[slice_view]") {
  OneSlice slice;
  constexpr double kRadius = 20, kOff = 6;
  setSnapshot(slice.document, icosphere(slice.world(30, 34, 32 + kOff), kRadius, 0.7));
  const QImage image = slice.view.picture();
  const auto isOutline = [](const QColor& c) { return c.red() > 200 && c.blue() < 90 && c.green() > 130; };
  const QPointF centre = slice.geometry.toScreen(Vec3(30, 34, 32));
  const double radius = std::sqrt(kRadius * kRadius - kOff * kOff) / slice.geometry.mmPerPixel();
  int onCircle = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (!isOutline(QColor(image.pixel(x, y)))) continue;
      const double off = std::hypot(x + 0.5 - centre.x(), y + 0.5 - centre.y()) - radius;
      // Half the line's width, half a pixel's diagonal and the chord of an edge.
      CHECK(std::abs(off) < 0.8 + 0.71 + 0.1);
      ++onCircle;
    }
  CHECK(onCircle > 0.7 * 2 * M_PI * radius);
}

TEST_CASE("The outline of a surface that is out of date is pale", "[slice_view]") {
  OneSlice slice;
  setSnapshot(slice.document, icosphere(slice.world(30, 34, 32), 20, 0.7));
  const auto isOutline = [](const QColor& c) { return c.red() > 200 && c.blue() < 90 && c.green() > 130; };
  const QImage current = slice.view.picture();
  CHECK(countPixels(current, isOutline) > 100);
  setOutOfDate(slice.document, true);
  const QImage old = slice.view.picture();
  CHECK(countPixels(old, isOutline) == 0);
  setOutOfDate(slice.document, false);
  CHECK(largestDifference(slice.view.picture(), current) <= 1);
}

TEST_CASE("Where the image shows no edge the outline says so, in the colouring by support alone",
          "[slice_view]") {
  OneSlice slice;
  const Vec3 centre = slice.world(32, 32, 32);
  const TriangleSoup mesh = icosphere(centre, 20, 0.7);
  setSnapshot(slice.document, mesh, {}, withoutEdgeTowards(mesh, Vec3::UnitX(), centre));
  const int middle = static_cast<int>(slice.geometry.worldToScreen(centre).x());
  // Below the texts. Without what lies about the crosshair, where either half may be.
  const QRect left(0, 90, middle - 12, kHeight - 110),
      right(middle + 12, 90, kWidth - middle - 12, kHeight - 110);
  const auto isOutline = [](const QColor& c) { return c.red() > 200 && c.blue() < 90 && c.green() > 130; };
  const QRect legend(8, 8, 12, 80);
  const QImage plain = slice.view.picture();
  CHECK(countPixels(plain, isUnsupported) == 0);
  CHECK(countPixels(plain, right, isOutline) > 50);
  slice.state.setMeshColouring(MeshColouring::support);
  const QImage marked = slice.view.picture();
  CHECK(countPixels(marked, right, isUnsupported) > 50);
  CHECK(countPixels(marked, right, isOutline) == 0);
  CHECK(countPixels(marked, left, isUnsupported) == 0);
  CHECK(countPixels(marked, left, isOutline) > 50);
  CHECK(countPixels(marked, legend, isUnsupported) > 30);

  slice.state.setCrosshair(slice.world(32, 32, 60));  // beside the mesh nothing is to be explained
  CHECK(countPixels(slice.view.picture(), isUnsupported) == 0);
}

TEST_CASE("The bright block is where its letters say", "[slice_view]") {
  // It lies towards left, anterior and superior.
  for (Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    OneSlice slice(plane);
    slice.state.setCrosshair(slice.world(52, 12, 52));
    const QImage image = slice.view.picture();
    const bool right =
        plane != Plane::sagittal;  // left is on the right; in the sagittal slice anterior on the left
    const QRect corner(right ? 245 : 110, 60, 40, 30), opposite(right ? 110 : 245, 210, 40, 30);
    const auto light = [](const QColor& c) { return c.lightness() > 200; };
    CHECK(countPixels(image, corner, light) > 900);
    CHECK(countPixels(image, opposite, light) < 300);
  }
}

TEST_CASE("The focus of the keyboard can be seen, and is not in pictures", "[slice_view]") {
  OneSlice slice;
  slice.view.clearFocus();
  const QImage before = slice.view.grab().toImage();
  slice.view.setFocus();
  REQUIRE(slice.view.hasFocus());
  const QImage after = slice.view.grab().toImage();
  CHECK(before != after);
  CHECK(slice.view.picture().pixel(0, kHeight / 3) == before.pixel(0, kHeight / 3));
}

TEST_CASE("Every view has a name for those who cannot see it", "[slice_view]") {
  Work work;
  CHECK(SliceView(Plane::axial, work.document, work.state).accessibleName() == "Axial slice");
  CHECK(SliceView(Plane::sagittal, work.document, work.state).accessibleName() == "Sagittal slice");
  CHECK(SurfaceView(work.document, work.state).accessibleName() == "3D view");
}

TEST_CASE("Another volume of another size is shown whole", "[slice_view]") {
  OneSlice slice;
  turnWheel(slice.view, kPlace, 5, Qt::ControlModifier);
  Grid grid;
  grid.size = {20, 30, 5};
  grid.spacing = Vec3(1, 1, 9);
  const Volume other = handlebody::testing::volumeByIndex(grid, [](int i, int, int) { return i; });
  setVolume(slice.document, other);
  slice.state.startWith(other);
  const Vec3 there = SliceGeometry(grid, Plane::axial, {kWidth, kHeight}).toWorld(kPlace);
  CHECK((slice.under(kPlace).head<2>() - there.head<2>()).norm() < 1e-9);
}
