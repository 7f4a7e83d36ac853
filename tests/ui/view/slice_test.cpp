// Slices without a display: where they lie, what is in their pixels, seeds on them.

#include <Eigen/Geometry>
#include <QLineF>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"
#include "ui/view/held_voxels.h"
#include "ui/view/seed_circles.h"
#include "ui/view/slice_geometry.h"
#include "ui/view/slice_image.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

constexpr Plane kPlanes[] = {Plane::axial, Plane::coronal, Plane::sagittal};

//! Anisotropic, turned by 25 degrees, with permuted and reversed axes.
Grid awkwardGrid() {
  Grid grid;
  grid.size = {40, 31, 24};
  grid.spacing = Vec3(0.8, 1.1, 2.5);
  grid.origin = Vec3(-20, 35, 110);
  Eigen::Matrix3d axes;
  axes << 0, 0, -1, 1, 0, 0, 0, 1, 0;
  grid.direction = Eigen::AngleAxisd(25 * M_PI / 180, Vec3(1, -1, 2).normalized()).toRotationMatrix() * axes;
  return grid;
}

double gray(const QImage& image, int x, int y) { return qRed(image.pixel(x, y)); }

}  // namespace

TEST_CASE("Pixels of a slice and voxels map onto each other", "[slice]") {
  for (Plane plane : kPlanes) {
    SliceGeometry geometry(awkwardGrid(), plane, {300, 200});
    geometry.zoom(1.7, {20, 30});
    geometry.pan({11, -5});
    for (const QPointF& pixel : {QPointF(0, 0), QPointF(150, 100), QPointF(299, 17)}) {
      const QPointF back = geometry.worldToScreen(geometry.toWorld(pixel));
      CHECK(QLineF(back, pixel).length() < 1e-9);
      CHECK(std::abs(geometry.distance(geometry.toWorld(pixel))) < 1e-9);
    }
  }
}

TEST_CASE("Lengths on a slice are millimetres times its scale, in every direction", "[slice]") {
  for (Plane plane : kPlanes) {
    const SliceGeometry geometry(awkwardGrid(), plane, {300, 200});
    for (const QPointF& step : {QPointF(40, 0), QPointF(0, 40), QPointF(24, 32)}) {
      const double mm = (geometry.toWorld(QPointF(100, 90) + step) - geometry.toWorld({100, 90})).norm();
      CHECK(mm == Approx(40 * geometry.mmPerPixel()));
    }
  }
}

TEST_CASE("A fitted slice is wholly in view, centred, and stays so when the view is resized", "[slice]") {
  for (Plane plane : kPlanes) {
    SliceGeometry geometry(awkwardGrid(), plane, {300, 200});
    geometry.resize({120, 400});
    const SliceAxes& axes = geometry.axes();
    Vec3 low = Vec3::Constant(-0.5), high;
    for (int a = 0; a < 3; ++a) high[a] = geometry.grid().size[a] - 0.5;
    const QPointF a = geometry.toScreen(low), b = geometry.toScreen(high);
    CHECK((a + b).x() == Approx(120));
    CHECK((a + b).y() == Approx(400));
    CHECK(std::min(a.x(), b.x()) >= 0);
    CHECK(std::min(a.y(), b.y()) >= 0);
    // One of the two fills the view but for a small rim.
    const double filled = std::max(std::abs(a.x() - b.x()) / 120, std::abs(a.y() - b.y()) / 400);
    CHECK(filled > 0.9);
    CHECK(axes.normal != axes.across);
  }
}

TEST_CASE("Zooming keeps the place under the mouse", "[slice]") {
  SliceGeometry geometry(awkwardGrid(), Plane::coronal, {300, 200});
  const QPointF mouse(70, 160);
  const Vec3 before = geometry.toWorld(mouse);
  const double scale = geometry.mmPerPixel();
  geometry.zoom(1.5, mouse);
  CHECK(geometry.mmPerPixel() == Approx(scale / 1.5));
  CHECK((geometry.toWorld(mouse) - before).norm() < 1e-9);
  geometry.zoom(1e9, mouse);  // stops at some scale, and the place stays even then
  CHECK((geometry.toWorld(mouse) - before).norm() < 1e-9);
}

