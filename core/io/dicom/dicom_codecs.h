#pragma once
// Internal: the two ways to the pixels of a DICOM file; see dicom_pixels.h.

#include "core/io/dicom/dicom_pixels.h"

namespace handlebody {

//! Plain little-endian pixels, read straight from where they lie in the file.
std::unique_ptr<DicomPixels> openPlainPixels(const DicomFile& file, const std::string& path);
//! Everything else, through GDCM: JPEG, JPEG-LS, JPEG 2000, RLE, deflated, big-endian.
std::unique_ptr<DicomPixels> openCompressedPixels(const DicomFile& file, const std::string& path);

//! Moves the stored bits of each value to the low end and extends the sign; other bits may hold overlays.
void cleanBits(const DicomFile& file, StoredFrame& frame);
//! Three samples per pixel, one after another or in planes, to their luminance. `rgb`: else the first sample
//! is it already (YBR).
void toLuminance(StoredFrame& frame, bool planar, bool rgb);
//! The type of stored values of 8, 16 or 32 bits.
Component storedType(int bits, bool isSigned);

}  // namespace handlebody
