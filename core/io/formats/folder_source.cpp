// A folder of 3D volumes, one per time point.

#include <filesystem>

#include "core/io/formats/folder_files.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

constexpr double kSamePlace = 1e-3;  // mm between the corners of two grids that are one

SourcePointer openFrame(const std::string& path, const DecoderSettings& decoder) {
  OpenRequest request;
  request.path = path;
  request.selection.decoder = decoder;
  return openVolume(request, {});
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
    const std::string& path = paths_[frame];
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
  const std::vector<std::string> names =
      filesOf(path, {".nii", ".nii.gz", ".hdr", ".nrrd", ".nhdr", ".mha", ".mhd"});
  return names.empty() ? nullptr : std::make_unique<FolderSource>(path, names, decoder);
} catch (const fs::filesystem_error&) {
  refuseInput(path, FindingKind::folderUnreadable);
}

}  // namespace handlebody
