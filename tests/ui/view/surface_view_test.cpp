// The 3D view through its pictures. Needs OpenGL but for the tests with the tag [no_opengl].

#include <QSignalSpy>
#include <iostream>

#include "tests/ui/view/widget_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

constexpr int kWidth = 400, kHeight = 300;

bool isWarm(const QColor& c) { return c.red() > c.blue() + 40; }  // the mesh's own colour
bool isRed(const QColor& c) { return c.red() > 2 * c.green() + 30 && c.red() > 2 * c.blue() + 30; }
bool isGreen(const QColor& c) { return c.green() > c.red() + 50 && c.green() > c.blue() + 20; }

//! A shown view of an open volume without slices; the camera jumps.
struct Surface : Work {
  Surface() : view(document, state) {
    view.setFlightTime(0);
    open();
    state.setSlicesIn3d(false);
    show(view, {kWidth, kHeight});
  }
  bool ready() const {
    if (view.hasOpenGl()) return true;
    std::cout << "SKIPPED: no OpenGL\n";
    return false;
  }
  QImage picture() { return view.picture(); }
  //! The middle of all pixels that are so.
  template <typename F>
  QPointF middle(F&& is) {
    const QImage image = picture();
    QPointF sum;
    int count = 0;
    for (int y = 60; y < kHeight - 60; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (is(QColor(image.pixel(x, y)))) {
          sum += QPointF(x, y);
          ++count;
        }
    REQUIRE(count > 20);
    return sum / count;
  }
  void setSphere(double radius = 15) { setSnapshot(document, icosphere(world(32, 32, 32), radius, 2)); }

  SurfaceView view;
};

int differingPixels(const QImage& a, const QImage& b) {
  REQUIRE(a.size() == b.size());
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

bool isPinColour(const QColor& c) { return c.green() > c.red() + 40 && c.blue() > c.red() + 30; }

//! A ball at rest in the middle of the view, seen from the front, and the brush of 4 mm.
struct Ball : Surface {
  Ball() {
    setSnapshot(document, icosphere(world(32, 32, 32), 15, 2), {}, {}, true);
    setGrowthState(document, GrowthState::finished);
    state.brush().setRadius(4);
    QTest::keyClick(&view, Qt::Key_End);
    (void)picture();
  }
  //! Where it is seen, by its colour.
  QPoint centre() { return middle(isWarm).toPoint(); }
  void moveTo(const QPoint& at, Qt::MouseButtons buttons = Qt::NoButton) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, {});
    QCoreApplication::sendEvent(&view, &move);
  }
};

