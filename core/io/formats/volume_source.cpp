// Which format a file has: by content, not by name.

#include "core/io/formats/volume_source.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/gipl_source.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;
using Start = std::array<unsigned char, 512>;

Start startOf(const std::string& path, bool inflated) {
  Start start{};
  ByteStream stream(path, 0, inflated ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  stream.read(start.data(), start.size());
  return start;
}

bool beginsWith(const Start& start, const std::string& magic, std::size_t at = 0) {
  return std::memcmp(start.data() + at, magic.data(), magic.size()) == 0;
}

bool looksLikeNifti(const Start& s) {
  const auto is = [&](int a, int b) {
    const int little = s[0] | s[1] << 8, big = s[3] | s[2] << 8;
    return ((little == a && s[2] == 0 && s[3] == 0) || (big == b && s[0] == 0 && s[1] == 0));
  };
  return is(348, 348) || is(540, 540);
}

bool looksLikeMetaImage(const Start& s) {
  const std::string text(s.begin(), s.end());
  return text.find("NDims") != std::string::npos || text.find("ObjectType") != std::string::npos;
}

bool looksLikeTiff(const Start& s) {
  return beginsWith(s, std::string("II*\0", 4)) || beginsWith(s, std::string("MM\0*", 4)) ||
         beginsWith(s, std::string("II+\0", 4)) || beginsWith(s, std::string("MM\0+", 4));
}

//! Its magic number, or that of before it.
bool looksLikeGipl(const Start& s) {
  return beginsWith(s, "\x2a\xe3\x89\xb8", 252) || beginsWith(s, "\xef\xff\xe9\xb0", 252);
}

//! DICOM without its preamble begins with a tag of group 2 or 8.
bool looksLikeDicom(const Start& s) {
  if (beginsWith(s, "DICM", 128)) return true;
  return (s[0] == 8 || s[0] == 2) && s[1] == 0 && s[3] == 0 && s[2] <= 0x18;
}

void checkExists(const std::string& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (!fs::exists(status)) refuseInput(path, FindingKind::noSuchFileOrFolder);
  if (!fs::is_regular_file(status)) refuseInput(path, FindingKind::neitherFileNorFolder);
  std::ifstream file(path, std::ios::binary);
  if (!file) refuseInput(path, FindingKind::notOpened);
  if (fs::file_size(path, failed) == 0) refuseInput(path, FindingKind::emptyFile);
}

SourcePointer openFile(const OpenRequest& request, const ReadProgress& progress) {
  const std::string& path = request.path;
  checkExists(path);
  const Start start = startOf(path, false);
  if (beginsWith(start, "version https://git-lfs")) refuseInput(path, FindingKind::gitPointer);
  if (looksLikeGipl(start)) return openGipl(path);
  if (looksLikeDicom(start) && !looksLikeNifti(start)) return openDicom(request, progress);
  if (beginsWith(start, "NRRD0")) return openNrrd(path);
  if (looksLikeTiff(start)) return openTiff(request, progress);
  if (looksLikeNifti(start) || path.ends_with(".img") || path.ends_with(".img.gz")) return openNifti(path);
  if (isGzip(path)) {
    const Start inside = startOf(path, true);
    if (looksLikeGipl(inside)) return openGipl(path);
    if (looksLikeNifti(inside)) return openNifti(path);
    if (looksLikeDicom(inside)) refuseInput(path, FindingKind::packedDicom);
  }
  if (looksLikeMetaImage(start)) return openMetaImage(path);
  refuseInput(path, FindingKind::unknownVolume);
}

//! Null: DICOM, or nothing that is known.
SourcePointer openFolder(const OpenRequest& request, const ReadProgress& progress) {
  if (isTiffFolder(request.path)) return openTiff(request, progress);
  return openVolumeFolder(request.path, request.selection.decoder);
}

}  // namespace

SourcePointer openVolume(const OpenRequest& request, const ReadProgress& progress) {
  std::error_code failed;
  const bool isFolder = fs::is_directory(request.path, failed);
  SourcePointer source = isFolder ? openFolder(request, progress) : openFile(request, progress);
  if (!source) return openDicom(request, progress);
  if (request.selection.series && source->header().format != "DICOM")
    throw Told<UsageError>(
        Finding(FindingKind::seriesNotDicom, {{"file", request.path}, {"format", source->header().format}}));
  return source;
}

}  // namespace handlebody
