#pragma once
// Internal: the pixels of DICOM files, decoded frame by frame. Only in the child process that decodes.

#include <memory>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_header.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {

//! The values of one frame as they are stored, one per pixel: colour and palettes as luminance.
struct StoredFrame {
  Component type = Component::uint8;
  std::vector<char> bytes;
};

class DicomPixels {
 public:
  virtual ~DicomPixels() = default;
  virtual void read(int frame, StoredFrame& to) = 0;
};

//! True if they are not compressed.
bool hasPlainPixels(const DicomFile& file);
//! Checks that the file can hold what its header declares. Throws InputError that begins with `path`.
void checkDicomPixels(const DicomFile& file, const std::string& path);
//! Plain pixels are read by us, compressed ones by GDCM. Throws InputError.
std::unique_ptr<DicomPixels> openDicomPixels(const DicomFile& file, const std::string& path);

//! True for colour and palettes.
bool isColour(const DicomFile& file);
//! The smallest type that holds every value of these frames after rescaling; float32 holds the values of up
//! to 16 bits exactly.
Component dicomValueType(const std::vector<const DicomFile*>& files);
//! value = slope · stored + intercept, as `type`; false if a value does not fit (the header was wrong).
bool scaleDicomFrame(const StoredFrame& stored, double slope, double intercept, Component type, void* to);

}  // namespace handlebody
