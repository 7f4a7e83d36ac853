#include "core/io/dicom/dicom_structure.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <string_view>

#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

constexpr std::uint32_t kUndefined = 0xffffffffu, kItem = 0xfffee000u, kItemEnd = 0xfffee00du,
                        kSequenceEnd = 0xfffee0ddu, kPixelData = 0x7fe00010u, kTransferSyntax = 0x00020010u,
                        kSeriesUid = 0x0020000eu;
constexpr int kDeepest = 32;  // sequences within sequences; real files have a handful

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
  std::uint64_t size() const { return size_; }
  std::uint32_t u16(std::uint64_t at) const {
    return static_cast<std::uint32_t>(bytes_[at] | bytes_[at + 1] << 8);
  }
  std::uint32_t u32(std::uint64_t at) const { return u16(at) | u16(at + 2) << 16; }
  std::string_view text(std::uint64_t at, std::uint64_t n) const {
    return {reinterpret_cast<const char*>(bytes_) + at, static_cast<std::size_t>(n)};
  }

 private:
  const unsigned char* bytes_ = nullptr;
  std::uint64_t size_ = 0;
};

//! UIDs are padded to even lengths.
std::string trimmedUid(std::string_view text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.remove_suffix(1);
  return std::string(text);
}

struct Element {
  std::uint32_t tag = 0, length = 0;
  std::uint64_t data = 0;  // where its value begins
  bool unknown = false;    // VR UN: what it holds is implicit
};

class Walker {
 public:
  explicit Walker(const Mapped& file) : file_(file) {}
  DicomStructure walk();

 private:
  bool read(std::uint64_t at, bool explicitVr, Element& element) const;
  bool skipSequence(std::uint64_t& at, bool explicitVr, int depth) const;
  bool skipItem(std::uint64_t& at, bool explicitVr, int depth) const;
  bool skipValue(const Element& element, std::uint64_t& at, bool explicitVr, int depth) const;
  bool walkMeta(std::uint64_t& at, std::string& syntax) const;
  bool walkData(std::uint64_t at, bool explicitVr, DicomStructure& result) const;
  const Mapped& file_;
};

bool Walker::read(std::uint64_t at, bool explicitVr, Element& e) const {
  if (at + 8 > file_.size()) return false;
  e.tag = file_.u16(at) << 16 | file_.u16(at + 2);
  const std::string_view vr = file_.text(at + 4, 2);
  const auto letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  const bool delimiter = e.tag >> 16 == 0xfffe;
  if (!explicitVr || delimiter || !letter(vr[0]) || !letter(vr[1])) {
    e = {e.tag, file_.u32(at + 4), at + 8, false};
    return true;
  }
  static constexpr std::string_view kLong = "OB OW OF OD OL OV SQ UC UR UT UN SV UV";
  if (kLong.find(vr) == std::string_view::npos) {
    e = {e.tag, file_.u16(at + 6), at + 8, false};
    return true;
  }
  if (at + 12 > file_.size()) return false;
  e = {e.tag, file_.u32(at + 8), at + 12, vr == "UN"};
  return true;
}

//! `at` moves from behind an item's header of undefined length to behind its end.
bool Walker::skipItem(std::uint64_t& at, bool explicitVr, int depth) const {
  Element e;
  while (read(at, explicitVr, e)) {
    if (e.tag == kItemEnd) {
      at = e.data;
      return true;
    }
    if (!skipValue(e, at, explicitVr, depth)) return false;
  }
  return false;
}

//! The same for a sequence, or the fragments of compressed pixel data.
bool Walker::skipSequence(std::uint64_t& at, bool explicitVr, int depth) const {
  Element e;
  while (read(at, explicitVr, e)) {
    at = e.data;
    if (e.tag == kSequenceEnd) return true;
    if (e.tag != kItem) return false;
    if (e.length == kUndefined) {
      if (!skipItem(at, explicitVr, depth)) return false;
    } else {
      at += e.length;
      if (at > file_.size()) return false;
    }
  }
  return false;
}

bool Walker::skipValue(const Element& e, std::uint64_t& at, bool explicitVr, int depth) const {
  at = e.data;
  if (e.length == kUndefined)
    return depth < kDeepest && skipSequence(at, explicitVr && !e.unknown, depth + 1);
  at += e.length;
  return at <= file_.size();
}

//! Group 2, always explicit and little-endian.
bool Walker::walkMeta(std::uint64_t& at, std::string& syntax) const {
  Element e;
  while (read(at, true, e) && e.tag >> 16 == 2) {
    if (!skipValue(e, at, true, 0)) return false;
    if (e.tag == kTransferSyntax) syntax = file_.text(e.data, e.length);
  }
  return at + 8 <= file_.size();
}

bool Walker::walkData(std::uint64_t at, bool explicitVr, DicomStructure& result) const {
  Element e;
  while (at < file_.size()) {
    if (!read(at, explicitVr, e)) return false;
    if (e.tag == kPixelData && e.length != kUndefined && e.data + e.length > file_.size()) {
      result.pixelOffset = e.data;
      result.pixelBytes = file_.size() - e.data;
      result.pixelEnd = file_.size();
      return false;
    }
    if (!skipValue(e, at, explicitVr, 0)) return false;
    if (e.tag == kSeriesUid && e.length <= 64) result.seriesUid = trimmedUid(file_.text(e.data, e.length));
    if (e.tag != kPixelData) continue;
    // What follows (padding, garbage) does not matter.
    result.pixelOffset = e.data;
    result.pixelEnd = at;
    if (e.length != kUndefined) result.pixelBytes = e.length;
    return true;
  }
  return true;
}

DicomStructure Walker::walk() {
  DicomStructure result;
  result.fileBytes = file_.size();
  std::uint64_t at = file_.size() >= 132 && file_.text(128, 4) == "DICM" ? 132 : 0;
  std::string syntax;
  result.whole = walkMeta(at, syntax);
  syntax = trimmedUid(syntax);
  result.walked = syntax != "1.2.840.10008.1.2.2" && syntax != "1.2.840.10008.1.2.1.99";
  if (!result.whole || !result.walked) return result;
  result.whole = walkData(at, syntax != "1.2.840.10008.1.2", result);
  return result;
}

}  // namespace

DicomStructure walkDicom(const std::string& path) {
  const Mapped file(path);
  return Walker(file).walk();
}

}  // namespace handlebody
