// NRRD, attached or detached, with one or many data files; a time axis may stand at any place.

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/nrrd_header.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

class NrrdSource : public VolumeSource {
 public:
  explicit NrrdSource(const std::string& path);

 protected:
  void readFrame(int frame, void* to, const ReadProgress& progress) override;

 private:
  std::uint64_t offsetIn(const std::string& file) const;
  void readStream(ByteStream& stream, std::uint64_t bytes, char* to, const ReadProgress& progress) const;
  void readPart(const std::string& file, int frame, char* to, const ReadProgress& progress) const;
  void readFiles(int frame, char* to, const ReadProgress& progress) const;
  void readText(ByteStream& stream, std::uint64_t values, char* to) const;
  void pick(const char* from, int frame, char* to) const;
  std::string path_;
  NrrdFields fields_;
  NrrdLayout layout_;
  std::uint64_t all_ = 0;  // bytes of all time points
};

NrrdSource::NrrdSource(const std::string& path) : path_(path), fields_(readNrrdFields(path)) {
  if (fields_.sequence) refuseInput(path, FindingKind::trackedFrames);
  layout_ = interpretNrrd(fields_, path, header_);
  checkHeader(header_, path);
  for (const std::string& file : fields_.dataFiles)
    if (!fs::is_regular_file(file)) refuseInput(path, {FindingKind::dataFileMissing, {{"data", file}}});
  const auto parts = std::max<std::uint64_t>(1, fields_.dataFiles.size());
  all_ = header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames);
  if (header_.frames > 1 &&
      layout_.inner * layout_.outer * bytesOf(header_.component) != header_.bytesPerFrame())
    refuseInput(path, {FindingKind::headerDamaged,
                       {{"format", std::string("NRRD")}, {"field", std::string("sizes")}}});
  if (all_ % parts != 0) refuseInput(path, FindingKind::dataFilesUneven);
  // As text, a digit for every value and a space between them at least.
  const std::uint64_t bytes =
      layout_.text ? 2 * (all_ / bytesOf(header_.component)) / parts - 1 : all_ / parts;
  if (fields_.dataFiles.empty()) checkDataSize(path, path, fields_.end, bytes, layout_.compressed);
  for (const std::string& file : fields_.dataFiles) checkDataSize(path, file, 0, bytes, layout_.compressed);
}

//! Where the data begin in a file that is not compressed. Lines are skipped first, then bytes; −1 bytes: the
//! data are the end of the file.
std::uint64_t NrrdSource::offsetIn(const std::string& file) const {
  std::uint64_t at = fields_.dataFiles.empty() ? fields_.end : 0;
  ByteStream lines(file, at, ByteStream::Coding::raw);
  for (long long i = 0; i < layout_.lineSkip; ++i)
    for (char c = 0; c != '\n'; ++at)
      if (lines.read(&c, 1) == 0) refuseInput(path_, FindingKind::voxelsTruncated);
  if (layout_.byteSkip >= 0)
    return at + (layout_.compressed ? 0 : static_cast<std::uint64_t>(layout_.byteSkip));
  const std::uint64_t size = fs::file_size(file),
                      bytes = all_ / std::max<std::uint64_t>(1, fields_.dataFiles.size());
  if (layout_.compressed || size < bytes) refuseInput(path_, FindingKind::skipNotSupported);
  return size - bytes;
}

void NrrdSource::readText(ByteStream& stream, std::uint64_t values, char* to) const {
  const std::size_t size = bytesOf(header_.component);
  std::string word;
  for (std::uint64_t i = 0; i < values;) {
    char c = ' ';
    const bool more = stream.read(&c, 1) == 1;
    const bool space = !more || std::isspace(static_cast<unsigned char>(c)) || c == ',';
    if (!space) word += c;
    if (space && !word.empty()) {
      bool good = false;
      visitComponents(header_.component, to + i * size, [&](auto* at) {
        auto& value = const_cast<std::remove_const_t<std::remove_pointer_t<decltype(at)>>&>(*at);
        int small = 0;  // characters are numbers here
        if constexpr (sizeof value == 1) {
          good =
              std::from_chars(word.data(), word.data() + word.size(), small).ptr == word.data() + word.size();
          value = static_cast<std::remove_reference_t<decltype(value)>>(small);
        } else {
          good =
              std::from_chars(word.data(), word.data() + word.size(), value).ptr == word.data() + word.size();
        }
      });
      if (!good) refuseInput(path_, {FindingKind::voxelsNoNumbers, {{"word", word.substr(0, 20)}}});
      word.clear();
      ++i;
    }
    if (!more && i < values) refuseInput(path_, FindingKind::voxelsTruncated);
  }
}

