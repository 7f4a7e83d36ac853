#include "core/io/dicom_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>

#include "core/io/volume_source.h"

namespace handlebody {
namespace {

//! Directions are written with 6 digits or so.
constexpr double kSameDirection = 1e-4;

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
}

void checkEachSlice(const std::vector<DicomSlice>& slices, const std::string& path) {
  const DicomSlice& first = slices.front();
  for (const DicomSlice& s : slices) {
    if (!s.position || !s.rowDirection || !s.columnDirection || !s.pixelSpacing)
      refuseInput(path, "the slice " + s.file +
                            " does not say where it lies (position, orientation or pixel spacing)");
    if (s.pixelSpacing->x() <= 0 || s.pixelSpacing->y() <= 0)
      refuseInput(path, "the slice " + s.file + " has a pixel spacing that is not positive");
    if (s.columns != first.columns || s.rows != first.rows)
      refuseInput(path, "its slices have different sizes");
    if ((*s.rowDirection - *first.rowDirection).norm() > kSameDirection ||
        (*s.columnDirection - *first.columnDirection).norm() > kSameDirection)
      refuseInput(path, "its slices have different orientations");
    if ((*s.pixelSpacing - *first.pixelSpacing).norm() > 1e-4 * first.pixelSpacing->norm())
      refuseInput(path, "its slices have different pixel spacings");
  }
}

//! Slices must lie evenly; places are measured from the first slice along the normal.
void checkEven(const std::vector<double>& places, double spacing, const std::string& path) {
  double nearest = spacing, farthest = spacing, offset = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    offset = std::max(offset, std::abs(places[i] - spacing * static_cast<double>(i)));
    if (i == 0) continue;
    nearest = std::min(nearest, places[i] - places[i - 1]);
    farthest = std::max(farthest, places[i] - places[i - 1]);
  }
  if (nearest < 1e-3)
    refuseInput(
        path,
        "several of its slices lie in the same place (duplicates or time points), which is not supported");
  if (offset > std::min(0.1 * spacing, kLargestSliceOffset))
    refuseInput(path, "its slices are unevenly spaced (" + millimetres(nearest) + " to " +
                          millimetres(farthest) + "), slices may be missing");
}

}  // namespace

Grid stackSlices(std::vector<DicomSlice>& slices, const std::string& path) {
  if (slices.size() < 2)
    refuseInput(path, "this is a single slice, a 2D image; give the folder with the whole series");
  checkEachSlice(slices, path);
  const Vec3 row = slices.front().rowDirection->normalized();
  const Vec3 column = slices.front().columnDirection->normalized();
  const Vec3 normal = row.cross(column);
  std::stable_sort(slices.begin(), slices.end(), [&](const DicomSlice& a, const DicomSlice& b) {
    return a.position->dot(normal) < b.position->dot(normal);
  });
  const Vec3 origin = *slices.front().position;
  std::vector<double> places;
  double shift = 0;
  for (const DicomSlice& s : slices) {
    const Vec3 d = *s.position - origin;
    places.push_back(d.dot(normal));
    shift = std::max(shift, (d - normal * d.dot(normal)).norm());
  }
  const double spacing = places.back() / static_cast<double>(slices.size() - 1);
  if (shift > kLargestShift * std::min(slices.front().pixelSpacing->x(), slices.front().pixelSpacing->y()))
    refuseInput(path, "its stack of slices is tilted (gantry tilt: slices are shifted by up to " +
                          millimetres(shift) + "), which is not supported");
  checkEven(places, spacing, path);
  Grid grid;
  grid.size = {slices.front().columns, slices.front().rows, static_cast<int>(slices.size())};
  grid.spacing = Vec3(slices.front().pixelSpacing->x(), slices.front().pixelSpacing->y(), spacing);
  grid.origin = origin;
  grid.direction.col(0) = row;
  grid.direction.col(1) = column;
  grid.direction.col(2) = normal;
  return grid;
}

}  // namespace handlebody
