#include "core/io/dicom/dicom_structure.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string_view>

#include "core/io/dicom/dicom_elements.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

constexpr std::uint32_t kPixelData = 0x7fe00010u, kSeriesUid = 0x0020000eu;

//! The bytes of a file, mapped.
class Mapped {
 public:
  explicit Mapped(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (file < 0 || ::fstat(file, &status) != 0) {
      if (file >= 0) ::close(file);
      refuseInput(path, FindingKind::notOpened);
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
    void* memory = size_ > 0 ? ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
    ::close(file);
    if (memory == MAP_FAILED) refuseInput(path, FindingKind::cannotBeRead);
    bytes_ = static_cast<const unsigned char*>(memory);
  }
  ~Mapped() { ::munmap(const_cast<unsigned char*>(bytes_), size_); }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;
  std::string_view bytes() const {
    return {reinterpret_cast<const char*>(bytes_), static_cast<std::size_t>(size_)};
  }

 private:
  const unsigned char* bytes_ = nullptr;
  std::uint64_t size_ = 0;
};

bool walkData(const DicomElements& file, const DicomBeginning& beginning, DicomStructure& result) {
  const bool isExplicit = beginning.isExplicit();
  DicomElement e;
  for (std::uint64_t at = beginning.at; at < file.size();) {
    if (!file.read(at, isExplicit, e)) return false;
    if (e.tag == kPixelData && e.hasLength() && e.data + e.length > file.size()) {
      result.pixelOffset = e.data;
      result.pixelBytes = file.size() - e.data;
      result.pixelEnd = file.size();
      return false;
    }
    if (!file.skip(e, at, isExplicit)) return false;
    if (e.tag == kSeriesUid && e.length <= 64) result.seriesUid = file.text(e);
    if (e.tag != kPixelData) continue;
    // What follows (padding, garbage) does not matter.
    result.pixelOffset = e.data;
    result.pixelEnd = at;
    if (e.hasLength()) result.pixelBytes = e.length;
    return true;
  }
  return true;
}

}  // namespace

DicomStructure walkDicom(const std::string& path) {
  const Mapped mapped(path);
  const DicomElements file(mapped.bytes());
  const DicomBeginning beginning = file.beginning();
  DicomStructure result;
  result.fileBytes = file.size();
  result.whole = beginning.whole;
  result.walked = beginning.isLittleEndian();
  if (result.whole && result.walked) result.whole = walkData(file, beginning, result);
  return result;
}

}  // namespace handlebody
