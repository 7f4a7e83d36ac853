#pragma once
// The input of a fuzz target as a file, in memory where the machine has /dev/shm.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/errors.h"

namespace handlebody::test {

class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name) {
    std::string folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
    folder += "/handlebody-fuzz-XXXXXX";
    if (!mkdtemp(folder.data())) std::abort();
    folder_ = folder;
    path_ = (folder_ / name).string();
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& write(const std::uint8_t* bytes, std::size_t n) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(n));
    return path_;
  }

 private:
  std::filesystem::path folder_;
  std::string path_;
};

//! Runs f; a refusal is as good as an answer, anything else is a find.
template <typename F>
int answeredOrRefused(F&& f) try {
  f();
  return 0;
} catch (const InputError&) {
  return 0;
} catch (const UsageError&) {
  return 0;
}

}  // namespace handlebody::test
