// A folder of 3D volumes, one per time point.

#include <algorithm>
#include <filesystem>

#include "core/io/formats/volume_source.h"
#include "core/io/lowered.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

constexpr double kSamePlace = 1e-3;  // mm between the corners of two grids that are one

bool endsWithAny(const std::string& name, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return name.ends_with(e); });
}

//! "frame2" before "frame10".
bool comesBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto number = [&](const std::string& s, std::size_t& at) {
    const std::size_t begin = s.find_first_not_of('0', at);
    std::size_t end = at;
    while (end < s.size() && isDigit(s[end])) ++end;
    at = end;
    return begin < end ? s.substr(begin, end - begin) : std::string();
  };
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const std::string m = number(a, i), n = number(b, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

//! Volumes in the order of their names; nothing if there is a file that is none. Data files, notes and hidden
//! files are passed over.
std::vector<std::string> volumesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), lower = lowered(name);
    if (!entry.is_regular_file() || name.front() == '.' ||
        endsWithAny(lower, {".raw", ".raw.gz", ".zraw", ".img", ".img.gz", ".txt", ".json", ".csv"}))
      continue;
    if (!endsWithAny(lower, {".nii", ".nii.gz", ".hdr", ".nrrd", ".nhdr", ".mha", ".mhd"})) return {};
    names.push_back(name);
  }
  std::sort(names.begin(), names.end(), comesBefore);
  return names;
}

SourcePointer openFrame(const std::string& path, const DecoderSettings& decoder) {
  OpenRequest request;
  request.path = path;
  request.selection.decoder = decoder;
  bool several = false;
  return openVolume(request, {}, &several);
}

bool isSameGrid(const Grid& a, const Grid& b) {
  if (a.size != b.size) return false;
  const Vec3 last(a.size[0] - 1, a.size[1] - 1, a.size[2] - 1);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at(corner & 1 ? last.x() : 0, corner & 2 ? last.y() : 0, corner & 4 ? last.z() : 0);
    if (!((a.toWorld(at) - b.toWorld(at)).norm() < kSamePlace)) return false;
  }
  return true;
}

class FolderSource : public VolumeSource {
 public:
  FolderSource(const std::string& folder, const std::vector<std::string>& names,
               const DecoderSettings& decoder);
  std::shared_ptr<void> read(int frame, const std::string&, const ReadProgress& progress) override {
    const std::string& path = paths_[static_cast<std::size_t>(frame)];
    const SourcePointer source = openFrame(path, decoder_);
    requireSame(source->header(), path);
    return source->read(0, path, progress);
  }

 protected:
  void readFrame(int, void*, const ReadProgress&) override {}  // read() does it

 private:
  void requireSame(const VolumeHeader& other, const std::string& path) const;
  std::vector<std::string> paths_;
  DecoderSettings decoder_;
};

FolderSource::FolderSource(const std::string& folder, const std::vector<std::string>& names,
                           const DecoderSettings& decoder)
    : decoder_(decoder) {
  for (const std::string& name : names) paths_.push_back((fs::path(folder) / name).string());
  header_ = openFrame(paths_.front(), decoder_)->header();
  for (const std::string& path : paths_) requireSame(openFrame(path, decoder_)->header(), path);
  header_.frames = static_cast<int>(paths_.size());
  header_.format += " (a folder, one file per time point)";
}

void FolderSource::requireSame(const VolumeHeader& other, const std::string& path) const {
  const Finding::Values first{{"first", paths_.front()}};
  if (other.frames != 1) refuseInput(path, {FindingKind::folderTimePoints, {{"frames", other.frames}}});
  if (!isSameGrid(other.grid, header_.grid)) refuseInput(path, {FindingKind::folderOtherGrid, first});
  if (other.component != header_.component || other.components != header_.components ||
      other.slope != header_.slope || other.intercept != header_.intercept)
    refuseInput(path, {FindingKind::folderOtherType, first});
}

}  // namespace

SourcePointer openVolumeFolder(const std::string& path, const DecoderSettings& decoder) try {
  const std::vector<std::string> names = volumesIn(path);
  return names.empty() ? nullptr : std::make_unique<FolderSource>(path, names, decoder);
} catch (const fs::filesystem_error&) {
  refuseInput(path, FindingKind::folderUnreadable);
}

}  // namespace handlebody
