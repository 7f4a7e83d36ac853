#include "core/io/dicom/dicom_class.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/io/dicom/dicom_elements.h"
#include "core/io/meshes/mesh_files.h"

namespace handlebody {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kClass = 0x00080016u;
constexpr std::size_t kBeginning = 4096;  // bytes; the class is one of the first elements

}  // namespace

std::string firstBytes(const std::string& path, std::size_t most) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return {};
  const std::uintmax_t size = fs::file_size(path, failed);
  if (failed) return {};
  std::string bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, most)), '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return bytes;
}

//! What the data set says counts; one that nobody can read here (deflated) is known by what stands before it.
std::string dicomClassOf(const std::string& path) {
  const std::string bytes = firstBytes(path, kBeginning);
  if (bytes.size() < kDicomPreamble + 4 || bytes.compare(kDicomPreamble, 4, "DICM") != 0) return {};
  const DicomElements file(bytes);
  const DicomBeginning beginning = file.beginning();
  std::string found = beginning.mediaClass;
  if (beginning.whole && beginning.isLittleEndian())
    file.forEach(beginning.at, file.size(), beginning.isExplicit(), [&](const DicomElement& e) {
      if (e.tag == kClass) found = file.text(e);
    });
  return found;
}

bool isDicomSegmentationFile(const std::string& path) { return dicomClassOf(path) == kSegmentationClass; }

bool isEncapsulatedStlFile(const std::string& path) { return dicomClassOf(path) == kEncapsulatedStlClass; }

}  // namespace handlebody
