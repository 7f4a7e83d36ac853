// The brush on the surface in 3D, and what is pinned. Needs OpenGL.

#include <cmath>

#include "tests/ui/view/surface_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

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

}  // namespace

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

TEST_CASE("In 3D two quick dabs of the brush are two, and do not maximise the view", "[surface_view][pull]") {
  Ball ball;
  if (!ball.ready()) return;
  int maximised = 0;
  QObject::connect(&ball.view, &SurfaceView::maximiseRequested, [&] { ++maximised; });
  const QPoint centre = ball.centre();
  for (const Brush::Mode mode : {Brush::Mode::smooth, Brush::Mode::off}) {
    ball.state.brush().setMode(mode);
    QTest::mouseClick(&ball.view, Qt::LeftButton, {}, centre);
    QMouseEvent second(QEvent::MouseButtonDblClick, centre, ball.view.mapToGlobal(centre), Qt::LeftButton,
                       Qt::LeftButton, {});
    QCoreApplication::sendEvent(&ball.view, &second);
    QTest::mouseRelease(&ball.view, Qt::LeftButton, {}, centre);
    CHECK(edits(ball.document).size() == 2);
    CHECK(maximised == (mode == Brush::Mode::off ? 1 : 0));
  }
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

TEST_CASE("In 3D a stroke of the brush is given up when another object becomes active", "[surface_view]") {
  Ball ball;
  if (!ball.ready()) return;
  ball.state.brush().setMode(Brush::Mode::pin);
  QTest::mousePress(&ball.view, Qt::LeftButton, {}, ball.centre());
  Q_EMIT ball.document.activeObjectChanged();
  QTest::mouseRelease(&ball.view, Qt::LeftButton, {}, ball.centre());
  CHECK(pinned(ball.document).empty());
}
