#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "core/io/formats/volume_io.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> filesOf(const std::string& path) {
  std::error_code failed;
  if (!fs::exists(path, failed)) refuseInput(path, FindingKind::noSuchFileOrFolder);
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  if (failed) refuseInput(path, {FindingKind::folderUnreadableFor, {{"reason", failed.message()}}});
  std::sort(files.begin(), files.end());
  return files;
}

void addFile(EVP_MD_CTX* digest, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuseInput(path, FindingKind::notOpened);
  std::vector<char> part(1 << 16);
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    EVP_DigestUpdate(digest, part.data(), static_cast<std::size_t>(file.gcount()));
  if (file.bad()) refuseInput(path, FindingKind::notReadToEnd);
}

}  // namespace

std::string sha256OfPath(const std::string& path) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  if (!digest || EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in libcrypto.");
  for (const std::string& file : filesOf(path)) addFile(digest.get(), file);
  unsigned char hash[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  EVP_DigestFinal_ex(digest.get(), hash, &length);
  std::string hex;
  for (unsigned i = 0; i < length; ++i) {
    hex += "0123456789abcdef"[hash[i] >> 4];
    hex += "0123456789abcdef"[hash[i] & 15];
  }
  return hex;
}

}  // namespace handlebody
