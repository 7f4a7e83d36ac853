#pragma once
// What a DICOM file is, by a look at its beginning, whatever its name: those of a PACS have any, or no
// ending. No library for DICOM.

#include <cstddef>
#include <string>

namespace handlebody {

inline constexpr const char* kSegmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
inline constexpr const char* kEncapsulatedStlClass = "1.2.840.10008.5.1.4.1.1.104.3";

//! `most` bytes, or all of a shorter file. None of what is no regular file (a folder, a pipe, nothing at all)
//! or cannot be read.
std::string firstBytes(const std::string& path, std::size_t most);

//! The UID of the SOP class, by the first few kB. Empty for what is no DICOM file with a preamble, and for
//! all that firstBytes reads nothing of.
std::string dicomClassOf(const std::string& path);

//! True for a file that is there and whose class is that of a DICOM Segmentation; false for a folder of them.
bool isDicomSegmentationFile(const std::string& path);

}  // namespace handlebody
