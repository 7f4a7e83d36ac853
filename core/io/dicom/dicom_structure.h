#pragma once
// Internal: is a DICOM file whole? GDCM accepts truncated pixel data in silence and its Debian build aborts
// the process on some broken headers, so every file is walked, bounds checked, before GDCM sees it.

#include <cstdint>
#include <string>

namespace handlebody {

struct DicomStructure {
  bool whole = true;              //!< every element up to the end of the pixel data lies within the file
  bool walked = true;             //!< false: deflated or big-endian, not looked into
  std::uint64_t fileBytes = 0;    //!< size of the file
  std::uint64_t pixelOffset = 0;  //!< where the value of the pixel data begins; 0 if there is none
  std::uint64_t pixelBytes = 0;   //!< of uncompressed pixel data that are there; 0 if none or compressed
  std::uint64_t pixelEnd = 0;     //!< first byte after the pixel data
  std::string seriesUid{};        //!< as far as it was seen
};

//! Throws InputError if the file cannot be opened.
DicomStructure walkDicom(const std::string& path);

}  // namespace handlebody
