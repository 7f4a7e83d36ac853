#include "core/io/dicom/dicom_dataset.h"

#include <dcmtk/dcmdata/dcdatset.h>
#include <dcmtk/oflog/oflog.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <ctime>
#include <stdexcept>

#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/lowered.h"
#include "core/told_error.h"

namespace handlebody {

bool isDicomSegmentationPath(const std::string& path) { return lowered(path).ends_with(".seg.dcm"); }
bool isDicomStlPath(const std::string& path) { return lowered(path).ends_with(".stl.dcm"); }

Finding dicomFinding(const DicomOrigin* origin) {
  return origin ? origin->displaced : FindingKind::notFromDicom;
}

std::string dicomFault(const DicomOrigin* origin) { return sentence(dicomFinding(origin)); }

void refuseDicom(const std::string& path, const Finding& fault) {
  throw Told<UsageError>(
      Finding(FindingKind::fileRefused, {{"file", path}}, Finding(FindingKind::noDicomMade, {}, fault)));
}

bool namesImages(const DicomOrigin& origin) {
  return !origin.studyUid.empty() && !origin.seriesUid.empty() && !origin.images.empty() &&
         std::none_of(origin.images.begin(), origin.images.end(),
                      [](const DicomImage& i) { return i.sopClass.empty() || i.instance.empty(); });
}

Finding dicomTextFinding(const std::string& text) {
  constexpr std::size_t kMaxBytes = 64;  // characters, of LO and PN; bytes are never less
  if (text.size() > kMaxBytes) return {FindingKind::dicomTextTooLong, {{"text", text}}};
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\')
      return {FindingKind::dicomTextControl, {{"text", text}}};
  return {};
}

namespace dicom {

namespace {

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c & 0x80) == 0; });
}

//! What a patient and a study must at least have, if empty (type 2).
constexpr std::array<std::uint32_t, 9> kWanted{0x00080020, 0x00080030, 0x00080050, 0x00080090, 0x00100010,
                                               0x00100020, 0x00100030, 0x00100040, 0x00200010};

DcmTagKey key(std::uint32_t number) {
  return {static_cast<Uint16>(number >> 16), static_cast<Uint16>(number & 0xffff)};
}

void put(DcmItem& data, const DcmTagKey& tag, const std::string& value) {
  data.putAndInsertString(tag, value.c_str());
}

//! The values of the source, in UTF-8 if `utf8`.
void addSource(DcmItem& data, const DicomOrigin& origin, bool utf8, const std::string& path) {
  DcmDataset source;
  for (const DicomValue& v : origin.values) put(source, {v.group, v.element}, v.value);
  if (utf8 && source.convertToUTF8().bad())
    throw OutputError(path +
                      ": cannot be written: the character set of the series is not known here, and a name or "
                      "description is not ASCII; give one that is.");
  if (utf8) put(source, DCM_SpecificCharacterSet, "ISO_IR 192");
  while (DcmElement* element = source.remove(0ul)) data.insert(element, true);
}

//! That the images were compressed with loss: it names nobody, and may not get lost.
void addLossyCompression(DcmItem& data, const DicomOrigin& origin) {
  constexpr std::uint16_t kGroup = 0x0028;  // of all that the origin holds of images
  for (const DicomValue& v : origin.values)
    if (v.group == kGroup) put(data, {v.group, v.element}, v.value);
}

std::string now(const char* format) {
  const std::time_t time = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&time, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), format, &local);
  return text.data();
}

std::string bytesOf(DcmDataset& data, const DcmTagKey& tag) {
  const Uint8* bytes = nullptr;
  unsigned long n = 0;
  if (data.findAndGetUint8Array(tag, bytes, &n).bad()) return {};
  return {reinterpret_cast<const char*>(bytes), n};
}

}  // namespace

std::string newUid() {
  std::array<std::uint8_t, 16> uuid{};
  if (RAND_bytes(uuid.data(), static_cast<int>(uuid.size())) != 1)
    throw std::runtime_error("there are no random numbers for a UID.");
  uuid[6] = static_cast<std::uint8_t>((uuid[6] & 0x0f) | 0x40);  // version 4
  uuid[8] = static_cast<std::uint8_t>((uuid[8] & 0x3f) | 0x80);  // of RFC 4122
  std::string digits;                                            // of the number, from its end
  while (std::any_of(uuid.begin(), uuid.end(), [](std::uint8_t b) { return b != 0; })) {
    unsigned rest = 0;
    for (std::uint8_t& byte : uuid) {
      rest = rest << 8 | byte;
      byte = static_cast<std::uint8_t>(rest / 10);
      rest %= 10;
    }
    digits += static_cast<char>('0' + rest);
  }
  std::reverse(digits.begin(), digits.end());
  return "2.25." + digits;
}