TEST_CASE("Panning takes the slice along", "[slice]") {
  SliceGeometry geometry(awkwardGrid(), Plane::sagittal, {300, 200});
  const Vec3 before = geometry.toWorld({100, 100});
  geometry.pan({17, -9});
  CHECK((geometry.toWorld({117, 91}) - before).norm() < 1e-9);
}

TEST_CASE("The nearest slice to a point is at most half a voxel away, within the volume", "[slice]") {
  const Grid grid = awkwardGrid();
  for (Plane plane : kPlanes) {
    SliceGeometry geometry(grid, plane, {300, 200});
    const int normal = geometry.axes().normal;
    const Vec3 inside = grid.toWorld(Vec3(13.3, 7.7, 5.45));
    geometry.setSlice(geometry.nearestSlice(inside));
    CHECK(std::abs(geometry.distance(inside)) <= grid.spacing[normal] / 2);
    CHECK(geometry.nearestSlice(grid.toWorld(Vec3::Constant(-50))) == 0);
    CHECK(geometry.nearestSlice(grid.toWorld(Vec3::Constant(500))) == geometry.slices() - 1);
  }
}

TEST_CASE("Forward is towards superior, anterior and the patient's right", "[slice]") {
  const Vec3 ahead[] = {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)};
  for (Plane plane : kPlanes) {
    const SliceGeometry geometry(awkwardGrid(), plane, {300, 200});
    CHECK((geometry.forward() * geometry.normal()).dot(ahead[static_cast<int>(plane)]) > 0.7);
  }
}

TEST_CASE("Every pixel shows the intensity at its place in the world", "[slice_image]") {
  // A field that is linear in the world is reproduced by linear interpolation.
  const Grid grid = awkwardGrid();
  const Vec3 gradient(1.3, -0.7, 0.9);
  const Volume volume = handlebody::testing::volumeByIndex(
      grid, [&](int i, int j, int k) { return gradient.dot(grid.toWorld(Vec3(i, j, k))); });
  const WindowLevel window{250, gradient.dot(grid.toWorld(Vec3(20, 15, 12)))};
  constexpr double kRatio = 2;
  for (Plane plane : kPlanes) {
    SliceGeometry geometry(grid, plane, {150, 110});
    geometry.zoom(1.2, {60, 50});
    geometry.setSlice(geometry.slice() + 2);
    SliceImage picture;
    const QImage& image = picture.render(volume, geometry, kRatio, {window, ColourMap::grey, {}});
    REQUIRE(image.size() == QSize(300, 220));
    int compared = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const Vec3 index = geometry.toIndex({(x + 0.5) / kRatio, (y + 0.5) / kRatio});
        if (!grid.contains(index)) {
          CHECK(image.pixel(x, y) == 0xff000000);
          continue;
        }
        if ((index - geometry.clamped(index)).norm() > 1e-9) continue;  // constant beyond the last voxels
        const double wanted =
            ((gradient.dot(grid.toWorld(index)) - window.level) / window.window + 0.5) * 256;
        CHECK(std::abs(gray(image, x, y) - std::clamp(std::floor(wanted), 0.0, 255.0)) <= 1);
        ++compared;
      }
    CHECK(compared > 5000);
  }
}

TEST_CASE("Intensities below the window are black, above it white", "[slice_image]") {
  Grid grid = handlebody::testing::cubicGrid(16);
  const Volume volume =
      handlebody::testing::volumeByIndex(grid, [](int i, int, int) { return i < 8 ? -1000 : 1000; });
  SliceImage picture;
  const SliceGeometry geometry(grid, Plane::axial, {160, 160});
  const QImage& image = picture.render(volume, geometry, 1, {{100, 0}, ColourMap::grey, {}});
  CHECK(gray(image, 30, 80) == 0);
  CHECK(gray(image, 130, 80) == 255);
}

