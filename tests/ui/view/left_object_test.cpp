// What has hold of an object, or of what is open, lets it go when another one becomes active, or is opened.

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

TEST_CASE("A slice that is not seen lets go of what was open before", "[slice_view]") {
  OneSlice slice;
  auto object = std::make_shared<const ObjectImage>(std::make_shared<SmoothedVolume>(slice.volume, 1.0),
                                                    IntensityRange{150, 1e9}, 1.0);
  setSnapshot(slice.document, icosphere(slice.world(32, 32, 32), 10, 2));
  ObjectInfo beside;
  beside.snapshot = std::make_shared<MeshSnapshot>();
  setOthers(slice.document, {beside});
  slice.state.setTint(Tint{object, {}});
  (void)slice.view.picture();
  slice.view.hide();
  const std::weak_ptr<const void> tinted = object, voxels = slice.volume.voxels,
                                  outlined = slice.document.snapshot(), other = beside.snapshot;
  object.reset();
  beside.snapshot.reset();
  slice.volume =
      handlebody::testing::volumeByIndex(handlebody::testing::cubicGrid(8), [](int, int, int) { return 7; });
  setVolume(slice.document, slice.volume);
  slice.state.startWith(slice.volume);
  CHECK(tinted.expired());
  CHECK(voxels.expired());
  CHECK(outlined.expired());
  CHECK(other.expired());
}
