#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/told_error.h"

namespace handlebody {
namespace fs = std::filesystem;
namespace {

//! Removes the temporary file when it goes out of scope, unless it has got its name.
class Temporary {
 public:
  Temporary(std::string path, std::string name) : path_(std::move(path)), name_(std::move(name)) {}
  Temporary(Temporary&& other) noexcept
      : path_(std::exchange(other.path_, {})), name_(std::move(other.name_)) {}
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  const std::string& path() const { return path_; }
  //! Throws OutputError.
  void rename() {
    if (::rename(path_.c_str(), name_.c_str()) != 0) refuseOutput(name_, systemFinding(errno));
    path_.clear();
  }

 private:
  std::string path_, name_;
};

std::string temporaryName(const std::string& path) {
  static std::atomic<unsigned> counter{0};  // of the process: two threads may write the same path
  const fs::path target(path);
  // In front, so that the ending stays; in lower case, because libraries know endings only so. Of a name that
  // is as long as names may be only the end.
  std::string name = ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-";
  const std::string whole = target.filename().string();
  name += whole.substr(whole.size() -
                       std::min(whole.size(), NAME_MAX - std::min<std::size_t>(name.size(), NAME_MAX)));
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return (target.parent_path() / name).string();
}

//! Creates the file empty: finds out before the work whether the folder takes files at all.
void create(const std::string& temporary, const std::string& path) {
  const int file = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0) refuseOutput(path, systemFinding(errno));
  ::close(file);
}

//! The data must be on the disk before the name is: else a crash leaves an empty file under the final name.
void flushToDisk(const std::string& temporary, const std::string& path) {
  const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuseOutput(path, systemFinding(errno));
  const int failed = ::fsync(file);
  const int cause = errno;
  ::close(file);
  if (failed != 0 && cause != EINVAL) refuseOutput(path, systemFinding(cause));
}

}  // namespace

struct FileSet::Waiting {
  std::vector<Temporary> files;
};

void refuseOutput(const std::string& path, const Finding& cause) {
  throw Told<OutputError>(Finding(FindingKind::fileNotWritten, {{"file", path}}, cause));
}

Finding systemFinding(int error) {
  switch (error) {
    case EACCES:
      return FindingKind::permissionDenied;
    case ENOSPC:
      return FindingKind::noSpaceLeft;
    case EROFS:
      return FindingKind::readOnlyDisk;
    case ENOENT:
      return FindingKind::noFileOrDirectory;
    case ENAMETOOLONG:
      return FindingKind::nameTooLong;
    case ENOTDIR:
      return FindingKind::notADirectory;
    case EDQUOT:
      return FindingKind::quotaExceeded;
    case EIO:
      return FindingKind::inputOutputError;
    default:
      return {FindingKind::other, {{"text", std::string(std::strerror(error))}}};
  }
}

void writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write,
                     FileSet* set) {
  if (fs::path(path).filename().empty()) refuseOutput(path, FindingKind::nameIsFolder);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuseOutput(path, FindingKind::folderHasName);
  Temporary temporary(temporaryName(path), path);
  create(temporary.path(), path);
  write(temporary.path());
  flushToDisk(temporary.path(), path);
  if (set != nullptr)
    set->waiting_->files.push_back(std::move(temporary));
  else
    temporary.rename();
}

FileSet::FileSet() : waiting_(std::make_unique<Waiting>()) {}
FileSet::~FileSet() = default;

void FileSet::commit() {
  for (Temporary& file : waiting_->files) file.rename();
  waiting_->files.clear();
}

void writeTextAtomically(const std::string& path, const std::string& text, FileSet* set) {
  const auto write = [&](const std::string& temporary) {
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) refuseOutput(path, systemFinding(errno));
    const char* at = text.data();
    std::size_t left = text.size();
    while (left > 0) {
      const ssize_t written = ::write(file, at, left);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        const int cause = errno;
        ::close(file);
        refuseOutput(path, systemFinding(cause));
      }
      at += written;
      left -= static_cast<std::size_t>(written);
    }
    if (::close(file) != 0) refuseOutput(path, systemFinding(errno));
  };
  writeAtomically(path, write, set);
}

}  // namespace handlebody
