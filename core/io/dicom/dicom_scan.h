#pragma once
// Internal: which DICOM images a file or folder holds. Only in the child process that decodes.

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_header.h"
#include "core/io/formats/decoded_source.h"

namespace handlebody {

struct DicomScan {
  std::deque<DicomFile> images{};            //!< by file name; addresses stay
  std::vector<DicomFile> others{};           //!< DICOM without an image: reports, structures, cut off slices
  std::vector<std::string> damaged{};        //!< truncated files of a series that is known
  std::vector<std::string> damagedSeries{};  //!< the series of each
  std::vector<std::string> foreign{};        //!< names of files that are not DICOM
};

//! Reads the headers. Throws InputError if there is no image, and for a truncated file whose series it does
//! not show: it may be a slice of any.
DicomScan scanDicom(const std::string& path, const DecodingProgress& progress);

}  // namespace handlebody