TEST_CASE("Intensities and windows that are no numbers are black and do no harm", "[slice_image]") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Grid grid = handlebody::testing::cubicGrid(16);
  const Volume volume =
      handlebody::testing::volumeByIndex(grid, [](int i, int, int) { return i < 8 ? kNan : 1000; });
  const SliceGeometry geometry(grid, Plane::axial, {160, 160});
  const auto render = [&](const WindowLevel& window) {
    return SliceImage().render(volume, geometry, 1, {window, ColourMap::grey, {}}).copy();
  };
  const QImage halfKnown = render({100, 0});
  CHECK(gray(halfKnown, 30, 80) == 0);
  CHECK(gray(halfKnown, 130, 80) == 255);
  for (const WindowLevel& window : {WindowLevel{kNan, 0}, WindowLevel{100, kNan}})
    CHECK(gray(render(window), 130, 80) == 0);
}

TEST_CASE("A window that is no number is refused, and one that no picture can have is brought in bounds",
          "[window_level]") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInfinity = std::numeric_limits<double>::infinity();
  ViewState state;
  state.setWindowLevel(100, 50);
  for (const auto& [window, level] : {std::pair(kNan, 0.0),
                                      {kInfinity, 0.0},
                                      {100.0, kNan},
                                      {100.0, -kInfinity},
                                      {0.0, 1.0},
                                      {-1.0, 1.0}}) {
    state.setWindowLevel(window, level);
    CHECK(state.window() == 100);
    CHECK(state.level() == 50);
  }
  const auto isSound = [&] {
    return std::isfinite(256 / static_cast<float>(state.window())) &&
           std::isfinite(static_cast<float>(state.level() - state.window() / 2));
  };
  state.setWindowLevel(1e300, -1e300);
  CHECK(isSound());
  state.setWindowLevel(1e-300, 1e300);
  CHECK(isSound());
}

TEST_CASE("Weights of a resampling add up to one and stay within the samples", "[slice_image]") {
  for (double step : {0.13, -0.13, 1.0, 2.7, -5.2}) {
    const Resampling r = resampling(200, step > 0 ? -3.3 : 33.3, step, 30);
    CHECK(r.end > r.begin);
    for (int p = 0; p < r.end - r.begin; ++p) {
      float sum = 0, mean = 0;
      for (int t = 0; t < r.taps; ++t) {
        const auto i = static_cast<std::size_t>(p * r.taps + t);
        CHECK(r.sample[i] >= 0);
        CHECK(r.sample[i] < 30);
        CHECK(r.weight[i] >= 0);
        sum += r.weight[i];
        mean += r.weight[i] * static_cast<float>(r.sample[i]);
      }
      CHECK(sum == Approx(1).margin(1e-5));
      const double index = (step > 0 ? -3.3 : 33.3) + step * (r.begin + p);
      if (std::abs(step) <= 1) CHECK(mean == Approx(std::clamp(index, 0.0, 29.0)).margin(1e-4));
    }
  }
}

TEST_CASE("Pixels larger than voxels show their mean, not one of them", "[slice_image]") {
  // A chessboard: any single voxel would be black or white.
  const Grid grid = handlebody::testing::cubicGrid(200);
  const Volume volume =
      handlebody::testing::volumeByIndex(grid, [](int i, int j, int) { return (i + j) % 2; });
  SliceImage picture;
  const SliceGeometry geometry(grid, Plane::axial, {40, 40});
  const QImage& image = picture.render(volume, geometry, 1, {{1, 0.5}, ColourMap::grey, {}});
  for (int x = 5; x < 35; ++x) CHECK(std::abs(gray(image, x, 20) - 127.5) < 8);
}

