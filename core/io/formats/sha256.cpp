#include "core/io/formats/sha256.h"

#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "core/cancellation.h"
#include "core/io/formats/volume_files.h"
#include "core/io/formats/volume_io.h"
#include "core/io/formats/volume_source.h"
#include "core/phase.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

//! Those of the folder itself, in name order.
std::vector<std::string> filesIn(const std::string& folder) {
  std::error_code failed;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  if (failed) refuseInput(folder, {FindingKind::folderUnreadableFor, {{"reason", failed.message()}}});
  std::sort(files.begin(), files.end());
  return files;
}

class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1)
      throw std::runtime_error("SHA-256 is not available in libcrypto.");
  }
  void add(const char* bytes, std::size_t count) { EVP_DigestUpdate(context_.get(), bytes, count); }
  std::string hex() {
    unsigned char hash[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    EVP_DigestFinal_ex(context_.get(), hash, &length);
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
      text += "0123456789abcdef"[hash[i] >> 4];
      text += "0123456789abcdef"[hash[i] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

void addFile(Digest& digest, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuseInput(path, FindingKind::notOpened);
  std::vector<char> part(1 << 16);
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0) {
    giveUpIfCancelled();
    digest.add(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) refuseInput(path, FindingKind::notReadToEnd);
}

}  // namespace

PathHash hashOfPath(const std::string& path) {
  const Phase phase("reading");
  std::error_code failed;
  if (!fs::exists(path, failed)) refuseInput(path, FindingKind::noSuchFileOrFolder);
  Digest whole;
  if (fs::is_directory(path)) {
    for (const std::string& file : filesIn(path)) addFile(whole, file);
    return {whole.hex(), {}};
  }
  bool isHeader = false;
  for (const std::string& file : filesOfVolume(path)) {
    // A pair has one of several spellings; what else is not there, opening the volume tells.
    if (file != path && !fs::is_regular_file(file, failed)) continue;
    addFile(whole, file);
    isHeader = isHeader || file != path;
  }
  if (!isHeader) return {whole.hex(), {}};
  Digest header;
  addFile(header, path);
  return {whole.hex(), header.hex()};
}

std::string sha256OfText(const std::string& text) { return sha256OfBytes(text, nullptr, 0); }

std::string sha256OfBytes(const std::string& head, const void* bytes, std::size_t count) {
  Digest digest;
  digest.add(head.data(), head.size());
  if (count > 0) digest.add(static_cast<const char*>(bytes), count);
  return digest.hex();
}

}  // namespace handlebody
