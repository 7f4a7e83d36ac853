#pragma once
// DICOM files made of objects: segmentations and encapsulated meshes that belong to the patient and study of
// the series that the volume was read from. No DICOM library here.

#include <string>
#include <vector>

#include "core/io/formats/dicom_origin.h"
#include "core/io/meshes/exported_object.h"
#include "core/volume/volume.h"

namespace handlebody {

//! What the user says about the content; empty fields stay empty.
struct DicomContent {
  std::string creator{};      //!< ContentCreatorName, as DICOM writes names: Family^Given
  std::string description{};  //!< ContentDescription
  //! Nothing of the source that names: no patient, study, dates or references, new UIDs, dates of 1900.
  bool anonymous = false;
};

//! True for .seg.dcm (any case).
bool isDicomSegmentationPath(const std::string& path);
//! True for .stl.dcm (any case).
bool isDicomStlPath(const std::string& path);

//! Empty if DICOM files can be made from a volume of this origin (nullptr: it was not read from DICOM); else
//! why not, as the end of a sentence.
std::string dicomFault(const DicomOrigin* origin);
//! The same as a finding; none if they can be made.
Finding dicomFinding(const DicomOrigin* origin);
//! Throws UsageError: "path: no DICOM file can be made: …"
[[noreturn]] void refuseDicom(const std::string& path, const Finding& fault);

//! True if the series and its images have UIDs by which they can be referred to; those of some series that
//! were made anonymous are empty. A file made from such a series gets a new study UID and no references.
bool namesImages(const DicomOrigin& origin);

//! None if `text` can stand in a DICOM field of 64 characters; else why not, without a full stop.
Finding dicomTextFinding(const std::string& text);

//! Before the work: throws as the writing does if objects of such names cannot be in a file of this origin,
//! UsageError for what `origin` or `content` is, OutputError if a name is not ASCII and the character set of
//! the source is not known.
void requireDicomNames(const std::vector<std::string>& names, const DicomOrigin& origin,
                       const DicomContent& content, const std::string& path);

//! Writes the label map of the objects as a binary DICOM Segmentation (PS3.3 A.51): a segment per object,
//! numbered from 1 in the order of their label values, with a frame for every slice between its first and
//! last. Each frame refers to its source image unless the volume was resampled. Whole or not at all, read
//! back and compared. Throws OutputError that begins with `path`; UsageError for an origin with a fault.
void writeDicomSegmentation(const Volume& labels, const std::vector<ExportedObject>& objects,
                            const DicomOrigin& origin, const DicomContent& content, const std::string& path);

//! Writes the meshes of the objects as one binary STL within DICOM (Encapsulated STL, PS3.3 A.85.1), in mm
//! LPS. As writeDicomSegmentation otherwise.
void writeDicomStl(const std::vector<ExportedObject>& objects, const DicomOrigin& origin,
                   const DicomContent& content, const std::string& path);

}  // namespace handlebody