TEST_CASE("Only voxels in range are tinted", "[slice_image]") {
  const Grid grid = handlebody::testing::cubicGrid(16);
  const Volume volume =
      handlebody::testing::volumeByIndex(grid, [](int i, int, int) { return i < 8 ? 10 : 200; });
  SliceImage picture;
  const SliceGeometry geometry(grid, Plane::axial, {160, 160});
  const SliceColours colours{{256, 128}, ColourMap::grey, IntensityRange{0, 50}};
  const QImage& image = picture.render(volume, geometry, 1, colours);
  CHECK(qRed(image.pixel(30, 80)) > qGreen(image.pixel(30, 80)) + 50);
  CHECK(qRed(image.pixel(130, 80)) == qGreen(image.pixel(130, 80)));
  // Between a voxel in range and one above it lie no intensities that are tinted for themselves.
  const SliceColours between{{256, 128}, ColourMap::grey, IntensityRange{50, 150}};
  const QImage& plain = picture.render(volume, geometry, 1, between);
  for (int x = 10; x < 150; ++x) CHECK(qRed(plain.pixel(x, 80)) == qGreen(plain.pixel(x, 80)));
}

TEST_CASE("Given voxels are tinted, whatever their intensities", "[slice_image]") {
  const Grid grid = handlebody::testing::cubicGrid(16);
  const Volume volume = handlebody::testing::volumeByIndex(grid, [](int, int, int) { return 100; });
  SliceImage picture;
  const SliceGeometry geometry(grid, Plane::axial, {160, 160});
  auto mask = std::make_shared<std::vector<std::uint8_t>>(256);
  const int across = 3, down = 12;
  (*mask)[down * 16 + across] = 1;
  const QImage& image = picture.render(volume, geometry, 1, {{256, 128}, ColourMap::grey, {}, mask});
  const QPoint there = geometry.toScreen(Vec3(across, down, 0)).toPoint();
  CHECK(qRed(image.pixel(there)) > qGreen(image.pixel(there)) + 50);
  CHECK(qRed(image.pixel(there.y(), there.x())) == qGreen(image.pixel(there.y(), there.x())));
}

TEST_CASE("Voxels of a slice are held as the surface sees the object: smoothed", "[held_voxels]") {
  const Grid grid = awkwardGrid();
  const Volume volume = handlebody::testing::volumeByIndex(grid, [](int i, int j, int k) {
    return i == 20 && j == 15 && k == 12 ? 200 : i < 24 ? 10 : 200;
  });
  const auto smoothed = std::make_shared<SmoothedVolume>(volume, 2.0);
  const auto object = std::make_shared<ObjectImage>(smoothed, IntensityRange{-1e9, 105}, 1.0);
  for (const Plane plane : kPlanes) {
    SliceGeometry geometry(grid, plane, {100, 100});
    const Vec3 middle(20, 15, 12);
    geometry.setSlice(static_cast<int>(middle[geometry.axes().normal]));
    int told = 0;
    HeldVoxels held([&] { ++told; });
    CHECK(held.of(object, geometry.axes(), geometry.slice()) == nullptr);
    held.finish();
    CHECK(told == 1);
    const auto mask = held.of(object, geometry.axes(), geometry.slice());
    REQUIRE(mask);
    const int across = geometry.axes().across, down = geometry.axes().down;
    REQUIRE(mask->size() == static_cast<std::size_t>(grid.size[across] * grid.size[down]));
    Vec3 index = middle;
    for (int d = 0; d < grid.size[down]; ++d)
      for (int a = 0; a < grid.size[across]; ++a) {
        index[down] = d;
        index[across] = a;
        // The bright voxel in the dark half is noise.
        CHECK((*mask)[static_cast<std::size_t>(d * grid.size[across] + a)] == (index[0] < 24));
      }
  }
}

