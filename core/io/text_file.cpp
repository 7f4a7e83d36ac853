#include "core/io/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/errors.h"

namespace handlebody {

namespace fs = std::filesystem;

std::string readTextFile(const std::string& path) {
  if (fs::is_directory(path)) throw InputError(path + " is a folder, not a file.");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path + " cannot be opened: " + std::strerror(errno) + ".");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(path + " cannot be read.");
  return text;
}

void writeTextFile(const std::string& text, const std::string& path) {
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  errno = 0;
  std::ofstream out(temporary, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code failed;
  if (out) fs::rename(temporary, path, failed);
  if (out && !failed) return;
  const std::string why = failed ? failed.message() : std::strerror(errno);
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw OutputError(path + " cannot be written: " + why + ".");
}

}  // namespace handlebody
