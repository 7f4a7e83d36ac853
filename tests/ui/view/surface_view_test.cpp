// The 3D view through its pictures. Needs OpenGL but for the tests with the tag [no_opengl].

#include <QSignalSpy>
#include <iostream>

#include "tests/ui/view/surface_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

EventTrace exampleTrace(const Vec3& at) {
  EventTrace trace;
  const auto face = [&](double x, double z) {
    return std::array<Vec3, 3>{at + Vec3(x, 0, z), at + Vec3(x + 4, 0, z), at + Vec3(x, 0, z + 4)};
  };
  trace.collidingFaces = {face(0, 0)};
  trace.openedFaces = {face(6, 0), face(-6, 0)};
  trace.refinedFaces = {face(6, 0), face(-6, 0), face(0, -6)};
  trace.handleFaces = {face(0, 6)};
  trace.closedFaces = {face(6, 0), face(-6, 0), face(0, 6)};
  trace.boundaryLoops = {{at, at + Vec3(2, 0, 0), at + Vec3(0, 0, 2)}};
  trace.lambda = {{at}};
  return trace;
}

}  // namespace

TEST_CASE("The mesh is drawn, lit from the side of the camera", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  CHECK(countPixels(surface.picture(), isWarm) < 100);  // parts of the arrows
  surface.setSphere();
  const QImage image = surface.picture();
  CHECK(countPixels(image, isWarm) > 3000);
  const auto bright = [](const QColor& c) { return isWarm(c) && c.red() > 120; };
  CHECK(countPixels(image, bright) > 0.6 * countPixels(image, isWarm));
}

TEST_CASE("A surface that is out of date is pale, in any colouring", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  const QRect middle(170, 120, 60, 60);
  REQUIRE(countPixels(surface.picture(), middle, isWarm) > 2000);
  setOutOfDate(surface.document, true);
  CHECK(countPixels(surface.picture(), middle, isWarm) == 0);
  surface.state.setMeshColouring(MeshColouring::state);
  CHECK(countPixels(surface.picture(), middle, isWarm) == 0);
  setOutOfDate(surface.document, false);
  CHECK(countPixels(surface.picture(), middle, isWarm) > 2000);
}

TEST_CASE("Seen from the front the patient's left is on the right and superior is up", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.state.setMeshColouring(MeshColouring::state);
  TriangleSoup both = icosphere(surface.world(15, 32, 32), 8, 2);
  const TriangleSoup left =
      icosphere(surface.world(50, 20, 45), 8, 2);  // left, anterior, superior of the other
  const int points = static_cast<int>(both.points.size());
  std::vector<FaceState> states(both.triangles.size(), FaceState::colliding);
  both.points.insert(both.points.end(), left.points.begin(), left.points.end());
  for (const Triangle& t : left.triangles)
    both.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
  states.resize(both.triangles.size(), FaceState::newHandle);
  setSnapshot(surface.document, both, states);
  surface.view.resetCamera();
  QTest::keyClick(&surface.view, Qt::Key_End);
  CHECK(surface.middle(isGreen).x() > surface.middle(isRed).x() + 30);
  CHECK(surface.middle(isGreen).y() < surface.middle(isRed).y() - 20);
  QTest::keyClick(&surface.view, Qt::Key_Home);  // from above with the face up: left is on the left
  CHECK(surface.middle(isGreen).x() < surface.middle(isRed).x() - 30);
  CHECK(surface.middle(isGreen).y() < surface.middle(isRed).y() - 10);
  QTest::keyClick(&surface.view, Qt::Key_PageDown);  // from the left: anterior is on the left
  CHECK(surface.middle(isGreen).x() < surface.middle(isRed).x() - 10);
  QTest::keyClick(&surface.view, Qt::Key_PageDown, Qt::ShiftModifier);
  CHECK(surface.middle(isGreen).x() > surface.middle(isRed).x() + 10);
}

TEST_CASE("Only the colouring by state shows states, with its legend", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const TriangleSoup sphere = icosphere(surface.world(32, 32, 32), 15, 2);
  setSnapshot(surface.document, sphere,
              std::vector<FaceState>(sphere.triangles.size(), FaceState::colliding));
  const QRect middle(150, 100, 100, 100);
  CHECK(countPixels(surface.picture(), middle, isRed) == 0);
  surface.state.setMeshColouring(MeshColouring::state);
  CHECK(countPixels(surface.picture(), middle, isRed) > 1000);
}