std::string decimal(double value) {
  constexpr std::size_t kLongestDecimal = 16;
  std::array<char, 40> text{};
  if (std::abs(value) < 1e-12) value = 0;  // mm, or of a direction: nothing
  auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  for (int digits = 16; end - text.data() > static_cast<std::ptrdiff_t>(kLongestDecimal); --digits)
    end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

void checkExport(const DicomOrigin& origin, const DicomContent& content, const std::string& path) {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);  // errors reach us as conditions
  if (!dcmDataDict.isDictionaryLoaded())
    throw OutputError(path + ": cannot be written: the data dictionary of DCMTK is not there.");
  if (const Finding fault = dicomFinding(&origin); fault.any()) refuseDicom(path, fault);
  for (const std::string& text : {content.creator, content.description})
    if (const Finding fault = dicomTextFinding(text); fault.any()) refuseDicom(path, fault);
}

void addPatientAndStudy(DcmItem& data, const DicomOrigin& origin, const DicomContent& content,
                        const Texts& texts, const std::string& path) {
  const bool utf8 = !std::all_of(texts.begin(), texts.end(), isAscii);
  for (const std::uint32_t tag : kWanted) data.insertEmptyElement(key(tag), true);
  if (content.anonymous) {
    put(data, DCM_PatientIdentityRemoved, "YES");
    put(data, DCM_DeidentificationMethod, "Handlebody: no values of the source");
    if (utf8) put(data, DCM_SpecificCharacterSet, "ISO_IR 192");
    addLossyCompression(data, origin);
  } else {
    addSource(data, origin, utf8, path);
  }
  put(data, DCM_StudyInstanceUID, content.anonymous || origin.studyUid.empty() ? newUid() : origin.studyUid);
}

void addReferencedSeries(DcmItem& data, const DicomOrigin& origin, const DicomContent& content) {
  if (content.anonymous || !namesImages(origin)) return;
  DcmItem* series = nullptr;
  data.findOrCreateSequenceItem(DCM_ReferencedSeriesSequence, series, 0);
  put(*series, DCM_SeriesInstanceUID, origin.seriesUid);
  std::string last;
  for (const DicomImage& image : origin.images) {
    if (image.instance == last) continue;  // another frame of it
    last = image.instance;
    DcmItem* item = nullptr;
    series->findOrCreateSequenceItem(DCM_ReferencedInstanceSequence, item, -2);  // a new one at the end
    put(*item, DCM_ReferencedSOPClassUID, image.sopClass);
    put(*item, DCM_ReferencedSOPInstanceUID, image.instance);
  }
}

void addContentDate(DcmItem& data, const DicomContent& content) {
  put(data, DCM_ContentDate, content.anonymous ? "19000101" : now("%Y%m%d"));
  put(data, DCM_ContentTime, content.anonymous ? "000000" : now("%H%M%S"));
}

void require(const OFCondition& condition, const std::string& path, const char* what) {
  if (condition.bad())
    throw OutputError(path + ": cannot be written: " + what + " (" + condition.text() + ").");
}

void save(DcmDataset& data, const DcmTagKey& tag, const std::string& path) {
  const std::string written = bytesOf(data, tag);
  writeAtomically(path, [&](const std::string& temporary) {
    DcmFileFormat file(&data);
    const bool saved = file.saveFile(temporary.c_str(), EXS_LittleEndianExplicit).good();
    DcmFileFormat back;
    const bool same =
        saved && back.loadFile(temporary.c_str()).good() && bytesOf(*back.getDataset(), tag) == written;
    if (!same) refuseOutput(path, FindingKind::notOnDisk);
  });
}

}  // namespace dicom

void requireDicomNames(const std::vector<std::string>& names, const DicomOrigin& origin,
                       const DicomContent& content, const std::string& path) {
  dicom::checkExport(origin, content, path);
  dicom::Texts texts{content.creator, content.description};
  texts.insert(texts.end(), names.begin(), names.end());
  DcmDataset none;
  dicom::addPatientAndStudy(none, origin, content, texts, path);
}

}  // namespace handlebody
