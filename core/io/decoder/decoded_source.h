#pragma once
// Internal: volumes that libraries decode which cannot be trusted with any file or do not stop when asked to
// (GDCM, libtiff), decoded in this process. Only the child process that decodes opens them so.

#include "core/io/dicom/dicom_scan.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {

//! Fills memory of the caller, and says what it does file by file.
class DecodedSource : public VolumeSource {
 public:
  virtual void decode(int frame, void* to, const DicomProgress& progress) = 0;
};

//! The label map of a binary DICOM Segmentation: the number of the segment, 0 outside of all, on the smallest
//! grid that holds its frames. `path` is what the user named. Throws InputError.
SourcePointer openSegmentationHere(const DicomFile& file, const std::string& path);

//! As openDicom and openTiff, here.
SourcePointer openDicomHere(const OpenRequest& request, const DicomProgress& progress, bool* several);
SourcePointer openTiffHere(const OpenRequest& request, const DicomProgress& progress);

}  // namespace handlebody
