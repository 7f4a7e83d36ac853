#pragma once
// Internal: the grid of a stack of DICOM slices, from their positions. No DICOM library here.

#include <optional>
#include <string>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

struct DicomSlice {
  std::string file;
  int columns = 0;
  int rows = 0;
  std::optional<Vec3> position{};      //!< mm, LPS: centre of the first pixel
  std::optional<Vec3> rowDirection{};  //!< direction in which the column index grows
  std::optional<Vec3> columnDirection{};
  std::optional<Vec3> pixelSpacing{};  //!< mm: x between columns, y between rows
};

//! Largest distance of a slice from its place in the even stack: a tenth of the slice distance, at most this
//! (mm). Scanners round positions to 0.01 … 0.1 mm; a missing slice is off by a whole distance.
inline constexpr double kLargestSliceOffset = 0.1;
//! Largest shift of a slice within its plane against the stack's normal, in pixels. A gantry tilt of 1°
//! passes this within a few slices, rounded direction cosines do not.
inline constexpr double kLargestShift = 0.25;

//! Sorts the slices along their normal and returns their grid (right-handed: row × column is the third axis).
//! Throws InputError (which begins with `path`) for less than two slices, missing geometry, slices of
//! different size or direction, two slices in one place, uneven spacing and a tilted stack.
Grid stackSlices(std::vector<DicomSlice>& slices, const std::string& path);

}  // namespace handlebody
