// Pictures are read back and measured: nothing here is compared with an earlier picture.

#include "app/picture/picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/picture/picture_slice.h"
#include "tests/io/io_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! A PNG in memory, y down.
struct Png {
  explicit Png(const std::string& path) {
    vtkNew<vtkPNGReader> reader;
    REQUIRE(reader->CanReadFile(path.c_str()) != 0);
    reader->SetFileName(path.c_str());
    reader->Update();
    REQUIRE(reader->GetErrorCode() == 0);
    image = reader->GetOutput();
    image->GetDimensions(size);
    REQUIRE(image->GetNumberOfScalarComponents() == 3);
  }
  int channel(int x, int y, int c) const {
    return static_cast<const unsigned char*>(image->GetScalarPointer(x, size[1] - 1 - y, 0))[c];
  }
  //! The outline is the only thing in the slices that is not nearly grey.
  bool isOutline(int x, int y) const { return channel(x, y, 0) - channel(x, y, 2) > 100; }
  bool isBright(int x, int y) const { return channel(x, y, 2) > 127; }

  vtkSmartPointer<vtkImageData> image;
  int size[3] = {0, 0, 0};
};

//! Centres of the pixels of `area` for which `is` holds.
template <typename F>
std::vector<Vec2> pixelsWhere(const Rect& area, F&& is) {
  std::vector<Vec2> found;
  for (int y = area.y; y < area.bottom(); ++y)
    for (int x = area.x; x < area.right(); ++x)
      if (is(x, y)) found.emplace_back(x + 0.5, y + 0.5);
  return found;
}

std::vector<Vec2> outlineIn(const Png& png, const Rect& area) {
  return pixelsWhere(area, [&](int x, int y) { return png.isOutline(x, y); });
}

//! Width and height of the box around pixels.
Vec2 extentOf(const std::vector<Vec2>& pixels) {
  REQUIRE_FALSE(pixels.empty());
  Vec2 low = pixels[0], high = low;
  for (const Vec2& p : pixels) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low + Vec2(1, 1);
}

//! 200 where `inside` says so of the voxel's place (mm LPS), else 0.
template <typename F>
Volume volumeWhere(const Grid& grid, F&& inside) {
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::uint8, &buffer);
  auto* at = static_cast<std::uint8_t*>(buffer);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) *at++ = inside(grid.toWorld(Vec3(i, j, k))) ? 200 : 0;
  return volume;
}

Volume empty(const Grid& grid) {
  return volumeWhere(grid, [](const Vec3&) { return false; });
}

Vec3 centreOf(const Grid& grid) {
  return grid.toWorld(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1) / 2);
}

Grid anisotropicGrid() {
  Grid grid;
  grid.size = {121, 101, 29};
  grid.spacing = Vec3(0.5, 0.6, 2.5);
  grid.origin = Vec3(-30, 12, 300);
  return grid;
}

//! The picture of a volume and a mesh, read back.
Png pictureOf(const Volume& volume, const TriangleSoup& mesh, const PictureOptions& options = {}) {
  const TemporaryFolder folder;
  writePicture(volume, mesh, folder / "p.png", options);
  return Png(folder / "p.png");
}

