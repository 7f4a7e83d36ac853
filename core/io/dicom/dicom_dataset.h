#pragma once
// Internal: what DICOM files that we write have in common, with DCMTK. Only the DICOM writers include this.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <string>
#include <vector>

#include "core/io/dicom/dicom_writer.h"

namespace handlebody::dicom {

//! A new UID: a random UUID under 2.25 (PS3.5 B.2), so that it says nothing about machine or time.
std::string newUid();

//! A decimal string (DS) of at most 16 characters, with as many digits as fit.
std::string decimal(double value);

//! Refuses an origin with a fault, and content with texts that DICOM cannot hold. Throws UsageError.
void checkExport(const DicomOrigin& origin, const DicomContent& content, const std::string& path);

//! Our own texts in the file, as UTF-8: they decide on its character set.
using Texts = std::vector<std::string>;

//! Patient and study of the source as they stand there, in UTF-8 if our texts need it; emptied if anonymous.
//! What PS3.3 wants is there, empty if the source has none. Throws OutputError.
void addPatientAndStudy(DcmItem& data, const DicomOrigin& origin, const DicomContent& content,
                        const Texts& texts, const std::string& path);

//! The name of this program, as manufacturer and model.
inline constexpr const char* kMaker = "Handlebody";
//! SeriesNumber, which is required: behind those of a scanner.
inline constexpr const char* kSeriesNumber = "1000";

//! Instances of the series that the content comes from (ReferencedSeriesSequence); nothing if anonymous.
void addReferencedSeries(DcmItem& data, const DicomOrigin& origin, const DicomContent& content);

//! Content date and time: now, or of 1900 if anonymous.
void addContentDate(DcmItem& data, const DicomContent& content);

//! Throws OutputError if a step of the library failed.
void require(const OFCondition& condition, const std::string& path, const char* what);

//! Writes explicit little-endian, whole or not at all, and reads it back: `tag` must hold the same bytes.
void save(DcmDataset& data, const DcmTagKey& tag, const std::string& path);

}  // namespace handlebody::dicom
