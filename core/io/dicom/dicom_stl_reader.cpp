// Encapsulated STL (DICOM Supplement 205), by our own walk over its elements.

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>

#include "core/io/dicom/dicom_elements.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/io/refuse_input.h"
#include "core/io/shown.h"

namespace handlebody {

namespace {

constexpr std::uint32_t kUnitCode = 0x00080100u, kUnits = 0x004008eau, kDocument = 0x00420011u,
                        kMimeType = 0x00420012u;

//! What the data set says of its document.
struct Document {
  std::optional<DicomElement> value{};
  std::string type{};  //!< MIME
  std::string unit{};  //!< UCUM
};

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  refuseInput(path, {FindingKind::decodingFailed, {{"reason", reason}}});
}

[[noreturn]] void refuseAs(const std::string& path, const char* format) {
  refuseInput(path, {FindingKind::notOfFormat, {{"format", std::string(format)}}});
}

std::string bytesOf(const std::string& path) {
  std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(path)), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    refuseInput(path, FindingKind::notReadToEnd);
  return bytes;
}

Document documentIn(const DicomElements& file, const std::string& path) {
  const DicomBeginning beginning = file.beginning();
  if (!beginning.isLittleEndian()) refuse(path, "transfer syntax " + beginning.syntax);
  const bool isExplicit = beginning.isExplicit();
  Document document;
  const auto takeUnit = [&](const DicomElement& e, bool) {
    if (e.tag == kUnitCode) document.unit = file.text(e);
  };
  const auto take = [&](const DicomElement& e) {
    if (e.tag == kDocument) document.value = e;
    if (e.tag == kMimeType) document.type = file.text(e);
    if (e.tag == kUnits) file.forEachItem(e, isExplicit, takeUnit, [] {});
  };
  if (!beginning.whole || !file.forEach(beginning.at, file.size(), isExplicit, take))
    refuseInput(path, FindingKind::dicomDamaged);
  return document;
}

//! Of the units of CID 7063 (PS3.16) and the like; nothing for any other. Not said: as most are.
std::optional<double> millimetresIn(const std::string& unit) {
  static const std::map<std::string, double> kLengths{{"", 1},    {"um", 1e-3}, {"mm", 1},
                                                      {"cm", 10}, {"m", 1e3},   {"[in_i]", 25.4}};
  const auto found = kLengths.find(unit);
  return found == kLengths.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

MeshFile readDicomStl(const std::string& path) {
  const std::string bytes = bytesOf(path);
  if (bytes.size() < kDicomPreamble + 4 || bytes.compare(kDicomPreamble, 4, "DICM") != 0)
    refuseAs(path, "DICOM");
  const DicomElements file(bytes);
  const Document document = documentIn(file, path);
  if (!document.value) refuseAs(path, "DICOM Encapsulated STL");
  if (document.type.empty()) refuse(path, "no MIME type (0042,0012)");
  if (lowered(document.type) != "model/stl") refuse(path, shown(document.type) + ", not model/stl");
  if (!document.value->hasLength()) refuse(path, "the document (0042,0011) is of undefined length");
  const std::optional<double> scale = millimetresIn(document.unit);
  if (!scale) refuse(path, "unit " + shown(document.unit));
  MeshFile stl = readStlBytes(file.value(*document.value), path);
  for (Vec3& p : stl.mesh.points) p *= *scale;
  return stl;
}

}  // namespace handlebody
