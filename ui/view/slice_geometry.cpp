#include "ui/view/slice_geometry.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/model/translate.h"
#include "ui/view/length_decimals.h"

namespace handlebody::ui {
namespace {

constexpr double kRoomAround = 1.04;               // of the slice's extent: its border is seen
constexpr double kNearest = 0.02, kFarthest = 10;  // voxel edges per pixel

double sizeOf(const Grid& grid, int axis) { return grid.size[axis]; }

}  // namespace

SliceGeometry::SliceGeometry(const Grid& grid, Plane plane, const QSizeF& size)
    : grid_(grid), plane_(plane), axes_(sliceAxes(grid, plane)), size_(size) {
  slice_ = slices() / 2;
  fit();
}

int SliceGeometry::nearestSlice(const Vec3& world) const {
  const double index = grid_.toIndex(world)[axes_.normal];
  return static_cast<int>(std::lround(std::clamp(index, 0.0, slices() - 1.0)));
}

void SliceGeometry::setSlice(int slice) {
  slice_ = std::clamp(slice, 0, std::max(0, slices() - 1));
  centre_[axes_.normal] = slice_;
}

int SliceGeometry::forward() const {
  const int world = static_cast<int>(plane_);
  const double growing = grid_.direction(world, axes_.normal);  // towards L, P or S
  const bool forwards = world == 2 ? growing >= 0 : growing < 0;
  return forwards ? 1 : -1;
}

void SliceGeometry::resize(const QSizeF& size) {
  size_ = size;
  if (fitted_) fit();
}

//! mm per pixel
double SliceGeometry::fittedScale() const {
  const double width = sizeOf(grid_, axes_.across) * grid_.spacing[axes_.across];
  const double height = sizeOf(grid_, axes_.down) * grid_.spacing[axes_.down];
  return kRoomAround *
         std::max({width / std::max(1.0, size_.width()), height / std::max(1.0, size_.height()), 1e-9});
}

void SliceGeometry::fit() {
  mmPerPixel_ = fittedScale();
  for (int a = 0; a < 3; ++a) centre_[a] = (sizeOf(grid_, a) - 1) / 2;
  centre_[axes_.normal] = slice_;
  fitted_ = true;
}

void SliceGeometry::zoom(double factor, const QPointF& fixed) {
  const double voxel = std::min(grid_.spacing[axes_.across], grid_.spacing[axes_.down]);
  const Vec3 before = toIndex(fixed);
  const double fitted = fittedScale();
  mmPerPixel_ = std::clamp(mmPerPixel_ / factor, std::min(kNearest * voxel, fitted),
                           std::max(kFarthest * voxel, fitted));
  fitted_ = false;
  centre_ += before - toIndex(fixed);
}

void SliceGeometry::pan(const QPointF& pixels) {
  centre_ += toIndex(QPointF(0, 0)) - toIndex(pixels);
  fitted_ = false;
}

QPointF SliceGeometry::toScreen(const Vec3& index) const {
  const Vec3 pixels = (index - centre_).cwiseProduct(grid_.spacing) / mmPerPixel_;
  return {size_.width() / 2 + axes_.acrossSign * pixels[axes_.across],
          size_.height() / 2 + axes_.downSign * pixels[axes_.down]};
}

Vec3 SliceGeometry::toIndex(const QPointF& pixel) const {
  Vec3 index = centre_;
  index[axes_.across] +=
      axes_.acrossSign * (pixel.x() - size_.width() / 2) * mmPerPixel_ / grid_.spacing[axes_.across];
  index[axes_.down] +=
      axes_.downSign * (pixel.y() - size_.height() / 2) * mmPerPixel_ / grid_.spacing[axes_.down];
  return index;
}

double SliceGeometry::distance(const Vec3& world) const {
  return (grid_.toIndex(world)[axes_.normal] - slice_) * grid_.spacing[axes_.normal];
}

Vec3 SliceGeometry::clamped(const Vec3& index) const {
  Vec3 inside;
  for (int a = 0; a < 3; ++a) inside[a] = std::clamp(index[a], 0.0, std::max(0.0, sizeOf(grid_, a) - 1));
  return inside;
}

SliceGeometry wholeSlice(const Grid& grid, Plane plane, double longest) {
  SliceGeometry geometry(grid, plane, {1, 1});
  const double width = sizeOf(grid, geometry.axes().across) * grid.spacing[geometry.axes().across];
  const double height = sizeOf(grid, geometry.axes().down) * grid.spacing[geometry.axes().down];
  const double pixels = std::min(longest, std::max(width, height) / grid.spacing.minCoeff());
  const double perMm = pixels / std::max(width, height);
  const QSizeF size(std::max(1.0, std::round(perMm * width)), std::max(1.0, std::round(perMm * height)));
  geometry.resize(size);
  // The larger side decides; rounding leaves at most half a pixel of the other one out.
  geometry.mmPerPixel_ = std::min(width / size.width(), height / size.height());
  geometry.fitted_ = false;
  return geometry;
}

QStringList slicePlace(const SliceGeometry& geometry, Plane plane, const Vec3& crosshair) {
  const int decimals = placeDecimals(geometry.grid());
  const auto place = [decimals](int w, double mm) {  // "R 12.5", in the user's locale
    return QStringLiteral("%1 %2").arg(QString(QLatin1Char(anatomicalLetter(w, mm >= 0))),
                                       QLocale().toString(std::abs(mm), 'f', decimals));
  };
  const QString number = tr("Slice %1 of %2").arg(geometry.slice() + 1).arg(geometry.slices());
  if (isOblique(geometry.grid()))
    return {number,
            tr("%1  %2  %3 mm").arg(place(0, crosshair[0]), place(1, crosshair[1]), place(2, crosshair[2]))};
  Vec3 index = geometry.grid().toIndex(crosshair);
  index[geometry.axes().normal] = geometry.slice();
  const int world = static_cast<int>(plane);
  return {tr("%1, %2 mm").arg(number, place(world, geometry.grid().toWorld(index)[world]))};
}

}  // namespace handlebody::ui
