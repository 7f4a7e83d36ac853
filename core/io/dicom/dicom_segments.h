#pragma once
// What a DICOM Segmentation says of its segments. No library for DICOM.

#include "core/io/formats/file_labels.h"

namespace handlebody {

//! By the numbers of the segments, which are the values of its label map: label, type, recommended colour.
//! `path`: the file, or a folder in which it is the only one that says such. Empty for any other file.
FileLabels readDicomLabels(const std::string& path);

}  // namespace handlebody