TEST_CASE("A volume of a single slice is shown in all three planes", "[slice_image]") {
  Grid grid;
  grid.size = {20, 10, 1};
  const Volume volume = handlebody::testing::volumeByIndex(grid, [](int, int, int) { return 7; });
  for (Plane plane : kPlanes) {
    SliceImage picture;
    const SliceGeometry geometry(grid, plane, {60, 60});
    const QImage& image = picture.render(volume, geometry, 1, {{1, 0}, ColourMap::grey, {}});
    CHECK(gray(image, 30, 30) == 255);
    CHECK(gray(image, 30, 1) == 0);
  }
}

TEST_CASE("Another slice, plane or volume is not mistaken for the one that was gathered", "[slice_image]") {
  const Grid grid = handlebody::testing::cubicGrid(8);
  const auto constant = [&](double v) {
    return handlebody::testing::volumeByIndex(grid,
                                              [&](int i, int j, int k) { return v + i + 10 * j + 60 * k; });
  };
  const Volume first = constant(0), second = constant(100);
  SliceImage picture;
  const SliceColours colours{{1000, 500}, ColourMap::grey, {}};
  const auto fresh = [&](const Volume& v, const SliceGeometry& g) {
    return SliceImage().render(v, g, 1, colours);
  };
  SliceGeometry axial(grid, Plane::axial, {64, 64});
  const SliceGeometry coronal(grid, Plane::coronal, {64, 64});
  CHECK(picture.render(first, axial, 1, colours) == fresh(first, axial));
  axial.setSlice(1);
  CHECK(picture.render(first, axial, 1, colours) == fresh(first, axial));
  CHECK(picture.render(first, coronal, 1, colours) == fresh(first, coronal));
  CHECK(picture.render(second, coronal, 1, colours) == fresh(second, coronal));
}

TEST_CASE("A ball is cut by a slice in a circle, or not at all", "[seeds]") {
  SliceGeometry geometry(awkwardGrid(), Plane::axial, {300, 200});
  const Vec3 centre = geometry.toWorld({150, 100}) + 3 * geometry.normal();
  const std::vector<SeedCircle> circles = seedCircles(geometry, {centre, centre}, {5, 2.9});
  REQUIRE(circles.size() == 1);
  CHECK(circles[0].seed == 0);
  CHECK(circles[0].radius * geometry.mmPerPixel() == Approx(4));
  CHECK(circles[0].distance == Approx(3));
  CHECK(QLineF(circles[0].centre, {150, 100}).length() < 1e-9);
}

TEST_CASE("The mouse has hold of a seed's centre and rim, and of nothing between", "[seeds]") {
  const std::vector<SeedCircle> circles{{0, {100, 100}, 50, 0}};
  CHECK(seedAt(circles, {102, 99}, -1).part == SeedGrab::Part::centre);
  CHECK(seedAt(circles, {100, 147}, -1).part == SeedGrab::Part::rim);
  CHECK(seedAt(circles, {153, 100}, -1).part == SeedGrab::Part::rim);
  CHECK(seedAt(circles, {125, 100}, -1).part == SeedGrab::Part::none);
  CHECK(seedAt(circles, {170, 100}, -1).part == SeedGrab::Part::none);
}

TEST_CASE("Of seeds on one place the selected one is taken", "[seeds]") {
  const std::vector<SeedCircle> circles{{0, {100, 100}, 50, 0}, {1, {100, 100}, 40, 0}};
  CHECK(seedAt(circles, {100, 100}, 0).seed == 0);
  CHECK(seedAt(circles, {100, 100}, 1).seed == 1);
  CHECK(seedAt(circles, {100, 100}, -1).seed == 1);
}

TEST_CASE("A rim that is dragged to a place runs through it", "[seeds]") {
  const SliceGeometry geometry(awkwardGrid(), Plane::sagittal, {300, 200});
  const Vec3 centre = geometry.toWorld({140, 90}) - 2 * geometry.normal();
  const QPointF place(190, 120);
  CHECK(draggedRadius(geometry, centre, place) == Approx((geometry.toWorld(place) - centre).norm()));
}