void NrrdSource::readStream(ByteStream& stream, std::uint64_t bytes, char* to,
                            const ReadProgress& progress) const {
  if (layout_.text)
    readText(stream, bytes / bytesOf(header_.component), to);
  else
    stream.readAll(to, bytes, progress);
}

//! One file, or what follows the header. Time points that follow one another are passed over.
void NrrdSource::readPart(const std::string& file, int frame, char* to, const ReadProgress& progress) const {
  const auto coding = layout_.compressed ? ByteStream::Coding::deflate : ByteStream::Coding::raw;
  const std::uint64_t bytes = header_.bytesPerFrame();
  const bool together = layout_.outer == 1 && !layout_.text;
  const std::uint64_t before = together ? bytes * static_cast<std::uint64_t>(frame) : 0;
  ByteStream stream(file, offsetIn(file) + (layout_.compressed ? 0 : before), coding);
  if (layout_.compressed)
    stream.skip(before + static_cast<std::uint64_t>(std::max(0ll, layout_.byteSkip)), progress);
  if (together || header_.frames == 1) {
    readStream(stream, bytes, to, progress);
  } else {
    const std::shared_ptr<void> all = allocate(all_, path_);
    readStream(stream, all_, static_cast<char*>(all.get()), progress);
    pick(static_cast<const char*>(all.get()), frame, to);
  }
  stream.checkEnd(together && frame + 1 < header_.frames);
}

void NrrdSource::readFiles(int frame, char* to, const ReadProgress& progress) const {
  const auto coding = layout_.compressed ? ByteStream::Coding::deflate : ByteStream::Coding::raw;
  const std::uint64_t part = all_ / fields_.dataFiles.size();
  const std::shared_ptr<void> all = allocate(all_, path_);
  char* at = static_cast<char*>(all.get());
  for (const std::string& file : fields_.dataFiles) {
    ByteStream stream(file, offsetIn(file), coding);
    if (layout_.compressed)
      stream.skip(static_cast<std::uint64_t>(std::max(0ll, layout_.byteSkip)), progress);
    readStream(stream, part, at, {});
    stream.checkEnd();
    at += part;
    report(progress, static_cast<double>(at - static_cast<char*>(all.get())) / static_cast<double>(all_));
  }
  pick(static_cast<const char*>(all.get()), frame, to);
}

//! The values of one time point from those of all.
void NrrdSource::pick(const char* from, int frame, char* to) const {
  const std::uint64_t size = bytesOf(header_.component);
  if (header_.frames == 1) {
    std::memcpy(to, from, header_.bytesPerFrame());
    return;
  }
  const std::uint64_t run = layout_.inner * size, step = run * static_cast<std::uint64_t>(header_.frames);
  from += run * static_cast<std::uint64_t>(frame);
  for (std::uint64_t o = 0; o < layout_.outer; ++o, from += step, to += run) std::memcpy(to, from, run);
}

void NrrdSource::readFrame(int frame, void* to, const ReadProgress& progress) {
  if (fields_.dataFiles.size() > 1)
    readFiles(frame, static_cast<char*>(to), progress);
  else
    readPart(fields_.dataFiles.empty() ? path_ : fields_.dataFiles[0], frame, static_cast<char*>(to),
             progress);
  if (layout_.swapped && !layout_.text)
    swapBytes(to, header_.grid.voxelCount() * static_cast<std::size_t>(header_.components),
              bytesOf(header_.component));
}

}  // namespace

SourcePointer openNrrd(const std::string& path) { return std::make_unique<NrrdSource>(path); }

}  // namespace handlebody