EventTrace exampleTrace(const Vec3& at) {
  EventTrace trace;
  const auto face = [&](double x, double z) {
    return std::array<Vec3, 3>{at + Vec3(x, 0, z), at + Vec3(x + 4, 0, z), at + Vec3(x, 0, z + 4)};
  };
  trace.collidingFaces = {face(0, 0)};
  trace.openedFaces = {face(6, 0), face(-6, 0)};
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

TEST_CASE("The brush lies on the surface under the mouse, on the side of the eye", "[surface_view][pins]") {
  Ball ball;
  if (!ball.ready()) return;
  ball.state.brush().setMode(Brush::Mode::pin);
  const QPoint centre = ball.centre();
  QTest::mousePress(&ball.view, Qt::LeftButton, {}, centre);
  REQUIRE(ball.state.brush().stroke().size() == 1);
  const Vec3 place = ball.state.brush().stroke().front().centre;
  CHECK((place - (ball.world(32, 32, 32) - Vec3(0, 15, 0))).norm() < 1.5);  // anterior
  const QImage before = ball.picture();
  ball.moveTo(centre + QPoint(30, 0), Qt::LeftButton);
  const std::vector<WallBall> stroke = ball.state.brush().stroke();
  CHECK(stroke.size() > 1);
  for (const WallBall& b : stroke) CHECK(std::abs((b.centre - ball.world(32, 32, 32)).norm() - 15) < 0.6);
  CHECK(stroke.back().centre.x() > place.x() + 2);  // to the patient's left
  CHECK(differingPixels(before, ball.picture()) > 100);
  QTest::mouseRelease(&ball.view, Qt::LeftButton, {}, centre + QPoint(30, 0));
  CHECK(pinned(ball.document) == stroke);
}

TEST_CASE("Beside the surface the brush is the camera's, and Ctrl and the wheel set its radius",
          "[surface_view][pins]") {
  Ball ball;
  if (!ball.ready()) return;
  ball.state.brush().setMode(Brush::Mode::pin);
  QTest::keyClick(&ball.view, Qt::Key_Home);
  const QImage before = ball.picture();
  drag(ball.view, Qt::LeftButton, {30, 150}, {90, 180});
  CHECK(pinned(ball.document).empty());
  CHECK(differingPixels(before, ball.picture()) > 100);  // rotated
  turnWheel(ball.view, {200, 150}, 1, Qt::ControlModifier);
  CHECK(ball.state.brush().radius() == Approx(4.4));
  ball.state.brush().setMode(Brush::Mode::off);
  drag(ball.view, Qt::LeftButton, ball.centre(), ball.centre() + QPoint(20, 0));
  CHECK(pinned(ball.document).empty());
}

TEST_CASE("A fast stroke leaves no gap, and none goes through the air", "[surface_view][pins]") {
  Ball ball;
  if (!ball.ready()) return;
  TriangleSoup two = icosphere(ball.world(32, 20, 32), 8, 2);
  const TriangleSoup behind = icosphere(ball.world(44, 60, 32), 8, 2);  // 40 mm further from the eye
  const int first = static_cast<int>(two.points.size());
  two.points.insert(two.points.end(), behind.points.begin(), behind.points.end());
  for (const Triangle& t : behind.triangles)
    two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  setSnapshot(ball.document, two, {}, {}, true);
  (void)ball.picture();
  ball.state.brush().setMode(Brush::Mode::pin);
  ball.state.brush().setRadius(2);
  const QPoint centre = ball.centre();
  QTest::mousePress(&ball.view, Qt::LeftButton, {}, centre - QPoint(20, 0));
  ball.moveTo(centre + QPoint(60, 0), Qt::LeftButton);  // in one leap
  const std::vector<WallBall> stroke = ball.state.brush().stroke();
  CHECK(stroke.size() > 5);
  bool isOnBoth = false;
  for (const WallBall& b : stroke) {
    const double front = std::abs((b.centre - ball.world(32, 20, 32)).norm() - 8);
    const double back = std::abs((b.centre - ball.world(44, 60, 32)).norm() - 8);
    CHECK(std::min(front, back) < 1);
    isOnBoth = isOnBoth || back < 1;
  }
  CHECK(isOnBoth);
}

TEST_CASE("In 3D a point is pulled across the line of sight", "[surface_view][pull]") {
  Ball ball;
  if (!ball.ready()) return;
  ball.state.brush().setMode(Brush::Mode::pull);
  const QPoint from = ball.centre() + QPoint(10, 0), to = from + QPoint(0, -60);
  QTest::mousePress(&ball.view, Qt::LeftButton, {}, from);
  ball.moveTo(to, Qt::LeftButton);
  REQUIRE(ball.state.brush().pull());
  QTest::mouseRelease(&ball.view, Qt::LeftButton, {}, to);
  REQUIRE(edits(ball.document).size() == 1);
  const MeshEdit& edit = edits(ball.document).front();
  CHECK(edit.kind == MeshEditKind::pull);
  CHECK(std::abs((edit.place - ball.world(32, 32, 32)).norm() - 15) < 0.6);
  const Vec3 way = edit.vector - edit.place;
  CHECK(way.z() > 3);  // up: superior
  CHECK(std::abs(way.x()) < 1e-9);
  CHECK(std::abs(way.y()) < 1e-9);
}

TEST_CASE("What is pinned is drawn on the surface, with what the colour means, and can be hidden",
          "[surface_view][pins]") {
  Ball ball;
  if (!ball.ready()) return;
  const int before = countPixels(ball.picture(), isPinColour);
  Constraints pins;
  pins.pins = {{ball.world(32, 32, 32) - Vec3(0, 15, 0), 6, 0}};
  setConstraints(ball.document, pins);
  CHECK(countPixels(ball.picture(), isPinColour) > before + 400);
  ball.state.setShowsConstraints(false);
  CHECK(countPixels(ball.picture(), isPinColour) == before);
  ball.state.setShowsConstraints(true);
  QTest::keyClick(&ball.view, Qt::Key_End, Qt::ShiftModifier);  // from behind: its key alone
  const int key = countPixels(ball.picture(), isPinColour);
  CHECK(key > before);
  CHECK(key < before + 300);
  ball.state.setShowsConstraints(true);
  pins.pins[0].iteration = 3;  // not yet
  setConstraints(ball.document, pins);
  CHECK(countPixels(ball.picture(), isPinColour) == before);
}

TEST_CASE("What another object hides cannot be touched", "[surface_view][pins]") {
  Ball ball;
  if (!ball.ready()) return;
  const QPoint centre = ball.centre();
  ObjectInfo other;
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->mesh = icosphere(ball.world(32, 5, 32), 5, 1.5);  // between it and the eye
  other.snapshot = snapshot;
  setOthers(ball.document, {other});
  (void)ball.picture();
  ball.state.brush().setMode(Brush::Mode::pin);
  QTest::mouseClick(&ball.view, Qt::LeftButton, {}, centre);
  CHECK(pinned(ball.document).empty());
}
