#pragma once
// What DICOM files that are made from a series take over from it. No DICOM library here.

#include <cstdint>
#include <string>
#include <vector>

#include "core/finding.h"

namespace handlebody {

//! The value of an attribute as it stands in the file, without padding, in the file's own character set.
struct DicomValue {
  std::uint16_t group = 0, element = 0;
  std::string value;
};

//! An image of the series: an instance, or a frame of one.
struct DicomImage {
  std::string sopClass, instance;
  int frame = 0;  //!< from 1; 0 for an instance of one frame
};

//! The series that a volume was read from.
struct DicomOrigin {
  std::vector<DicomValue> values{};  //!< of patient and study, and the character set; none that is empty
  std::string studyUid{}, seriesUid{};
  std::string frameOfReference{};    //!< UID; empty if the series has none
  std::vector<DicomImage> images{};  //!< of the time point that was read, in the order of space
  //! Image i is slice i of the volume; else the volume was resampled from the images.
  bool straight = true;
  //! Empty if the volume's geometry is that of the patient, as the header gives it; else what it is, as the
  //! end of a sentence.
  FindingKind displaced = FindingKind::none;
};

}  // namespace handlebody