TEST_CASE("Only the colouring by support shows where the image has no edge", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const Vec3 centre = surface.world(32, 32, 32);
  const TriangleSoup sphere = icosphere(centre, 15, 2);
  setSnapshot(surface.document, sphere, {}, withoutEdgeTowards(sphere, Vec3::UnitX(), centre));
  QTest::keyClick(&surface.view, Qt::Key_End);  // from the front: +x, the patient's left, is on the right
  const QRect left(165, 125, 30, 50), right(205, 125, 30, 50);
  for (const QRect& half : {left, right}) CHECK(countPixels(surface.picture(), half, isUnsupported) == 0);
  surface.state.setMeshColouring(MeshColouring::support);
  const QImage marked = surface.picture();
  CHECK(countPixels(marked, right, isUnsupported) > 1400);
  CHECK(countPixels(marked, right, isWarm) == 0);
  CHECK(countPixels(marked, left, isUnsupported) == 0);
  CHECK(countPixels(marked, left, isWarm) > 1400);
}

TEST_CASE("The legend of the support tells the part without an edge, in a narrow view as well",
          "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const TriangleSoup sphere = icosphere(surface.world(32, 32, 32), 1, 2);
  const auto legend = [&](double part, FaceSupport face) {
    SurfaceSupport support;
    support.faces.assign(sphere.triangles.size(), face);
    support.withoutEdge = part;
    setSnapshot(surface.document, sphere, {}, support);
    return surface.picture().copy(0, 20, surface.view.width(), 80);
  };
  surface.state.setMeshColouring(MeshColouring::support);
  for (int width : {kWidth, 160}) {
    surface.view.resize(width, kHeight);
    QCoreApplication::processEvents();
    const QImage some = legend(0.12, FaceSupport::edge);
    CHECK(countPixels(some, QRect(8, 0, 12, 80), isUnsupported) > 30);
    CHECK(largestDifference(some, legend(0.1249, FaceSupport::edge)) <= 1);  // the same in percent
    CHECK(largestDifference(some, legend(0.87, FaceSupport::edge)) > 50);
    CHECK(largestDifference(legend(0, FaceSupport::edge), legend(0.001, FaceSupport::edge)) > 50);
    CHECK(largestDifference(legend(1, FaceSupport::edge), legend(0.999, FaceSupport::edge)) > 50);
    const auto light = [](const QColor& c) { return c.lightness() > 150; };
    CHECK(countPixels(some, QRect(width - 6, 0, 6, 80), light) == 0);  // no text is cut off
  }
}

TEST_CASE("Of a surface that was not compared with the image the legend says that, and no edge is claimed",
          "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  surface.state.setMeshColouring(MeshColouring::support);
  const QRect middle(150, 100, 100, 100), keys(8, 32, 12, 70);
  const QImage compared = surface.picture();
  CHECK(countPixels(compared, middle, isWarm) > 1000);
  CHECK(countPixels(compared, keys, isUnsupported) > 30);
  forgetSupport(surface.document);
  const QImage unknown = surface.picture();
  CHECK(countPixels(unknown, middle, isWarm) == 0);
  CHECK(countPixels(unknown, keys, isWarm) == 0);
  CHECK(countPixels(unknown, keys, isUnsupported) == 0);
  const auto light = [](const QColor& c) { return c.lightness() > 150; };
  CHECK(countPixels(unknown, QRect(24, 32, 180, 70), light) > 50);
}

TEST_CASE("Edges are drawn on request", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  setSnapshot(surface.document, icosphere(surface.world(32, 32, 32), 15, 8));
  const auto dark = [](const QColor& c) { return isWarm(c) && c.red() < 125; };
  const QRect middle(170, 120, 60, 60);
  const int before = countPixels(surface.picture(), middle, dark);
  surface.state.setMeshColouring(MeshColouring::edges);
  CHECK(countPixels(surface.picture(), middle, dark) > before + 100);
}

TEST_CASE("Slices in 3D lie where they are in the patient", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.state.setSlicesIn3d(true);
  surface.state.setCrosshair(surface.world(52, 12, 52));
  surface.view.resetCamera();
  QTest::keyClick(&surface.view, Qt::Key_End);
  const auto light = [](const QColor& c) { return c.lightness() > 110; };
  const QImage image = surface.picture();
  // The bright block: the upper right quarter seen from the front.
  const int upperRight = countPixels(image, QRect(220, 40, 90, 80), light);
  CHECK(upperRight > 2000);
  CHECK(countPixels(image, QRect(90, 40, 90, 80), light) < upperRight / 10);
  CHECK(countPixels(image, QRect(90, 170, 90, 60), light) < upperRight / 10);
  surface.state.setSlicesIn3d(false);
  CHECK(countPixels(surface.picture(), QRect(220, 40, 90, 80), light) < upperRight / 10);
}

