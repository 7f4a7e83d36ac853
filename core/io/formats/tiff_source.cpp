// TIFF through ITK: a file of several pages, or a folder of files that are a slice each.

#include <itkTIFFImageIO.h>

#include <cstring>
#include <filesystem>

#include "core/io/formats/decoded_source.h"
#include "core/io/formats/folder_files.h"
#include "core/io/formats/itk_source.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

std::uint64_t sizeOf(const std::string& path) {
  std::error_code failed;
  const std::uint64_t bytes = fs::file_size(path, failed);
  return failed ? 0 : bytes;
}

//! Neither distances of slices nor how they lie are told.
void completeHeader(VolumeHeader& header, const std::string& slices) {
  const bool resolution = header.grid.spacing.x() != 1 || header.grid.spacing.y() != 1;
  const std::string inPlane = resolution ? "XResolution, YResolution" : "assumed";
  header.sources = {"ImageWidth, ImageLength and the number of " + slices,
                    {inPlane, inPlane, "assumed"},
                    "assumed",
                    "assumed"};
  header.calibrated = false;
  header.warnings.push_back(FindingKind::tiffWithoutPlace);
}

//! All pages at once, straight into our buffer.
class TiffFile : public DecodedSource {
 public:
  explicit TiffFile(std::string path) : io_(itk::TIFFImageIO::New()), path_(std::move(path)) {
    header_ = readItkHeader(*io_, path_, "TIFF");
    checkHeader(header_, path_);
    // Whatever its compression, so many voxels do not come from so few bytes.
    checkDataSize(path_, path_, 0, header_.bytesPerFrame(), true);
    completeHeader(header_, "pages");
  }
  void decode(int frame, void* to, const DecodingProgress& progress) override {
    const Quiet quiet;
    progress(0, path_, header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames));
    const std::size_t bytes = static_cast<std::size_t>(header_.bytesPerFrame());
    std::unique_ptr<char[]> all;
    if (header_.frames > 1) all.reset(new char[bytes * static_cast<std::size_t>(header_.frames)]);
    withItk(path_, FindingKind::truncatedOrDamagedFor, [&] { io_->Read(all ? all.get() : to); });
    if (all) std::memcpy(to, all.get() + bytes * static_cast<std::size_t>(frame), bytes);
  }

 protected:
  void readFrame(int frame, void* to, const ReadProgress&) override {
    decode(frame, to, [](double, const std::string&, std::uint64_t) {});
  }

 private:
  itk::ImageIOBase::Pointer io_;
  std::string path_;
};

//! A slice each, one behind the other.
class TiffSlices : public DecodedSource {
 public:
  TiffSlices(std::vector<std::string> files, const DecodingProgress& progress) : files_(std::move(files)) {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      progress(static_cast<double>(i) / static_cast<double>(files_.size()), files_[i], sizeOf(files_[i]));
      const VolumeHeader slice = readSlice(files_[i])->header;
      checkDataSize(files_[i], files_[i], 0, slice.bytesPerFrame(), true);
    }
    header_.grid.size[2] = static_cast<int>(files_.size());
    header_.format += " (a folder, one file per slice)";
    completeHeader(header_, "files");
  }
  void decode(int, void* to, const DecodingProgress& progress) override {
    const std::size_t bytes = static_cast<std::size_t>(header_.bytesPerFrame()) / files_.size();
    for (std::size_t i = 0; i < files_.size(); ++i) {
      const std::string& path = files_[i];
      progress(static_cast<double>(i) / static_cast<double>(files_.size()), path, bytes);
      const Quiet quiet;
      const auto slice = readSlice(path);  // again: it may have been written anew in between
      withItk(path, FindingKind::truncatedOrDamagedFor,
              [&] { slice->io->Read(static_cast<char*>(to) + bytes * i); });
    }
  }

 protected:
  void readFrame(int frame, void* to, const ReadProgress&) override {
    decode(frame, to, [](double, const std::string&, std::uint64_t) {});
  }

 private:
  struct Slice {
    itk::TIFFImageIO::Pointer io = itk::TIFFImageIO::New();
    VolumeHeader header{};
  };

  //! The first is what the others have to be like.
  std::unique_ptr<Slice> readSlice(const std::string& path) {
    auto slice = std::make_unique<Slice>();
    VolumeHeader& h = slice->header;
    h = readItkHeader(*slice->io, path, "TIFF", 2);
    const int pages = h.grid.size[2] * h.frames;
    if (pages != 1) refuseInput(path, {FindingKind::slicePages, {{"pages", pages}}});
    if (header_.format.empty()) header_ = h;
    const Grid &a = h.grid, &b = header_.grid;
    if (a.size[0] != b.size[0] || a.size[1] != b.size[1] || a.spacing != b.spacing ||
        h.component != header_.component || h.components != header_.components)
      refuseInput(path, {FindingKind::sliceDiffers, {{"first", files_.front()}}});
    return slice;
  }

  std::vector<std::string> files_;
};

std::vector<std::string> tiffNames(const std::string& folder) try {
  return filesOf(folder, {".tif", ".tiff"});
} catch (const fs::filesystem_error&) {
  refuseInput(folder, FindingKind::folderUnreadable);
}

}  // namespace

bool isTiffFolder(const std::string& path) { return !tiffNames(path).empty(); }

SourcePointer openTiffHere(const OpenRequest& request, const DecodingProgress& progress) {
  const std::string& path = request.path;
  std::error_code failed;
  std::vector<std::string> files{path};
  if (fs::is_directory(path, failed)) {
    files = tiffNames(path);
    for (std::string& name : files) name = (fs::path(path) / name).string();
  }
  if (files.size() > 1) {
    auto slices = std::make_unique<TiffSlices>(std::move(files), progress);
    checkHeader(slices->header(), path);
    return slices;
  }
  if (files.empty()) refuseInput(path, FindingKind::noSuchFileOrFolder);  // they were there a moment ago
  progress(0, files.front(), sizeOf(files.front()));
  return std::make_unique<TiffFile>(files.front());
}

}  // namespace handlebody
