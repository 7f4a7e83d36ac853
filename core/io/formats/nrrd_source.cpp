// NRRD, attached or detached, with one or many data files; a time axis may stand at any place.

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/header_text.h"
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
  void readPart(const std::string& file, std::uint64_t before, std::uint64_t bytes, char* to,
                const ReadProgress& progress) const;
  void readFiles(const std::vector<std::string>& files, char* to, const ReadProgress& progress) const;
  void readText(ByteStream& stream, std::uint64_t values, char* to) const;
  void pick(const char* from, int frame, char* to) const;
  std::string path_;
  NrrdFields fields_;
  NrrdLayout layout_;
  std::uint64_t all_ = 0;  // bytes of all time points
};

//! What 3D Slicer says of segments, which older ones do without LabelValue and Layer.
bool saysSegments(const NrrdFields& fields) {
  return std::any_of(fields.keys.begin(), fields.keys.end(), [](const auto& key) {
    return key.first.starts_with("Segment0_") || key.first.starts_with("Segmentation_");
  });
}

NrrdSource::NrrdSource(const std::string& path) : path_(path), fields_(readNrrdFields(path)) {
  if (fields_.sequence) refuseInput(path, FindingKind::trackedFrames);
  layout_ = interpretNrrd(fields_, path, header_);
  header_.hasLayers = header_.frames > 1 && saysSegments(fields_);
  checkHeader(header_, path);
  for (const std::string& file : fields_.dataFiles)
    if (!fs::is_regular_file(file)) refuseInput(path, {FindingKind::dataFileMissing, {{"data", file}}});
  const auto parts = std::max<std::uint64_t>(1, fields_.dataFiles.size());
  all_ = header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames);
  if (header_.frames > 1 &&
      layout_.inner * layout_.outer * bytesOf(header_.component) != header_.bytesPerFrame())
    refuseHeader(path, "NRRD", "sizes");
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

//! The value that the word is; characters are numbers here. False if it is none of the type.
template <typename T>
bool writeValue(const std::string& word, const T*, char* to) {
  using Number = std::conditional_t<sizeof(T) == 1, int, T>;
  const std::optional<Number> number = parsed<Number>(word);
  if (!number) return false;
  const T value = static_cast<T>(*number);
  std::memcpy(to, &value, sizeof value);
  return sizeof(T) > 1 || static_cast<Number>(value) == *number;
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
      bool isValue = false;
      visitComponents(header_.component, to,
                      [&](const auto* type) { isValue = writeValue(word, type, to + i * size); });
      if (!isValue) refuseInput(path_, {FindingKind::voxelsNoNumbers, {{"word", word.substr(0, 20)}}});
      word.clear();
      ++i;
    }
    if (!more && i < values) refuseInput(path_, FindingKind::voxelsTruncated);
  }
}

//! Of one file, or of what follows the header, `bytes` from `before` on.
void NrrdSource::readPart(const std::string& file, std::uint64_t before, std::uint64_t bytes, char* to,
                          const ReadProgress& progress) const {
  const bool isPacked = layout_.compressed;
  ByteStream stream(file, offsetIn(file) + (isPacked ? 0 : before),
                    isPacked ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  if (isPacked) stream.skip(before + static_cast<std::uint64_t>(std::max(0ll, layout_.byteSkip)), progress);
  if (layout_.text)
    readText(stream, bytes / bytesOf(header_.component), to);
  else
    stream.readAll(to, bytes, progress);
  stream.checkEnd(before + bytes < all_ / std::max<std::uint64_t>(1, fields_.dataFiles.size()));
}

//! All time points, from all files.
void NrrdSource::readFiles(const std::vector<std::string>& files, char* to,
                           const ReadProgress& progress) const {
  const std::uint64_t part = all_ / files.size();
  for (std::size_t i = 0; i < files.size(); ++i)
    readPart(files[i], 0, part, to + i * part, [&](double done) {
      tellProgress(progress, (static_cast<double>(i) + done) / static_cast<double>(files.size()));
    });
}

//! The values of one time point from those of all.
void NrrdSource::pick(const char* from, int frame, char* to) const {
  const std::uint64_t run = layout_.inner * bytesOf(header_.component),
                      step = run * static_cast<std::uint64_t>(header_.frames);
  from += run * static_cast<std::uint64_t>(frame);
  for (std::uint64_t o = 0; o < layout_.outer; ++o, from += step, to += run) std::memcpy(to, from, run);
}

void NrrdSource::readFrame(int frame, void* to, const ReadProgress& progress) {
  const std::vector<std::string> files = fields_.dataFiles.empty() ? std::vector{path_} : fields_.dataFiles;
  const std::uint64_t bytes = header_.bytesPerFrame();
  if (header_.frames == 1) {
    readFiles(files, static_cast<char*>(to), progress);
  } else if (files.size() == 1 && layout_.outer == 1 && !layout_.text) {
    // Time points follow one another: those before are passed over.
    readPart(files[0], bytes * static_cast<std::uint64_t>(frame), bytes, static_cast<char*>(to), progress);
  } else {
    const std::shared_ptr<void> all = allocate(all_, path_);
    readFiles(files, static_cast<char*>(all.get()), progress);
    pick(static_cast<const char*>(all.get()), frame, static_cast<char*>(to));
  }
  if (layout_.swapped && !layout_.text) swapVoxels(header_, to);
}

}  // namespace

SourcePointer openNrrd(const std::string& path) { return std::make_unique<NrrdSource>(path); }

}  // namespace handlebody
