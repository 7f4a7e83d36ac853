#pragma once
// Internal: which volumes the images of a folder may be: its series, and the stacks within a series that are
// no one volume together. No DICOM library here.

#include <string>
#include <vector>

#include "core/io/dicom/dicom_geometry.h"
#include "core/io/dicom/dicom_scan.h"

namespace handlebody {

//! A series, or one of several stacks in it.
struct DicomSeries {
  std::string uid;    //!< SeriesInstanceUID
  std::string name;   //!< what chooses it: the UID, or UID#1, UID#2 … for stacks of one series
  bool part = false;  //!< its series can be opened as a whole, too, as the entry named by the UID alone
  std::vector<DicomFile*> files;   //!< in the order of their names
  std::vector<DicomSlice> slices;  //!< all frames of the files, or those that are of this stack
  int number = 0;                  //!< the stack's; 0 for a series as a whole
};

//! By UID, then in the order in which the stacks were made. Stacks are told apart by image size, colour,
//! orientation, pixel spacing, and, where the slices together are neither evenly spaced nor whole time
//! points in one place, by acquisition and pitch. Stacks of different pitch one behind the other are one
//! volume, too (it comes first, its stacks are `part`), those that overlap are not. Files with several frames
//! that do not say where they lie stand alone.
std::vector<DicomSeries> seriesOf(DicomScan& scan);

//! True if two slices hold the same bytes of pixels, and the header neither puts them at different times nor
//! scales them differently.
bool sameImage(const DicomSlice& a, const DicomSlice& b);

}  // namespace handlebody