TEST_CASE("The left button turns, the right one and the wheel zoom, the middle one pans", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere(8);
  const QPoint at(200, 150);
  const auto area = [&] { return countPixels(surface.picture(), QRect(0, 60, kWidth, 180), isWarm); };
  const QPointF before = surface.middle(isWarm);
  const int size = area();
  drag(surface.view, Qt::MiddleButton, at, at + QPoint(40, 20));
  CHECK(std::abs(surface.middle(isWarm).x() - before.x() - 40) < 3);
  CHECK(std::abs(surface.middle(isWarm).y() - before.y() - 20) < 3);
  drag(surface.view, Qt::LeftButton, at + QPoint(40, 20), at, Qt::ShiftModifier);
  CHECK(std::abs(surface.middle(isWarm).x() - before.x()) < 3);
  drag(surface.view, Qt::RightButton, at, at - QPoint(0, 30));
  CHECK(area() > 1.1 * size);
  const int larger = area();
  turnWheel(surface.view, at, -3);
  CHECK(area() < 0.8 * larger);
  QTest::keyClick(&surface.view, Qt::Key_End);
  const QImage front = surface.picture();
  drag(surface.view, Qt::LeftButton, at, at + QPoint(60, 0));
  CHECK(surface.picture() != front);
}

TEST_CASE("Without a growth the seeds are shown, with one they are not", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const auto isSeed = [](const QColor& c) { return c.blue() > c.red() + 60 && c.green() > c.red() + 20; };
  const QRect middle(100, 70, 200, 160);
  surface.document.addSeed({surface.world(32, 32, 32), 12.0});
  CHECK(countPixels(surface.picture(), middle, isSeed) > 300);
  surface.setSphere();
  CHECK(countPixels(surface.picture(), middle, isSeed) == 0);
}

TEST_CASE("A click outside is a cross in 3D and no ball", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const auto isSeed = [](const QColor& c) { return c.blue() > c.red() + 60 && c.green() > c.red() + 20; };
  const auto isOutside = [](const QColor& c) { return c.red() > c.blue() + 100 && c.red() > c.green() + 80; };
  const QRect middle(100, 70, 200, 160);
  surface.document.addSeed({surface.world(32, 32, 32), 12.0, true});
  CHECK(countPixels(surface.picture(), middle, isSeed) == 0);
  const int cross = countPixels(surface.picture(), middle, isOutside);
  CHECK(cross > 30);
  surface.document.addSeed({surface.world(32, 32, 32), 12.0});
  CHECK(countPixels(surface.picture(), middle, isSeed) > cross);  // a ball covers more than lines
  surface.setSphere();
  CHECK(countPixels(surface.picture(), middle, isOutside) == 0);
}

TEST_CASE("Each stage of an event shows its own parts, and the mesh comes back as it was", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  const QImage before = surface.picture();
  const EventTrace trace = exampleTrace(surface.world(40, 20, 40));
  const QRect middle(60, 90, 280, 150);
  const auto count = [&](EventStage stage, auto&& is) {
    surface.view.showStage(trace, stage);
    return countPixels(surface.picture(), middle, is);
  };
  CHECK(count(EventStage::colliding, isRed) > 300);
  CHECK(count(EventStage::colliding, isGreen) == 0);
  CHECK(count(EventStage::opened, isRed) == 0);
  CHECK(count(EventStage::opened, isGreen) == 0);
  CHECK(count(EventStage::handle, isGreen) > 300);
  const auto neutral = [](const QColor& c) { return c.lightness() > 90 && c.saturation() < 60; };
  CHECK(count(EventStage::refined, isRed) == 0);
  CHECK(count(EventStage::refined, isGreen) == 0);
  // Its loops and the vertices to be taken out lie over its one more face.
  const auto picture = [&](EventStage stage) {
    surface.view.showStage(trace, stage);
    return surface.picture();
  };
  EventTrace unrefined = trace;
  unrefined.refinedFaces = trace.openedFaces;
  const QImage refined = picture(EventStage::refined);
  surface.view.showStage(unrefined, EventStage::refined);
  CHECK(largestDifference(refined, surface.picture()) > 50);  // its one more face
  CHECK(count(EventStage::closed, neutral) > count(EventStage::opened, neutral) + 100);
  surface.view.clearStage();
  CHECK(largestDifference(surface.picture(), before) <= 1);
}