//! True if some pixel lies in every direction from `middle`, to two pixels at `radius` pixels: no gaps.
bool goesAround(const std::vector<Vec2>& pixels, const Vec2& middle, double radius) {
  const auto count = static_cast<std::size_t>(M_PI * radius);
  std::vector<bool> seen(count, false);
  for (const Vec2& p : pixels) {
    const double turns = std::atan2(p.y() - middle.y(), p.x() - middle.x()) / (2 * M_PI) + 1;
    seen[static_cast<std::size_t>(turns * static_cast<double>(count)) % count] = true;
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

//! Every outline pixel lies on the circle in which the view's plane cuts the sphere, and all of it is drawn.
void expectCircle(const Png& png, const SliceView& view, const Grid& grid, const Vec3& centre,
                  double radius) {
  const Vec3 index = grid.toIndex(centre);
  const Vec2 middle = view.toPicture(index);
  const double off = (index[view.normal] - view.centre[view.normal]) * view.spacing[view.normal];
  const double pixels = std::sqrt(radius * radius - off * off) / view.mmPerPixel;
  const std::vector<Vec2> outline = outlineIn(png, view.area);
  for (const Vec2& p : outline) REQUIRE(std::abs((p - middle).norm() - pixels) < 1.5);
  CHECK(goesAround(outline, middle, pixels));
}

}  // namespace

TEST_CASE("a picture is a PNG of the promised size, the same bytes each time") {
  const TemporaryFolder folder;
  const Volume volume = randomVolume(obliqueGrid(), VoxelType::int16);
  const TriangleSoup mesh = sphere(centreOf(volume.grid), 1.5, 2);
  writePicture(volume, mesh, folder / "a.png");
  writePicture(volume, mesh, folder / "b.PNG");
  const Png png(folder / "a.png");
  CHECK(png.size[0] == kPictureWidth);
  CHECK(png.size[1] == kPictureHeight);
  CHECK(readBytes(folder / "a.png") == readBytes(folder / "b.PNG"));
  CHECK(folder.fileCount() == 2);
}

TEST_CASE("the outline of a sphere is the circle in which the slice cuts it") {
  Grid grid = anisotropicGrid();
  SECTION("along the world's axes") {}
  SECTION("oblique") { grid.direction = obliqueGrid().direction; }
  const Vec3 centre = centreOf(grid) + Vec3(1.3, -0.8, 0.7);
  const double radius = 12.5;
  const TriangleSoup mesh = sphere(centre, radius, 6);
  const Png png = pictureOf(empty(grid), mesh);
  for (const SliceView& view : planSlices(grid, mesh, {})) expectCircle(png, view, grid, centre, radius);
}

TEST_CASE("a slice through a given point cuts the sphere there") {
  const Grid grid = anisotropicGrid();
  const Vec3 centre = centreOf(grid);
  const double radius = 12.5;
  const TriangleSoup mesh = sphere(centre, radius, 6);
  PictureOptions options;
  options.point = centre + Vec3(5, -6, 5);
  const Png png = pictureOf(empty(grid), mesh, options);
  const auto views = planSlices(grid, mesh, options);
  for (const SliceView& view : views) {
    const double off = grid.toWorld(view.centre)[view.normal] - (*options.point)[view.normal];
    CHECK(std::abs(off) <= grid.spacing[view.normal] / 2 + 1e-9);
    expectCircle(png, view, grid, centre, radius);
  }
}

TEST_CASE("an outline through vertices and along edges has no gaps") {
  Grid grid;
  grid.size = {41, 41, 41};
  const Vec3 centre(20, 20, 20);
  const TriangleSoup octahedron = sphere(centre, 8, 0);
  const Png png = pictureOf(empty(grid), octahedron);
  for (const SliceView& view : planSlices(grid, octahedron, {})) {
    const Vec2 middle = view.toPicture(centre);
    const std::vector<Vec2> outline = outlineIn(png, view.area);
    for (const Vec2& p : outline) {
      // The slice of an octahedron is a square on its corner.
      REQUIRE(std::abs((p - middle).cwiseAbs().sum() * view.mmPerPixel - 8) <
              1.5 * M_SQRT2 * view.mmPerPixel);
    }
    CHECK(goesAround(outline, middle, 8 / view.mmPerPixel / M_SQRT2));
  }
}

TEST_CASE("millimetres are square on the picture, whatever the spacing") {
  const Grid grid = anisotropicGrid();
  const Vec3 centre = centreOf(grid);
  const double radius = 12.5;
  const TriangleSoup mesh = sphere(centre, radius, 5);
  const Volume ball = volumeWhere(grid, [&](const Vec3& p) { return (p - centre).norm() < radius; });
  const Png withMesh = pictureOf(ball, mesh);
  for (const SliceView& view : planSlices(grid, mesh, {})) {
    const Vec2 outline = extentOf(outlineIn(withMesh, view.area));
    CHECK(std::abs(outline.x() - outline.y()) <= 2);
    const Rect middle{static_cast<int>(view.area.centre().x()) - 150,
                      static_cast<int>(view.area.centre().y()) - 150, 300, 300};
    const Vec2 bright = extentOf(pixelsWhere(middle, [&](int x, int y) { return withMesh.isBright(x, y); }));
    // A border between voxels is known to half a voxel on either side.
    for (const auto& [axis, length] : {std::pair(view.across, bright.x()), {view.down, bright.y()}})
      CHECK(std::abs(length * view.mmPerPixel - 2 * radius) <= grid.spacing[axis] + 4 * view.mmPerPixel);
  }
}

TEST_CASE("right is on the left, superior up and anterior on the left, for every order of the axes") {
  std::array<int, 3> order{0, 1, 2};
  do {
    for (unsigned flips = 0; flips < 8; ++flips) {
      Grid grid;
      grid.size = {30, 40, 50};
      grid.spacing = Vec3(1, 1.5, 2);
      grid.direction.setZero();
      for (int a = 0; a < 3; ++a) grid.direction(order[a], a) = (flips >> a & 1U) != 0 ? -1 : 1;
      const auto views = planSlices(grid, {}, {});
      const auto shift = [&](const SliceView& view, const Vec3& mm) {
        return Vec2((view.toPicture(grid.toIndex(mm)) - view.toPicture(grid.toIndex(Vec3::Zero()))) *
                    view.mmPerPixel);
      };
      const Vec3 left(1, 0, 0), posterior(0, 1, 0), superior(0, 0, 1);
      CHECK((shift(views[0], left) - Vec2(1, 0)).norm() < 1e-9);
      CHECK((shift(views[0], posterior) - Vec2(0, 1)).norm() < 1e-9);
      CHECK(shift(views[0], superior).norm() < 1e-9);
      CHECK((shift(views[1], left) - Vec2(1, 0)).norm() < 1e-9);
      CHECK((shift(views[1], superior) - Vec2(0, -1)).norm() < 1e-9);
      CHECK((shift(views[2], posterior) - Vec2(1, 0)).norm() < 1e-9);
      CHECK((shift(views[2], superior) - Vec2(0, -1)).norm() < 1e-9);
      CHECK_FALSE(isOblique(grid));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("voxels lie under the outline of the mesh that encloses them") {
  Grid grid;
  grid.size = {64, 70, 50};
  grid.spacing = Vec3(0.7, 0.8, 1.1);
  grid.direction << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  const Vec3 centre = grid.toWorld(Vec3(40, 20, 30));
  const double radius = 8;
  const TriangleSoup mesh = sphere(centre, radius, 5);
  const Png png =
      pictureOf(volumeWhere(grid, [&](const Vec3& p) { return (p - centre).norm() < radius; }), mesh);
  for (const SliceView& view : planSlices(grid, mesh, {})) {
    const Vec2 middle = view.toPicture(grid.toIndex(centre));
    const double pixels = radius / view.mmPerPixel, voxel = 1.1 / view.mmPerPixel;
    for (int degrees = 0; degrees < 360; degrees += 45) {
      const Vec2 direction(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
      const Vec2 in = middle + (pixels - 1.5 * voxel) * direction,
                 out = middle + (pixels + 1.5 * voxel) * direction;
      CHECK(png.isBright(static_cast<int>(in.x()), static_cast<int>(in.y())));
      CHECK_FALSE(png.isBright(static_cast<int>(out.x()), static_cast<int>(out.y())));
    }
  }
}

TEST_CASE(
    "a slice shows at least twice the mesh's extent, and nothing beyond the volume where it is larger") {
  Grid grid;
  grid.size = {300, 300, 300};
  const Vec3 corner(20, 280, 150);
  const TriangleSoup mesh = sphere(corner, 15, 4);
  for (const SliceView& view : planSlices(grid, mesh, {})) {
    CHECK(std::min(view.area.width, view.area.height) * view.mmPerPixel >= 60);
    CHECK(std::max(view.area.width, view.area.height) * view.mmPerPixel <= 300);
    const Vec3 low = view.toIndex(Vec2(view.area.x + 0.5, view.area.y + 0.5));
    const Vec3 high = view.toIndex(Vec2(view.area.right() - 0.5, view.area.bottom() - 0.5));
    CHECK(grid.contains(low));
    CHECK(grid.contains(high));
  }
}

TEST_CASE("a thin mesh between two slices is cut nevertheless") {
  Grid grid;
  grid.size = {41, 41, 11};
  grid.spacing = Vec3(1, 1, 10);
  const Vec3 centre(20, 20, 44);
  const TriangleSoup mesh = sphere(centre, 3, 4);
  const Png png = pictureOf(empty(grid), mesh);
  for (const SliceView& view : planSlices(grid, mesh, {})) expectCircle(png, view, grid, centre, 3);
}

TEST_CASE("the surface is seen as large as the panel allows, and round where it is") {
  const Grid grid = anisotropicGrid();
  const TriangleSoup mesh = sphere(centreOf(grid), 12.5, 5);
  const Png png = pictureOf(empty(grid), mesh);
  const SliceView aside = planSlices(grid, mesh, {})[1], below = planSlices(grid, mesh, {})[2];
  const Rect area{aside.area.x, below.area.y, aside.area.width, below.area.height};
  const auto warm =
      pixelsWhere(area, [&](int x, int y) { return png.channel(x, y, 0) - png.channel(x, y, 2) > 15; });
  const Vec2 extent = extentOf(warm);
  CHECK(std::abs(extent.x() - extent.y()) <= 2);
  CHECK(extent.y() > 0.75 * area.height);
  CHECK(static_cast<double>(warm.size()) == Approx(M_PI / 4 * extent.x() * extent.y()).epsilon(0.02));
}

TEST_CASE("an empty mesh, a flat volume and a point far outside still make a picture") {
  const Grid grid = obliqueGrid();
  PictureOptions options;
  options.point = Vec3(1e6, -1e6, 1e6);
  const Png png = pictureOf(empty(grid), {}, options);
  for (const SliceView& view : planSlices(grid, {}, options)) {
    CHECK(grid.contains(view.centre));
    CHECK(outlineIn(png, view.area).empty());
  }
}

TEST_CASE("a picture that cannot be written leaves nothing behind") {
  const TemporaryFolder folder;
  const Volume volume = empty(obliqueGrid());
  CHECK_THROWS_AS(writePicture(volume, {}, folder / "missing/p.png"), OutputError);
  fs::create_directory(folder / "p.png");
  CHECK_THROWS_AS(writePicture(volume, {}, folder / "p.png"), OutputError);
  CHECK_THROWS_AS(writePicture(volume, {}, folder / "p.jpg"), UsageError);
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a thumbnail has the mean colours of its picture, the same way up") {
  const TemporaryFolder folder;
  const Grid grid = anisotropicGrid();
  writePicture(empty(grid), sphere(centreOf(grid), 12.5, 5), folder / "p.png");
  std::ofstream(folder / "t.png", std::ios::binary) << thumbnailOf(folder / "p.png");
  const Png large(folder / "p.png"), small(folder / "t.png");
  REQUIRE(small.size[0] * kThumbnailPart == large.size[0]);
  REQUIRE(small.size[1] * kThumbnailPart == large.size[1]);
  int wrong = 0;
  for (int y = 0; y < small.size[1]; ++y)
    for (int x = 0; x < small.size[0]; ++x) {
      int sum = 0;
      for (int i = 0; i < kThumbnailPart * kThumbnailPart; ++i)
        sum += large.channel(x * kThumbnailPart + i % kThumbnailPart, y * kThumbnailPart + i / kThumbnailPart,
                             0);
      const double mean = double(sum) / (kThumbnailPart * kThumbnailPart);
      wrong += std::abs(mean - small.channel(x, y, 0)) > 0.51 ? 1 : 0;  // rounded to a whole number
    }
  CHECK(wrong == 0);
}

TEST_CASE("what is no picture of a result has no thumbnail") {
  const TemporaryFolder folder;
  std::ofstream(folder / "p.png") << "no picture";
  CHECK_THROWS_AS(thumbnailOf(folder / "p.png"), InputError);
  CHECK_THROWS_AS(thumbnailOf(folder / "none.png"), InputError);
}
