#pragma once
// Internal: DICOM as a volume, decoded in this process. Only the child process that decodes opens it so.

#include "core/io/dicom_scan.h"
#include "core/io/volume_source.h"

namespace handlebody {

//! As openDicom, here.
SourcePointer openDicomHere(const OpenRequest& request, const DicomProgress& progress, bool* several);

//! A DICOM source can fill memory of the caller, and says what it does file by file.
class DicomSource : public VolumeSource {
 public:
  virtual void decode(int frame, void* to, const DicomProgress& progress) = 0;
};

}  // namespace handlebody
