#pragma once
// Internal: DICOM decoded in this process. Only the child process that decodes opens it so.

#include "core/io/dicom/dicom_scan.h"
#include "core/io/formats/decoded_source.h"

namespace handlebody {

//! As openDicom, here.
SourcePointer openDicomHere(const OpenRequest& request, const DecodingProgress& progress);

//! The label map of a binary DICOM Segmentation: the number of the segment, 0 outside of all, on the smallest
//! grid that holds its frames. `path` is what the user named. Throws InputError.
SourcePointer openSegmentationHere(const DicomFile& file, const std::string& path);

}  // namespace handlebody
