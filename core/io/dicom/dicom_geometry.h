#pragma once
// Internal: the grid of a stack of DICOM slices, from their positions. No DICOM library here.

#include <functional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_header.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {

//! One image of one place: a file of a series, or a frame of a multi-frame file.
struct DicomSlice {
  const DicomFile* file = nullptr;
  int frame = 0;

  const DicomPlace& place() const { return file->places[frame]; }
};

//! Where a slice of the input lies in the grid of the volume.
struct SlicePlace {
  double along = 0;     //!< mm from the first slice, along the normal
  double x = 0, y = 0;  //!< index in the grid of its first pixel
};

struct DicomStack {
  Grid grid;
  int frames = 1;                  //!< time points
  std::vector<DicomSlice> slices;  //!< of the first time point in the order of space, then of the next …
  std::vector<SlicePlace> places;  //!< one per slice of one time point
  bool straight = true;            //!< the slices are the grid's; else they are to be resampled
  std::string distanceSource;      //!< of the distance between slices
  std::vector<Finding> warnings;

  std::size_t slicesPerFrame() const { return places.size(); }
};

//! Directions are written with 6 digits or so.
inline constexpr double kSameDirection = 1e-4;
//! mm; positions are written with more digits than that.
inline constexpr double kSamePlace = 1e-3;
//! Relative; pixel spacings are written with 5 digits or more.
inline constexpr double kSamePixelSpacing = 1e-4;
//! Largest distance of a slice from its place in the even stack: a tenth of the slice distance, at most this
//! (mm). Scanners round positions to 0.01 … 0.1 mm; a missing slice is off by a whole distance.
inline constexpr double kLargestSliceOffset = 0.1;
//! Largest shift of a slice within its plane against the stack's normal, in pixels. A gantry tilt of 1°
//! passes this within a few slices, rounded direction cosines do not.
inline constexpr double kLargestShift = 0.25;

//! True if two slices hold the same intensities.
using SamePixels = std::function<bool(const DicomSlice&, const DicomSlice&)>;

//! Sorts the slices along their normal and finds their grid (right-handed: row × column is the third axis).
//! Copies of a slice are left out (by equal pixels if equally many are left in every place); several slices
//! in every place are time points, in the order of their temporal position, acquisition, time (where all
//! slices have one) and number. A tilted stack gets a straight grid that holds all of it, an uneven one the
//! median distance or the smallest above half of it; warnings say so. Throws InputError (which begins with
//! `path`) for less than two slices, missing geometry, slices of different size or direction, and time points
//! that are not complete or do not lie in one place.
DicomStack stackSlices(std::vector<DicomSlice> slices, const std::string& path, UnevenSlices uneven,
                       const SamePixels& same);

}  // namespace handlebody
