#include "core/io/meshes/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <new>

#include "core/io/refuse_input.h"
#include "core/io/shown.h"

namespace handlebody {
namespace {

//! Bytes that so many packed ones may stand for. Deflate makes 258 by two bits; a model's numbers are packed
//! by ten or so, and what is said to be far above that only costs time (a bomb of 8 MB two minutes).
constexpr std::uint64_t mostUnpacked(std::uint64_t packed) {
  constexpr std::uint64_t kMaxPacked = 1032, kMaxOfLarge = 100, kLarge = 1 << 26;
  return std::min(kMaxPacked * packed, std::max(kLarge, kMaxOfLarge * packed));
}

std::string wordsOf(int error) {
  zip_error_t told;
  zip_error_init_with_code(&told, error);
  std::string words = zip_error_strerror(&told);
  zip_error_fini(&told);
  return shown(words);
}

bool beginsAsArchive(const std::string& path) {
  std::array<char, 4> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == "PK\x03\x04";
}

[[noreturn]] void refuseArchive(const std::string& path, const std::string& format, int error) {
  if (error == ZIP_ER_MEMORY) throw std::bad_alloc();
  // The list of the entries stands at the end: without it libzip knows no archive.
  if (error == ZIP_ER_NOZIP)
    refuseInput(path, {beginsAsArchive(path) ? FindingKind::truncatedFormat : FindingKind::notOfFormat,
                       {{"format", format}}});
  refuseInput(path, {FindingKind::truncatedOrDamagedFor, {{"reason", wordsOf(error)}}});
}

}  // namespace

ZipReader::ZipReader(const std::string& path, std::string format)
    : path_(path),
      format_(std::move(format)),
      archive_(nullptr, &zip_discard),
      fileSize_(std::filesystem::file_size(path)) {
  int error = 0;
  archive_.reset(zip_open(path.c_str(), ZIP_RDONLY, &error));
  if (!archive_) refuseArchive(path, format_, error);
}

std::optional<std::uint64_t> ZipReader::find(const std::string& name) const {
  zip_int64_t found = zip_name_locate(archive_.get(), name.c_str(), 0);
  if (found < 0) found = zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE);
  return found < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(found));
}

std::string ZipReader::nameOf(std::uint64_t entry) const {
  const char* name = zip_get_name(archive_.get(), entry, ZIP_FL_ENC_RAW);
  return name ? shown(name) : std::to_string(entry);
}

void ZipReader::refuse(FindingKind kind, std::uint64_t entry) const {
  refuseInput(path_,
              {FindingKind::damagedBecause, {{"format", format_}}, Finding(kind, {{"part", nameOf(entry)}})});
}

std::uint64_t ZipReader::checkedSize(std::uint64_t entry) {
  zip_stat_t is;
  zip_stat_init(&is);
  constexpr zip_uint64_t kNeeded =
      ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
  if (zip_stat_index(archive_.get(), entry, 0, &is) != 0 || (is.valid & kNeeded) != kNeeded)
    refuseInput(path_, {FindingKind::damagedAt, {{"format", format_}, {"field", nameOf(entry)}}});
  if (is.encryption_method != ZIP_EM_NONE) refuseInput(path_, FindingKind::encryptedFile);
  const bool isStored = is.comp_method == ZIP_CM_STORE;
  if (!isStored && is.comp_method != ZIP_CM_DEFLATE) refuse(FindingKind::packingOf, entry);
  const bool isPossible =
      is.comp_size <= fileSize_ && is.size <= (isStored ? is.comp_size : mostUnpacked(is.comp_size));
  // All together, too: many entries may share the same packed bytes.
  if (isPossible) declared_ += is.size;
  if (!isPossible || declared_ > mostUnpacked(fileSize_)) refuse(FindingKind::sizeOf, entry);
  return is.size;
}

void ZipReader::read(std::uint64_t entry, const std::function<void(std::string_view)>& take) {
  std::uint64_t left = checkedSize(entry);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(archive_.get(), entry, 0),
                                                               &zip_fclose);
  if (!file) refuseArchive(path_, format_, zip_error_code_zip(zip_get_error(archive_.get())));
  std::vector<char> piece(1 << 16);
  for (;;) {
    const zip_int64_t n = zip_fread(file.get(), piece.data(), piece.size());
    if (n < 0) refuseArchive(path_, format_, zip_error_code_zip(zip_file_get_error(file.get())));
    if (static_cast<std::uint64_t>(n) > left) refuse(FindingKind::sizeOf, entry);
    if (n == 0) break;
    left -= static_cast<std::uint64_t>(n);
    take({piece.data(), static_cast<std::size_t>(n)});
  }
  if (left > 0) refuse(FindingKind::sizeOf, entry);
}

namespace {

//! libzip fails in memory only where there is too little of it.
void require(bool done) {
  if (!done) throw std::bad_alloc();
}

//! The source, which belongs to the archive as soon as that is made.
zip_source_t* emptySource() {
  zip_source_t* source = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  require(source != nullptr);
  zip_source_keep(source);  // it outlives the archive, which is written into it
  return source;
}

void add(zip_t* archive, const std::string& name, const std::string& content) {
  zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
  require(source != nullptr);
  const zip_int64_t entry = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (entry < 0) zip_source_free(source);
  require(entry >= 0);
  const auto index = static_cast<zip_uint64_t>(entry);
  constexpr zip_uint16_t kFirstDay = 0x0021;  // 1 January 1980
  constexpr zip_uint32_t kUsualLevel = 6;     // libzip's own is 9, which takes times as long for a percent
  require(zip_file_set_dostime(archive, index, 0, kFirstDay, 0) == 0);
  require(zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, kUsualLevel) == 0);
}

std::string bytesOf(zip_source_t* source) {
  zip_stat_t is;
  zip_stat_init(&is);
  require(zip_source_open(source) == 0);
  require(zip_source_stat(source, &is) == 0 && (is.valid & ZIP_STAT_SIZE));
  std::string bytes(static_cast<std::size_t>(is.size), '\0');
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  require(read == static_cast<zip_int64_t>(bytes.size()));
  return bytes;
}

}  // namespace

std::string zipped(const std::vector<std::pair<std::string, std::string>>& entries) {
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> source(emptySource(), &zip_source_free);
  zip_t* opened = zip_open_from_source(source.get(), ZIP_TRUNCATE, nullptr);
  if (!opened) zip_source_free(source.get());  // the share that the archive would have had
  require(opened != nullptr);
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(opened, &zip_discard);
  for (const auto& [name, content] : entries) add(archive.get(), name, content);
  require(zip_close(archive.get()) == 0);
  static_cast<void>(archive.release());
  return bytesOf(source.get());
}

}  // namespace handlebody