TEST_CASE("The camera flies to an event once, not at each of its stages", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  const EventTrace trace = exampleTrace(surface.world(40, 20, 40));
  surface.view.showStage(trace, EventStage::opened);
  turnWheel(surface.view, {200, 150}, 2);
  const QImage zoomed = surface.picture();
  surface.view.showStage(trace, EventStage::colliding);
  surface.view.showStage(trace, EventStage::opened);
  CHECK(surface.picture() == zoomed);
}

TEST_CASE("A flight takes its time and then arrives", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  surface.view.lookFrom(Plane::sagittal);
  const QImage start = surface.picture();
  surface.view.lookFrom(Plane::axial);
  const QImage end = surface.picture();
  surface.view.lookFrom(Plane::sagittal);
  surface.view.setFlightTime(300);
  surface.view.lookFrom(Plane::axial);
  CHECK(surface.picture() == start);
  // On the way the camera's numbers are rounded: single pixels at edges may differ.
  CHECK(differingPixels(start, end) > 1000);
  CHECK(QTest::qWaitFor([&] { return differingPixels(surface.picture(), end) < 50; }, 5000));
}

TEST_CASE("A mesh that outgrows the view stays in view until the camera is moved by hand", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const QRect rim(1, 60, 3, 150);
  surface.setSphere(10);
  surface.setSphere(200);
  CHECK(countPixels(surface.picture(), rim, isWarm) == 0);
  turnWheel(surface.view, {200, 150}, 6);
  surface.setSphere(400);
  CHECK(countPixels(surface.picture(), rim, isWarm) > 100);
  surface.view.resetCamera();
  CHECK(countPixels(surface.picture(), rim, isWarm) == 0);
}

TEST_CASE("A surface at rest fills the view, unless the camera was moved by hand", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  const auto share = [&] {
    return double(countPixels(surface.picture(), isWarm)) / double(kWidth * kHeight);
  };
  const auto grow = [&] {
    setGrowthState(surface.document, GrowthState::running);
    surface.setSphere(50);
    surface.setSphere(160);
  };
  grow();
  const double growing = share();
  setGrowthState(surface.document, GrowthState::finished);
  const double atRest = share();
  CHECK(growing < 0.15);  // room to grow
  CHECK(atRest > 2 * growing);

  grow();
  turnWheel(surface.view, {200, 150}, -1);
  const QImage byHand = surface.picture();
  setGrowthState(surface.document, GrowthState::finished);
  CHECK(surface.picture() == byHand);
}

TEST_CASE("A picture has the size of the view in device pixels, and two are the same", "[surface_view]") {
  Surface surface;
  if (!surface.ready()) return;
  surface.setSphere();
  CHECK(surface.picture().size() == (QSizeF(kWidth, kHeight) * surface.view.devicePixelRatioF()).toSize());
  CHECK(surface.picture() == surface.picture());
}

TEST_CASE("A double click asks for the 3D view alone", "[surface_view]") {
  Surface surface;
  QSignalSpy spy(&surface.view, &SurfaceView::maximiseRequested);
  QTest::mouseDClick(&surface.view, Qt::LeftButton, {}, {100, 100});
  CHECK(spy.count() == 1);
}

TEST_CASE("Two 3D views live beside each other", "[surface_view]") {
  Surface first;
  if (!first.ready()) return;
  first.setSphere();
  const QImage alone = first.picture();
  {
    Surface second;
    second.setSphere(25);
    CHECK(countPixels(second.picture(), isWarm) > 3000);
    CHECK(first.picture() == alone);
  }
  CHECK(first.picture() == alone);
}

TEST_CASE("Without OpenGL the 3D view says so, and everything else goes on", "[.no_opengl]") {
  Surface surface;
  if (surface.view.hasOpenGl()) {
    std::cout << "SKIPPED: this platform has OpenGL\n";
    return;
  }
  surface.setSphere();
  surface.view.lookFrom(Plane::axial);
  surface.view.resetCamera();
  surface.view.showStage(exampleTrace(surface.world(32, 32, 32)), EventStage::opened);
  surface.view.clearStage();
  QTest::mouseClick(&surface.view, Qt::LeftButton, {}, {100, 100});
  turnWheel(surface.view, {100, 100}, 1);
  const auto light = [](const QColor& c) { return c.lightness() > 80; };
  CHECK(countPixels(surface.picture(), QRect(50, 80, 300, 150), light) > 100);  // the sentence's letters
  surface.state.setCrosshair(surface.world(52, 12, 52));                        // in the bright block
  SliceView slice(Plane::axial, surface.document, surface.state);
  show(slice, {kWidth, kHeight});
  CHECK(countPixels(slice.picture(), QRect(245, 60, 40, 30), light) > 900);
}