TEST_CASE("The corner says which slice it is, and where", "[slice]") {
  Grid grid = handlebody::testing::cubicGrid(20);
  grid.origin = Vec3(0, 0, -30);
  SliceGeometry straight(grid, Plane::axial, {100, 100});
  straight.setSlice(4);
  CHECK(slicePlace(straight, Plane::axial, Vec3::Zero()) == QStringList{"Slice 5 of 20, I 26.0 mm"});
  const SliceGeometry oblique(awkwardGrid(), Plane::axial, {100, 100});
  const QStringList lines = slicePlace(oblique, Plane::axial, Vec3(-1.2, -2, 3));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].startsWith("Slice "));
  CHECK(lines[1] == "R 1.2  A 2.0  S 3.0 mm");
}

TEST_CASE("In a volume that is tilted a little a slice is where the crosshair is in it", "[slice]") {
  Grid grid = handlebody::testing::cubicGrid(201);
  const double tilt = 0.9 * M_PI / 180;
  grid.direction = Eigen::AngleAxisd(tilt, Vec3::UnitX()).toRotationMatrix();
  REQUIRE_FALSE(isOblique(grid));
  for (Plane plane : kPlanes) {
    SliceGeometry geometry(grid, plane, {100, 100});
    geometry.setSlice(10);
    Vec3 index(150, 150, 150);
    index[geometry.axes().normal] = 10;
    const Vec3 crosshair = grid.toWorld(index);
    const int world = static_cast<int>(plane);
    const QString there = QString("%1 %2 mm")
                              .arg(QChar(anatomicalLetter(world, crosshair[world] >= 0)))
                              .arg(std::abs(crosshair[world]), 0, 'f', 1);
    CHECK(slicePlace(geometry, plane, crosshair) == QStringList{"Slice 11 of 201, " + there});
  }
}

namespace {

//! 100 × 100 × 500 mm of voxels that are 50 times as long as they are wide.
Grid longVoxels() {
  Grid grid;
  grid.size = {1000, 1000, 100};
  grid.spacing = Vec3(0.1, 0.1, 5);
  return grid;
}

}  // namespace

TEST_CASE("A slice that is larger than any limit of the zoom is zoomed from where it is whole", "[slice]") {
  SliceGeometry geometry(longVoxels(), Plane::coronal, {30, 20});
  const double whole = geometry.mmPerPixel();
  geometry.zoom(1.1, {15, 10});
  CHECK(geometry.mmPerPixel() == Approx(whole / 1.1));
  geometry.zoom(1e-6, {15, 10});
  CHECK(geometry.mmPerPixel() == Approx(whole));
  Grid few;
  few.size = {3, 3, 3};
  SliceGeometry small(few, Plane::axial, {3000, 2000});
  const double large = small.mmPerPixel();
  small.zoom(0.9, {1500, 1000});
  CHECK(small.mmPerPixel() == Approx(large / 0.9));
}

TEST_CASE("The texture of a slice covers its voxels and nothing else, to a pixel", "[slice]") {
  const Grid grid = GENERATE(awkwardGrid(), longVoxels());
  for (Plane plane : kPlanes) {
    const SliceGeometry whole = wholeSlice(grid, plane, 25);
    CHECK(std::max(whole.size().width(), whole.size().height()) == 25);
    Vec3 high;
    for (int a = 0; a < 3; ++a) high[a] = grid.size[a] - 0.5;
    const QPointF one = whole.toScreen(Vec3::Constant(-0.5)), other = whole.toScreen(high);
    CHECK(std::abs(std::abs(one.x() - other.x()) - whole.size().width()) <= 1);
    CHECK(std::abs(std::abs(one.y() - other.y()) - whole.size().height()) <= 1);
    CHECK((one + other).x() == Approx(whole.size().width()));
  }
}
