// What a series says about patient and study, for files that are made from it.

#include <gdcmReader.h>

#include <array>

#include "core/io/dicom/dicom_header.h"
#include "core/io/dicom/dicom_values.h"

namespace handlebody {
namespace {

using gdcm::Tag;

//! The patient, study and patient study modules (PS3.3 C.7.1.1, C.7.2.1, C.7.2.2), what says that they were
//! made anonymous or compressed with loss, and the character set that all of it is in.
constexpr std::array<std::uint32_t, 26> kTaken{
    0x00080005, 0x00080020, 0x00080030, 0x00080050, 0x00080090, 0x00081030, 0x00100010,
    0x00100020, 0x00100021, 0x00100030, 0x00100032, 0x00100040, 0x00101010, 0x00101020,
    0x00101030, 0x00102201, 0x00102203, 0x00102292, 0x00102297, 0x00120062, 0x00120063,
    0x00200010, 0x00201040, 0x00282110, 0x00282112, 0x00282114};

}  // namespace

DicomOrigin readDicomOrigin(const std::string& file) {
  DicomOrigin origin;
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.ReadUpToTag(Tag(0x7fe0, 0x0010))) return origin;
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  for (const std::uint32_t number : kTaken) {
    const Tag tag(number);
    if (std::string value = dicom::text(data, tag); !value.empty())
      origin.values.push_back({tag.GetGroup(), tag.GetElement(), std::move(value)});
  }
  origin.studyUid = dicom::text(data, {0x0020, 0x000d});
  origin.seriesUid = dicom::text(data, {0x0020, 0x000e});
  origin.frameOfReference = dicom::text(data, {0x0020, 0x0052});
  return origin;
}

}  // namespace handlebody
