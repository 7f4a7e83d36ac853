#include "app/picture/picture_slice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/mesh/plane_section.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {
namespace {

const Colour kOutline(1.0F, 0.72F, 0.10F);
const Colour kLetter(0.92F, 0.94F, 0.96F);

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Vec2 SliceView::toPicture(const Vec3& index) const {
  const Vec3 mm = (index - centre).cwiseProduct(spacing) / mmPerPixel;
  return area.centre() + Vec2(acrossSign * mm[across], downSign * mm[down]);
}

Vec3 SliceView::toIndex(const Vec2& pixel) const {
  const Vec2 mm = (pixel - area.centre()) * mmPerPixel;
  Vec3 index = centre;
  index[across] += acrossSign * mm.x() / spacing[across];
  index[down] += downSign * mm.y() / spacing[down];
  return index;
}

namespace {

//! A slice between two rows of voxels is a mixture: the nearest row shows what was measured.
double slicePosition(const Grid& grid, int axis, double wanted, double low, double high) {
  const double last = grid.size[at(axis)] - 1;
  const double inside = std::clamp(wanted, 0.0, last);
  const double row = std::round(inside);
  return (row > low && row < high) || low > high ? row : inside;
}

//! Millimetres per pixel, and the middle of what is shown, within the volume if it is larger than the area.
void fit(SliceView& view, const Grid& grid, const Vec3& low, const Vec3& high) {
  constexpr double kTimesExtent = 2.5, kFewestVoxels = 48;
  constexpr double kRim = 1.05;  // an outline on the volume's border must be seen
  const double fewest = kFewestVoxels * std::min(view.spacing[view.across], view.spacing[view.down]);
  double wanted = 0, whole = 0;
  for (const auto& [axis, pixels] :
       {std::pair(view.across, view.area.width), {view.down, view.area.height}}) {
    const double extent = kTimesExtent * (high[axis] - low[axis]) * view.spacing[axis];
    wanted = std::max(wanted, std::max(extent, fewest) / pixels);
    whole = std::max(whole, kRim * grid.size[at(axis)] * view.spacing[axis] / pixels);
  }
  view.mmPerPixel = std::min(wanted, whole);
  for (const auto& [axis, pixels] :
       {std::pair(view.across, view.area.width), {view.down, view.area.height}}) {
    const double size = grid.size[at(axis)], half = pixels * view.mmPerPixel / view.spacing[axis] / 2;
    view.centre[axis] =
        2 * half >= size ? (size - 1) / 2 : std::clamp(view.centre[axis], half - 0.5, size - 0.5 - half);
  }
}

}  // namespace

SliceView planSlice(const Grid& grid, AnatomicalPlane plane, const Vec3& point, const Vec3& low,
                    const Vec3& high, const Rect& area) {
  SliceView view;
  static_cast<SliceAxes&>(view) = sliceAxes(grid, plane);
  view.plane = plane;
  view.area = area;
  view.spacing = grid.spacing;
  view.centre = (low + high) / 2;
  view.centre[view.normal] =
      slicePosition(grid, view.normal, point[view.normal], low[view.normal], high[view.normal]);
  fit(view, grid, low, high);
  return view;
}

namespace {

//! Mean over a pixel: where pixels are larger than voxels, one sample would flicker.
template <typename T>
double pixelValue(const T* voxels, const Grid& grid, const SliceView& view, int x, int y, int samples) {
  double sum = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      sum +=
          trilinear(voxels, grid.size, view.toIndex(Vec2(x + (i + 0.5) / samples, y + (j + 0.5) / samples)));
  return sum / (samples * samples);
}

}  // namespace

void drawVoxels(Canvas& canvas, const SliceView& view, const Volume& volume, const GreyWindow& window) {
  const Grid& grid = volume.grid;
  const double finest = std::min(view.spacing[view.across], view.spacing[view.down]);
  const int samples = static_cast<int>(std::clamp(std::ceil(view.mmPerPixel / finest), 1.0, 4.0));
  const double range = window.white - window.black;
  visitVoxels(volume, [&](const auto* voxels) {
    for (int y = view.area.y; y < view.area.bottom(); ++y)
      for (int x = view.area.x; x < view.area.right(); ++x) {
        if (!grid.contains(view.toIndex(Vec2(x + 0.5, y + 0.5)))) continue;
        const double value = pixelValue(voxels, grid, view, x, y, samples);
        const double grey = range > 0 ? std::clamp((value - window.black) / range, 0.0, 1.0) : 0.5;
        canvas.at(x, y) = Colour::Constant(static_cast<float>(grey));
      }
  });
}

void drawOutline(Canvas& canvas, const SliceView& view, const std::vector<Vec3>& points,
                 const std::vector<Triangle>& triangles) {
  constexpr double kThickness = 2;
  LineDrawing lines(view.area, kThickness), shadow(view.area, kThickness + 2);
  std::vector<std::array<Vec3, 2>> section;
  planeSection(points, triangles, Vec3::Unit(view.normal), view.centre[view.normal], section);
  for (const auto& [from, to] : section) {
    lines.add(view.toPicture(from), view.toPicture(to));
    shadow.add(view.toPicture(from), view.toPicture(to));
  }
  shadow.paint(canvas, Colour::Zero(), 0.3);
  lines.paint(canvas, kOutline);
}

void drawLetters(Canvas& canvas, const SliceView& view) {
  constexpr double kInset = 16;
  constexpr int kSize = 17;
  const Rect& a = view.area;
  const Vec2 c = a.centre();
  const auto letter = [&](char text, double x, double y) {
    drawText(canvas, std::string(1, text), Vec2(x, y), TextAlign::centre, kSize, kLetter, TextWeight::bold);
  };
  letter(view.left, a.x + kInset, c.y());
  letter(view.right, a.right() - kInset, c.y());
  letter(view.top, c.x(), a.y + kInset);
  letter(view.bottom, c.x(), a.bottom() - kInset);
}

std::array<std::string, 2> sliceCaptions(const SliceView& view, const Grid& grid) {
  const Vec3 world = grid.toWorld(view.centre);
  const auto place = [&](int w) { return anatomicalPlace(w, world[w]); };
  std::string where = anatomicalName(view.plane);
  if (isOblique(grid))  // no one number says where it lies: the point at its middle does
    where += ", oblique, centre " + place(0) + "  " + place(1) + "  " + place(2) + " mm";
  else
    where += "  " + place(static_cast<int>(view.plane)) + " mm";
  char slice[64];
  std::snprintf(slice, sizeof slice, "slice %.5g of %d", view.centre[view.normal] + 1,
                grid.size[at(view.normal)]);
  return {where, slice};
}

}  // namespace handlebody
