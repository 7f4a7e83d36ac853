#include "app/picture/picture.h"

#include <array>
#include <limits>

#include "app/picture/picture_slice.h"
#include "app/picture/picture_surface.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {
namespace {

const Colour kGround(0.055F, 0.060F, 0.070F), kPanel(0.0F, 0.0F, 0.0F);
const Colour kCaption(0.88F, 0.90F, 0.93F), kMuted(0.58F, 0.61F, 0.66F);

constexpr int kGap = 10, kHeader = 30;

//! The image area of panel 0 to 3, in reading order; its header is above it.
Rect panelArea(int panel) {
  constexpr int kWidth = (kPictureWidth - 3 * kGap) / 2, kHeight = (kPictureHeight - 3 * kGap) / 2;
  return {kGap + panel % 2 * (kWidth + kGap), kGap + panel / 2 * (kHeight + kGap) + kHeader, kWidth,
          kHeight - kHeader};
}

void drawHeader(Canvas& canvas, const Rect& area, const std::array<std::string, 2>& captions) {
  const double y = area.y - kHeader / 2.0;
  drawText(canvas, captions[0], Vec2(area.x + 4, y), TextAlign::left, 16, kCaption);
  drawText(canvas, captions[1], Vec2(area.right() - 4, y), TextAlign::right, 14, kMuted);
}

//! The mesh in voxel indices and the box around it; around the whole volume if the mesh is empty.
struct IndexMesh {
  std::vector<Vec3> points;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
};

IndexMesh toIndices(const Grid& grid, const TriangleSoup& mesh) {
  IndexMesh result;
  for (const Vec3& p : mesh.points) result.points.push_back(grid.toIndex(p));
  for (const Triangle& t : mesh.triangles)
    for (int v : t) {
      result.low = result.low.cwiseMin(result.points[v]);
      result.high = result.high.cwiseMax(result.points[v]);
    }
  if (mesh.triangles.empty()) {
    result.low = Vec3::Zero();
    result.high = Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  }
  return result;
}

GreyWindow windowOf(const Volume& volume) {
  const std::array percents{0.1, 99.9};
  const std::vector<double> ends = intensityStatistics(volume, percents).percentiles;
  return {ends[0], ends[1]};
}

std::array<SliceView, 3> planAround(const Grid& grid, const IndexMesh& mesh, const PictureOptions& options) {
  const Vec3 point = options.point ? grid.toIndex(*options.point) : Vec3((mesh.low + mesh.high) / 2);
  const auto plan = [&](AnatomicalPlane plane, int panel) {
    return planSlice(grid, plane, point, mesh.low, mesh.high, panelArea(panel));
  };
  return {plan(AnatomicalPlane::axial, 0), plan(AnatomicalPlane::coronal, 1),
          plan(AnatomicalPlane::sagittal, 2)};
}

void drawSlices(Canvas& canvas, const Volume& volume, const TriangleSoup& mesh,
                const PictureOptions& options) {
  const IndexMesh inVoxels = toIndices(volume.grid, mesh);
  const GreyWindow window = windowOf(volume);
  for (const SliceView& view : planAround(volume.grid, inVoxels, options)) {
    canvas.fill(view.area, kPanel);
    drawVoxels(canvas, view, volume, window);
    drawOutline(canvas, view, inVoxels.points, mesh.triangles);
    drawLetters(canvas, view);
    drawScaleBar(canvas, view.area, view.mmPerPixel);
    drawHeader(canvas, view.area, sliceCaptions(view, volume.grid));
  }
}

}  // namespace

std::array<SliceView, 3> planSlices(const Grid& grid, const TriangleSoup& mesh,
                                    const PictureOptions& options) {
  return planAround(grid, toIndices(grid, mesh), options);
}

bool isPicturePath(const std::string& path) { return lowered(path).ends_with(".png"); }

void writePicture(const Volume& volume, const TriangleSoup& mesh, const std::string& path,
                  const PictureOptions& options) {
  if (!isPicturePath(path)) throw UsageError(path + ": unknown extension; a picture is .png.");
  const VtkSilence silence;
  Canvas canvas(kPictureWidth, kPictureHeight, kGround);
  drawSlices(canvas, volume, mesh, options);
  const Rect area = panelArea(3);
  const double mmPerPixel = drawSurface(canvas, area, mesh);
  if (mmPerPixel > 0) drawScaleBar(canvas, area, mmPerPixel);
  drawHeader(
      canvas, area,
      {"Surface from the front, left and above", std::to_string(mesh.triangles.size()) + " triangles"});
  writeTextAtomically(path, pngBytes(canvas));
}

}  // namespace handlebody
