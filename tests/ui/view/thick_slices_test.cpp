// Seeds and loops in slices of voxels that are no cubes: where and how large they are drawn.

#include "tests/ui/view/slice_support.h"
#include "ui/view/overlay.h"
#include "ui/view/slice_interaction.h"

using namespace handlebody;
using namespace handlebody::ui;
using namespace handlebody::ui::testing;

namespace {

//! Voxels of 1 × 1 × 5 mm.
struct ThickSlices : Work {
  explicit ThickSlices(Plane plane) {
    volume.grid = handlebody::testing::cubicGrid(40);
    volume.grid.spacing = Vec3(1, 1, 5);
    volume = handlebody::testing::volumeByIndex(volume.grid, [](int, int, int) { return 100; });
    open();
    geometry = SliceGeometry(volume.grid, plane, {kWidth, kHeight});
  }
  std::vector<SeedCircle> circlesIn(int slice) {
    geometry.setSlice(slice);
    return SliceInteraction(document, state, geometry).circles();
  }

  SliceGeometry geometry;
};

}  // namespace

TEST_CASE("A seed is drawn as large as it is, however thick the slices of the volume are", "[seeds]") {
  ThickSlices work(Plane::coronal);
  work.document.addSeed({work.world(20, 20, 20), 1.5});
  const auto radiiIn = [&](int slice) {
    std::vector<double> radii;
    for (const SeedCircle& c : work.circlesIn(slice)) radii.push_back(c.radius * work.geometry.mmPerPixel());
    return radii;
  };
  REQUIRE(radiiIn(20).size() == 1);
  CHECK(radiiIn(20)[0] == Approx(1.5));
  REQUIRE(radiiIn(21).size() == 1);
  CHECK(radiiIn(21)[0] == Approx(std::sqrt(1.5 * 1.5 - 1)));
  CHECK(radiiIn(22).empty());  // 2 mm away
}

TEST_CASE("A seed between two slices is a dot in the nearer one, which is moved and has no rim", "[seeds]") {
  ThickSlices work(Plane::axial);
  work.document.addSeed({work.world(20, 20, 20.4), 1.5});  // 2 mm and 3 mm away
  const std::vector<SeedCircle> nearer = work.circlesIn(20);
  REQUIRE(nearer.size() == 1);
  CHECK(nearer[0].radius == 0);
  CHECK(work.circlesIn(21).empty());
  for (const double away : {0.0, 3.0, 5.0})
    CHECK(seedAt(nearer, nearer[0].centre + QPointF(away, 0), -1).part == SeedGrab::Part::centre);
  CHECK(seedAt(nearer, nearer[0].centre + QPointF(9, 0), -1).part == SeedGrab::Part::none);
}

TEST_CASE("A dot is seen, and one outside of the object is a cross", "[seeds]") {
  ThickSlices work(Plane::axial);
  SliceView view(Plane::axial, work.document, work.state);
  show(view, {kWidth, kHeight});
  work.state.setCrosshair(work.world(5, 5, 20));  // its lines lie elsewhere
  const QPoint at = work.geometry.worldToScreen(work.world(20, 20, 20)).toPoint();
  const auto around = [&](auto&& is) {
    return countPixels(view.picture(), QRect(at - QPoint(12, 12), at + QPoint(12, 12)), is);
  };
  const auto isSeed = [](const QColor& c) { return c.blue() > 200 && c.red() < 130; };
  const auto isOutside = [](const QColor& c) { return c.red() > 200 && c.blue() < 90 && c.green() < 160; };
  work.document.addSeed({work.world(20, 20, 20.4), 1.5});
  CHECK(around(isSeed) > 8);
  CHECK(around(isOutside) == 0);
  work.document.removeSeed(0);
  work.document.addSeed({work.world(20, 20, 20.4), 1.5, true});
  CHECK(around(isSeed) == 0);
  CHECK(around(isOutside) > 8);
}

TEST_CASE("A marked loop is drawn in the slices that it lies in, however thick those of the volume are",
          "[slice_view]") {
  ThickSlices work(Plane::coronal);
  SliceView view(Plane::coronal, work.document, work.state);
  show(view, {kWidth, kHeight});
  MarkedLoop loop;
  for (const Vec3& corner : {Vec3(10, 20, 10), Vec3(30, 20, 10), Vec3(30, 20, 30), Vec3(10, 20, 30)})
    loop.points.push_back(work.volume.grid.toWorld(corner));
  work.state.markLoops({loop});
  const QColor wanted = loopColour(loop.kind);
  const auto pixelsIn = [&](int slice) {
    work.state.setCrosshair(work.world(20, slice, 20));
    const auto is = [&](const QColor& c) { return c.rgb() == wanted.rgb(); };
    return countPixels(view.picture(), is);
  };
  CHECK(pixelsIn(20) > 100);
  CHECK(pixelsIn(21) == 0);  // 1 mm away
  CHECK(pixelsIn(22) == 0);
}
