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
#include <optional>
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
  //! Of a file that was made for it.
  Temporary(std::string path, std::string target, std::string name)
      : path_(std::move(path)), target_(std::move(target)), name_(std::move(name)) {}
  Temporary(Temporary&& other) noexcept
      : path_(std::exchange(other.path_, {})),
        target_(std::move(other.target_)),
        name_(std::move(other.name_)) {}
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  const std::string& path() const { return path_; }
  //! Throws OutputError.
  void rename() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) refuseOutput(name_, systemFinding(errno));
    path_.clear();
  }

 private:
  std::string path_, target_;
  std::string name_;  // as it was asked for: a link to the target, or that itself
};

//! In the folder of `target`, with the ending of `path`.
std::string temporaryName(const std::string& target, const std::string& path) {
  static std::atomic<unsigned> counter{0};  // of the process: two threads may write the same path
  // In front, so that the ending stays; in lower case, because libraries know endings only so. Of a name that
  // is as long as names may be only the end.
  std::string name = ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-";
  const std::string whole = fs::path(path).filename().string();
  name += whole.substr(whole.size() -
                       std::min(whole.size(), NAME_MAX - std::min<std::size_t>(name.size(), NAME_MAX)));
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return (fs::path(target).parent_path() / name).string();
}

//! The permissions of the file that is replaced; none if there is no file. Throws OutputError where there is
//! what no file may replace: a folder, a device.
std::optional<mode_t> permissionsAt(const std::string& target, const std::string& path) {
  struct stat there {};
  if (::stat(target.c_str(), &there) != 0) {
    if (errno == ENOENT) return std::nullopt;
    refuseOutput(path, systemFinding(errno));
  }
  if (S_ISDIR(there.st_mode)) refuseOutput(path, FindingKind::folderHasName);
  if (!S_ISREG(there.st_mode))
    refuseOutput(path, {FindingKind::other, {{"text", std::string("it is not a regular file")}}});
  return there.st_mode & 0777;
}

//! Creates the file empty: finds out before the work whether the folder takes files at all. What has the name
//! of a temporary file already is of another process, which has the same number in another container, or was
//! left by one that was killed: it stays.
Temporary create(const std::string& target, const std::string& path, mode_t permissions) {
  constexpr int kMaxInTheWay = 10000;
  for (int i = 0; i < kMaxInTheWay; ++i) {
    const std::string name = temporaryName(target, path);
    const int file = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, permissions);
    if (file >= 0) {
      ::close(file);
      return {name, target, path};
    }
    const int cause = errno;
    if (cause != EEXIST) refuseOutput(path, systemFinding(cause));
  }
  refuseOutput(path, systemFinding(EEXIST));
}

//! The data must be on the disk before the name is: else a crash leaves an empty file under the final name.
//! Permissions that a file system does not keep are no reason to lose a result.
void flushToDisk(const std::string& temporary, const std::string& path, std::optional<mode_t> permissions) {
  const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuseOutput(path, systemFinding(errno));
  if (permissions) static_cast<void>(::fchmod(file, *permissions));
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

std::string behindLinks(const std::string& path) {
  constexpr int kMaxLinks = 40;  // as many as Linux follows
  fs::path at(path);
  for (int i = 0; i < kMaxLinks; ++i) {
    std::error_code isNone;
    const fs::path next = fs::read_symlink(at, isNone);
    if (isNone) break;
    at = at.parent_path() / next;
  }
  return at.string();
}

std::string inRealFolder(const std::string& path) {
  fs::path whole = fs::absolute(path);
  if (!whole.has_filename()) whole = whole.parent_path();
  const bool isNamed = whole.filename() != "." && whole.filename() != "..";
  std::error_code failed;
  const fs::path real = fs::weakly_canonical(isNamed ? whole.parent_path() : whole, failed);
  if (failed) return whole.string();  // whoever opens it is told why
  return (isNamed ? real / whole.filename() : real).string();
}

void writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write,
                     FileSet* set) {
  if (fs::path(path).filename().empty()) refuseOutput(path, FindingKind::nameIsFolder);
  const std::string target = behindLinks(path);
  const std::optional<mode_t> before = permissionsAt(target, path);
  // Not readable for others while it is written, if it was not before.
  Temporary temporary = create(target, path, before ? (*before & 0666) | 0600 : 0666);
  write(temporary.path());
  flushToDisk(temporary.path(), path, before);
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
