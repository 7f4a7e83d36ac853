#pragma once
// Internal: 3D echocardiography that Philips QLAB exports as "Cartesian": one file with the volumes of a
// cycle, whose depth stands in private elements. NumberOfFrames counts volumes; the pixels of each are its
// slices, one behind the other.

#include <string>

#include "core/io/dicom/dicom_header.h"

namespace gdcm {
class DataSet;
}

namespace handlebody {

//! Where `data` is such a file, gives each slice of each volume its place, and sets `echo` of the file, whose
//! frames are slices from then on. The axes are those that ITK-SNAP gives them: columns run to the right,
//! rows to the back, slices downwards; the file does not say.
void readCartesianEcho(const gdcm::DataSet& data, DicomFile& file);

//! A file that breaks off keeps the volumes that are whole. False if none is, or if it is no such file.
//! Precondition: the structure of the file is known.
bool keepWholeVolumes(DicomFile& file);

//! What a user must know of it; none if nothing is missing.
Finding missingVolumes(const DicomFile& file);

}  // namespace handlebody
