// What has hold of an object lets it go when another one becomes active.

#include "tests/ui/view/slice_support.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

TEST_CASE("A seed that the mouse holds is let go when another object becomes active", "[slice_view]") {
  OneSlice slice;
  const Vec3 held = slice.state.crosshair();
  slice.document.addSeed({held, 6.0});
  const QPoint centre = slice.geometry.worldToScreen(held).toPoint();
  for (const QPoint& grip : {centre, centre + QPoint(qRound(6 / slice.geometry.mmPerPixel()), 0)}) {
    QTest::mousePress(&slice.view, Qt::LeftButton, {}, grip);
    Q_EMIT slice.document.activeObjectChanged();  // with as many seeds
    slice.under(grip + QPoint(30, 20));
    QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, grip + QPoint(30, 20));
    CHECK(slice.document.seeds().front() == Seed{held, 6.0});
  }
}

TEST_CASE("A key that sizes a seed is another change of another object", "[slice_view]") {
  OneSlice slice;
  QTest::keyClick(&slice.view, Qt::Key_Return);
  const auto hold = [&] {
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_Plus, {}, QStringLiteral("+"), true);
    QCoreApplication::sendEvent(&slice.view, &repeated);
  };
  QTest::keyClick(&slice.view, Qt::Key_Plus);
  hold();
  Q_EMIT slice.document.activeObjectChanged();
  hold();
  const std::vector<int>& all = gestures(slice.document);
  REQUIRE(all.size() == 3);
  CHECK(all[0] == all[1]);
  CHECK(all[1] != all[2]);
}

TEST_CASE("A stroke of the brush is given up when another object becomes active", "[slice_view]") {
  OneSlice slice;
  slice.state.brush().setMode(Brush::Mode::paintWalls);
  QTest::mousePress(&slice.view, Qt::LeftButton, {}, kPlace);
  CHECK_FALSE(slice.state.brush().stroke().empty());
  Q_EMIT slice.document.activeObjectChanged();
  QTest::mouseRelease(&slice.view, Qt::LeftButton, {}, kPlace);
  CHECK(painted(slice.document).empty());
}
